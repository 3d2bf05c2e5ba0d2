// formats/picture/svg/theme.h: the colours of paper, lines and text in a picture.
#pragma once
#include <span>
#include <string_view>

#include "formats/picture/coloring.h"

namespace pliant {

/// What a picture looks like apart from the colours that stand for numbers.
struct Theme {
  std::string_view name;
  Rgb paper;
  Rgb ink;        ///< lines of the mesh
  Rgb other_ink;  ///< the same on colours against which `ink` is hardly seen
  Rgb text, faint;
  Rgb obstacle;
  double line;           ///< widths of lines are multiplied by this
  std::string_view map;  ///< the colour map where none is asked for
  bool grey;             ///< faces are told apart by greys
};

/// light, dark, print.
std::span<const Theme> themes();
/// The theme of this name, or null if there is none.
const Theme* find_theme(std::string_view name);

/// The colour of a face.
Rgb face_color(const Theme& theme, FaceId face);
/// How well one colour is seen on the other: from 1 (not at all) to 21 (black on white), as WCAG 2 defines it.
double contrast(const Rgb& a, const Rgb& b);

}  // namespace pliant

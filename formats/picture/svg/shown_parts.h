// formats/picture/svg/shown_parts.h: the parts of edges and elements that a picture shows.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "formats/picture/svg/drawing.h"

namespace pliant {

/// False if what has these control points, and lines along it, lie outside of what is shown.
bool is_shown(const Drawing& drawing, std::span<const Point> points);

/// True if what has these control points is drawn as it is: it is shown, and not so much larger than the picture that
/// viewers draw it wrongly or not at all.
bool is_drawn_whole(const Drawing& drawing, std::span<const Point> points);

/// Calls `use` with the parts of a Bézier curve of which something may be shown: the curve itself, or halves of halves
/// of it that are drawn whole. Halves of the 48th generation are drawn straight and are not halved: rounding has
/// moved their points by as much as they bend.
void for_shown_parts(const Drawing& drawing, const std::vector<Point>& polygon,
                     const std::function<void(const std::vector<Point>&)>& use);

/// An element, drawn by pieces.
class ElementPieces {
 public:
  /// The barycentric coordinates of a piece's corners in the element.
  using Corners = std::array<Barycentric, 3>;
  using Use = std::function<void(const Corners& corners, const std::vector<Point>& net)>;
  static constexpr Corners whole{Barycentric{1, 0, 0}, Barycentric{0, 1, 0}, Barycentric{0, 0, 1}};

  ElementPieces(const Drawing& drawing, TriangleId t);
  /// Calls `use` with the parts of a piece of which something may be shown: the piece itself, or quarters of quarters
  /// of it that are drawn whole, or straight ones of the 48th generation.
  void for_shown(const Corners& corners, const Use& use) { for_shown(corners, use, 0); }

 private:
  void for_shown(const Corners& corners, const Use& use, int generation);

  const Drawing& drawing_;
  std::vector<double> rows_, piece_rows_;  ///< x and y of the element's net, and of a piece's
};

}  // namespace pliant

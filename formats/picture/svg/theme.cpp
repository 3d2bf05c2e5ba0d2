// formats/picture/svg/theme.cpp: the colours of paper, lines and text in a picture.
#include "formats/picture/svg/theme.h"

#include <algorithm>
#include <array>

namespace pliant {
namespace {

constexpr Rgb white{1, 1, 1}, black{0, 0, 0};
constexpr std::array<Theme, 3> all{
    {{"light", white, rgb(0x14232e), white, rgb(0x3d4952), rgb(0x5c6770), {0.80, 0.82, 0.85}, 1, "viridis", false},
     {"dark", rgb(0x12181d), rgb(0xe6ecf0), rgb(0x0b1014), rgb(0xc9d1d8), rgb(0x8b97a1), rgb(0x3a454e), 1, "viridis",
      false},
     {"print", white, black, white, black, black, rgb(0xdddddd), 0.6, "grey", true}}};
// Neighbours in this list differ enough to be told apart on paper, and all are lighter than lines.
constexpr std::array greys{rgb(0xe6e6e6), rgb(0xb4b4b4), rgb(0xd0d0d0), rgb(0x999999), rgb(0xf7f7f7), rgb(0xc2c2c2)};

double luminance(const Rgb& color) {
  const Rgb light = linear_light(color);
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

}  // namespace

std::span<const Theme> themes() { return all; }

const Theme* find_theme(std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [name](const Theme& theme) { return theme.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Rgb face_color(const Theme& theme, FaceId face) {
  return theme.grey ? greys[static_cast<std::size_t>(std::max(face, 0)) % greys.size()] : face_color(face);
}

double contrast(const Rgb& a, const Rgb& b) {
  constexpr double flare = 0.05;
  const double light_a = luminance(a), light_b = luminance(b);
  return (std::max(light_a, light_b) + flare) / (std::min(light_a, light_b) + flare);
}

}  // namespace pliant

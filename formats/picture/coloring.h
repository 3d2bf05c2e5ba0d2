// formats/picture/coloring.h: what pictures of a mesh are coloured by: a metric, a field or the faces.
#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// A colour: red, green, blue in sRGB, each in [0, 1].
using Rgb = std::array<double, 3>;
/// From 0xRRGGBB.
constexpr Rgb rgb(unsigned code) {
  return {double(code >> 16 & 255) / 255, double(code >> 8 & 255) / 255, double(code & 255) / 255};
}

/// The colour as "#rrggbb".
std::string hex(const Rgb& color);
/// The same colour in linear light, as glTF wants it.
Rgb linear_light(const Rgb& color);
/// Colours of faces: a fixed list, repeated from its start.
Rgb face_color(FaceId face);

/// A map from [0, 1] to colours, piecewise linear in sRGB between equally spaced stops.
struct Colormap {
  std::string_view name;
  std::span<const Rgb> stops;
  /// The colour at s, which is first limited to [0, 1].
  Rgb at(double s) const;
};
/// The names of the maps: viridis, magma, plasma, blue-red, grey.
std::span<const Colormap> colormaps();
/// The map of this name, or null if there is none.
const Colormap* find_colormap(std::string_view name);

struct ValueRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void extend(double value);  ///< by a value, unless it is not finite
  bool is_empty() const { return !(low <= high); }
  /// Where the value lies: 0 at low, 1 at high, one half everywhere if they are equal.
  double place(double value) const;
};

/// What colours the elements.
struct ColorBy {
  enum class Kind { nothing, face, metric, field };
  Kind kind = Kind::metric;
  std::string name = "shape";  ///< of the metric or field
};
/// Reads "none", "face", "field:NAME[.COMPONENT]" or the name of a metric.
/// Throws      std::invalid_argument, with the names that are known
ColorBy parse_color_by(const std::string& text);

/// The numbers that colour a mesh: one for each element (a metric, at its worst in the element), or a function on each
/// element (a field: one component counted from 0, or the Euclidean length of several).
class ElementValues {
 public:
  /// Keeps a reference to the mesh.
  /// Throws      std::invalid_argument where the mesh has no such field or component; the text names those it has
  ElementValues(const MeshData& mesh, const ColorBy& by);

  bool exist() const { return is_field() || !flat_.empty(); }
  bool is_field() const { return field_ != nullptr; }
  /// True if a control point may have different values on different faces.
  bool depends_on_face() const { return field_ != nullptr && field_->by_face; }
  /// The element's number; NaN if it has none (the distortion of an element without area).
  double of_element(TriangleId t) const { return flat_[static_cast<std::size_t>(t)]; }
  /// The function's value at a point of the element; for a metric the element's number.
  double at(TriangleId t, const Barycentric& xi) const;
  /// The field, and its component: none if all count together as the length of a vector.   Requires    is_field()
  const Field& field() const { return *field_; }
  std::optional<int> component() const { return component_ < 0 ? std::nullopt : std::optional(component_); }
  /// The field's control values on the element, all components of each.   Requires    is_field()
  void control_values(TriangleId t, std::vector<double>& rows) const;
  /// How far the function is from the linear function of the plane that agrees with it at the element's corners: the
  /// greatest difference at the edges' midpoints and the middle.
  double departure(TriangleId t) const;
  /// The difference of the greatest and the least value at the element's corners and edge midpoints.
  double spread(TriangleId t) const;
  /// The range over all elements but those of `without` (in ascending order). It is exact for metrics, and that of the
  /// values on a lattice of each element for fields. Callers leave out elements that are not valid, whose numbers would
  /// make the others indistinguishable.
  ValueRange range(std::span<const TriangleId> without = {}) const;
  /// The title of a legend, such as "least shape of the element" or "field u, component 1".
  const std::string& title() const { return title_; }

 private:
  double row_value(std::span<const double> row) const;

  const MeshData& mesh_;
  std::vector<double> flat_;
  const Field* field_ = nullptr;
  int component_ = -1;  // -1: all of them
  std::string title_;
};

/// Round numbers, about `count` of them, within the range, for the ticks of a legend.
std::vector<double> ticks(const ValueRange& range, int count);

/// A disk that is drawn with the mesh: an obstacle.
struct Circle {
  Point center;
  double radius;
};
inline const Rgb invalid_color{1, 0, 0.62};
inline const Rgb degenerate_color{1, 0.55, 0};
inline const Rgb missing_color{0.72, 0.72, 0.72};
inline const Rgb obstacle_color{0.80, 0.82, 0.85};

}  // namespace pliant

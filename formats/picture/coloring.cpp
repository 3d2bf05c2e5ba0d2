// formats/picture/coloring.cpp: what pictures of a mesh are coloured by: a metric, a field or the faces.
#include "formats/picture/coloring.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "formats/picture/mesh_edges.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/quality/metrics.h"

namespace pliant {
namespace {

constexpr std::array viridis{rgb(0x440154), rgb(0x482878), rgb(0x3e4989), rgb(0x31688e), rgb(0x26828e),
                             rgb(0x1f9e89), rgb(0x35b779), rgb(0x6ece58), rgb(0xb5de2b), rgb(0xfde725)};
constexpr std::array magma{rgb(0x000004), rgb(0x180f3d), rgb(0x440f76), rgb(0x721f81), rgb(0x9e2f7f),
                           rgb(0xcd4071), rgb(0xf1605d), rgb(0xfd9668), rgb(0xfeca8d), rgb(0xfcfdbf)};
constexpr std::array plasma{rgb(0x0d0887), rgb(0x46039f), rgb(0x7201a8), rgb(0x9c179e), rgb(0xbd3786),
                            rgb(0xd8576b), rgb(0xed7953), rgb(0xfb9f3a), rgb(0xfdca26), rgb(0xf0f921)};
constexpr std::array blue_red{rgb(0x2a4a94), rgb(0x5f8ac4), rgb(0xaccbe3), rgb(0xf2f0eb),
                              rgb(0xeebc9f), rgb(0xd0705a), rgb(0x97252f)};
// From light to dark, so that a print in one ink shows the order; it ends well before black, which lines are drawn in.
constexpr std::array grey{rgb(0xf5f5f5), rgb(0x4a4a4a)};
constexpr std::array<Colormap, 5> maps{
    {{"viridis", viridis}, {"magma", magma}, {"plasma", plasma}, {"blue-red", blue_red}, {"grey", grey}}};
constexpr std::array faces{rgb(0x5b8ec9), rgb(0xe58a5c), rgb(0x6fb58a), rgb(0xc76b84), rgb(0x8d7cc0),
                           rgb(0xd9b650), rgb(0x5fb3bd), rgb(0xa88468), rgb(0xd391bd), rgb(0x9aa3ad)};

/// The component that "NAME.K" asks for, if the part after the last dot is a number.
std::optional<int> component_of(std::string_view text, std::size_t dot) {
  int component = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + dot + 1, last, component);
  if (error != std::errc() || end != last || component < 0) return {};
  return component;
}

}  // namespace

std::string hex(const Rgb& color) {
  std::string text = "#";
  for (const double part : color) {
    const int value = static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
    text += "0123456789abcdef"[value / 16];
    text += "0123456789abcdef"[value % 16];
  }
  return text;
}

Rgb linear_light(const Rgb& color) {
  Rgb result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = color[i] <= 0.04045 ? color[i] / 12.92 : std::pow((color[i] + 0.055) / 1.055, 2.4);
  return result;
}

Rgb face_color(FaceId face) { return faces[static_cast<std::size_t>(std::max(face, 0)) % faces.size()]; }

Rgb Colormap::at(double s) const {
  const double place = std::clamp(s, 0.0, 1.0) * double(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = std::lerp(stops[i][c], stops[i + 1][c], place - double(i));
  return color;
}

std::span<const Colormap> colormaps() { return maps; }

const Colormap* find_colormap(std::string_view name) {
  const auto found = std::find_if(maps.begin(), maps.end(), [name](const Colormap& map) { return map.name == name; });
  return found == maps.end() ? nullptr : &*found;
}

void ValueRange::extend(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

double ValueRange::place(double value) const {
  // Halved: the difference of two doubles may overflow, that of their halves does not.
  return low < high ? (value / 2 - low / 2) / (high / 2 - low / 2) : 0.5;
}

ColorBy parse_color_by(const std::string& text) {
  if (text == "none") return {ColorBy::Kind::nothing, {}};
  if (text == "face") return {ColorBy::Kind::face, {}};
  if (text.starts_with("field:")) return {ColorBy::Kind::field, text.substr(6)};
  if (find_report_metric(text) != nullptr) return {ColorBy::Kind::metric, text};
  throw std::invalid_argument("'" + text + "' is nothing to colour by; there are none, face, field:NAME[.COMPONENT], " +
                              std::string(metric_list()));
}

ElementValues::ElementValues(const MeshData& mesh, const ColorBy& by) : mesh_(mesh) {
  if (by.kind == ColorBy::Kind::metric) {
    const Metric* metric = find_metric(by.name);
    title_ = metric->title;
    flat_ = element_values(mesh, *metric);
    return;
  }
  if (by.kind != ColorBy::Kind::field) return;
  std::string known;
  for (const Field& field : mesh.fields) {
    if (field.name == by.name) field_ = &field;
    known += (known.empty() ? "" : ", ") + field.name;
  }
  // A field's own name may hold a dot, so the whole text is tried first.
  const std::size_t dot = by.name.rfind('.');
  if (field_ == nullptr && dot != std::string::npos)
    if (const std::optional<int> component = component_of(by.name, dot))
      for (const Field& field : mesh.fields)
        if (field.name == by.name.substr(0, dot)) field_ = &field, component_ = *component;
  if (field_ == nullptr)
    throw std::invalid_argument("the mesh has no field '" + by.name + "'; " +
                                (known.empty() ? "it has none" : "it has " + known));
  if (component_ >= field_->components)
    throw std::invalid_argument("field '" + field_->name + "' has no component " + std::to_string(component_) +
                                "; they are counted from 0 to " + std::to_string(field_->components - 1));
  title_ = field_->name;
  if (component_ >= 0) title_ += ", component " + std::to_string(component_);
  if (component_ < 0 && field_->components > 1) title_ = "|" + title_ + "|";
  title_ = "field " + title_;
  if (field_->components == 1) component_ = 0;
}

void ElementValues::control_values(TriangleId t, std::vector<double>& rows) const {
  const auto width = static_cast<std::size_t>(field_->components);
  const std::span<const PointId> net = element_points(mesh_, t);
  rows.clear();
  rows.reserve(net.size() * width);
  for (const PointId p : net) {
    std::size_t row = static_cast<std::size_t>(p);
    if (field_->by_face) {
      const std::array<std::int32_t, 2> place{p, mesh_.triangle_faces[static_cast<std::size_t>(t)]};
      row = static_cast<std::size_t>(std::lower_bound(field_->places.begin(), field_->places.end(), place) -
                                     field_->places.begin());
    }
    const auto first = field_->values.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), first, first + field_->components);
  }
}

double ElementValues::at(TriangleId t, const Barycentric& xi) const {
  if (field_ == nullptr) return of_element(t);
  std::vector<double> rows, value(static_cast<std::size_t>(field_->components));
  control_values(t, rows);
  evaluate_net(mesh_.degree, field_->components, rows, xi, value);
  return row_value(value);
}

double ElementValues::row_value(std::span<const double> row) const {
  if (component_ >= 0) return row[static_cast<std::size_t>(component_)];
  double length = 0;
  for (const double part : row) length = std::hypot(length, part);
  return length;
}

double ElementValues::departure(TriangleId t) const {
  if (field_ == nullptr) return 0;
  std::vector<double> net;
  for (const PointId p : element_points(mesh_, t)) {
    const Point& position = mesh_.points[static_cast<std::size_t>(p)];
    net.insert(net.end(), {position.x, position.y});
  }
  const std::array<Point, 3> corner{{{net[0], net[1]}, {net[2], net[3]}, {net[4], net[5]}}};
  const std::array<double, 3> value{at(t, {1, 0, 0}), at(t, {0, 1, 0}), at(t, {0, 0, 1})};
  constexpr double third = 1.0 / 3;
  double most = 0;
  for (const Barycentric& xi : {Barycentric{0.5, 0.5, 0}, Barycentric{0, 0.5, 0.5}, Barycentric{0.5, 0, 0.5},
                                Barycentric{third, third, third}}) {
    std::array<double, 2> place{};
    evaluate_net(mesh_.degree, 2, net, xi, place);
    const Barycentric b = barycentric(corner[0], corner[1], corner[2], {place[0], place[1]});
    const double away = std::abs(at(t, xi) - (b[0] * value[0] + b[1] * value[1] + b[2] * value[2]));
    // On an element whose corners are on a line there is no such plane: its own values say how much it varies.
    most = std::max(most, std::isfinite(away) ? away : std::abs(at(t, xi) - value[0]));
  }
  return most;
}

double ElementValues::spread(TriangleId t) const {
  if (field_ == nullptr) return 0;
  ValueRange range;
  for (const Barycentric& xi : {Barycentric{1, 0, 0}, Barycentric{0, 1, 0}, Barycentric{0, 0, 1},
                                Barycentric{0.5, 0.5, 0}, Barycentric{0, 0.5, 0.5}, Barycentric{0.5, 0, 0.5}})
    range.extend(at(t, xi));
  return range.is_empty() ? 0 : range.high - range.low;
}

ValueRange ElementValues::range(std::span<const TriangleId> without) const {
  ValueRange range;
  if (!exist()) return range;
  const int n = field_ == nullptr ? 0 : mesh_.degree == 1 ? 1 : 4;
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh_.triangle_faces.size()); ++t) {
    if (std::binary_search(without.begin(), without.end(), t)) continue;
    if (n == 0) range.extend(of_element(t));
    for (int i = 0; n > 0 && i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) range.extend(at(t, {double(i) / n, double(j) / n, double(n - i - j) / n}));
  }
  return range;
}

std::vector<double> ticks(const ValueRange& range, int count) {
  if (range.is_empty()) return {};
  if (range.low == range.high) return {range.low};
  const double rough = (range.high / count - range.low / count);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double nice : {1.0, 2.0, 5.0})
    if (nice * power >= rough * 0.999) {
      step = nice * power;
      break;
    }
  std::vector<double> result;
  // A range that is a few units in the last place wide has no round numbers: both ends then. Beyond 2^53 steps from
  // zero, ++k would not change k.
  constexpr double most_steps = 0x1p50;
  if (!(step > 0) || !(std::max(std::abs(range.low), std::abs(range.high)) / step < most_steps))
    return {range.low, range.high};
  for (double k = std::ceil(range.low / step - 1e-9); k * step <= range.high + 1e-9 * step; ++k)
    result.push_back(k * step);
  return result;
}

}  // namespace pliant

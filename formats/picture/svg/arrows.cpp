// formats/picture/svg/arrows.cpp: the layer of a vector field's arrows.
#include "formats/picture/svg/arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "formats/picture/isolines/sign_changes.h"
#include "formats/picture/svg/text.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/invert_map.h"

namespace pliant {
namespace {

constexpr double longest_key = 40;                   // in pixels
constexpr double longest = 0.92;                     // of the distance of the grid's points, so that arrows do not meet
constexpr double shaft_width = 1.3, shortest = 0.8;  // in pixels; what is shorter is drawn as a dot

struct Sample {
  Point at;
  Vector value;
};

std::string field_fault(const MeshData& mesh, const std::string& name) {
  std::string known;
  for (const Field& field : mesh.fields)
    if (field.components == 2) known += (known.empty() ? "" : ", ") + field.name;
  return "--arrows: the mesh has no field '" + name + "' of two components; " +
         (known.empty() ? "it has none of that kind" : "it has " + known);
}

/// The values at the points of a square grid over the box that are in the mesh.
std::vector<Sample> sample_grid(const Drawing& drawing, const ElementValues& values, double spacing) {
  const Box& box = drawing.box;
  // An odd number in each direction: a mesh that is thinner than the spacing has the middle row.
  const auto count = [spacing](double side) {
    const int n = std::max(1, static_cast<int>(std::floor(side / spacing + 1e-9)));
    return n % 2 == 1 ? n : n - 1;
  };
  const int columns = count(box.high.x - box.low.x), rows = count(box.high.y - box.low.y);
  const Point first = 0.5 * (box.low + box.high) - 0.5 * spacing * Point{double(columns - 1), double(rows - 1)};
  std::vector<std::optional<Sample>> grid(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const double tolerance = bounding_box(drawing.mesh).tolerance();
  std::vector<double> control;
  for (TriangleId t = 0; t < drawing.triangles(); ++t) {
    const std::vector<Point> net = element_net(drawing.mesh, t);
    Box reach;
    for (const Point& p : net) reach.extend(p);
    const auto range = [spacing](double low, double high, double from, int n) {
      return std::pair(std::max(0, static_cast<int>(std::ceil(std::max(-1.0, (low - from) / spacing)))),
                       std::min(n - 1, static_cast<int>(std::floor(std::min(double(n), (high - from) / spacing)))));
    };
    const auto [left, right] = range(reach.low.x, reach.high.x, first.x, columns);
    const auto [bottom, top] = range(reach.low.y, reach.high.y, first.y, rows);
    for (int j = bottom; j <= top; ++j)
      for (int i = left; i <= right; ++i) {
        std::optional<Sample>& place = grid[static_cast<std::size_t>(j * columns + i)];
        if (place) continue;
        const Point p = first + spacing * Point{double(i), double(j)};
        const ElementSearch search = find_in_element(drawing.mesh.degree, net, p, tolerance);
        if (search.answer != SearchAnswer::found) continue;
        std::array<double, 2> value{};
        values.control_values(t, control);
        evaluate_net(drawing.mesh.degree, 2, control, search.xi, value);
        place = Sample{p, {value[0], value[1]}};
      }
  }
  std::vector<Sample> samples;
  for (const std::optional<Sample>& each : grid)
    if (each) samples.push_back(*each);
  return samples;
}

/// The outer edges of the mesh, which arrows must not cross.
class Walls {
 public:
  explicit Walls(const Drawing& drawing) {
    for (const MeshEdge& edge : drawing.edges.edges)
      if (edge.sides[1] == none) {
        walls_.push_back({{}, positions(drawing.mesh, edge.points)});
        for (const Point& p : walls_.back().polygon) walls_.back().box.extend(p);
      }
  }
  bool cross(const Point& a, const Point& b) const {
    Box box;
    box.extend(a), box.extend(b);
    return std::any_of(walls_.begin(), walls_.end(),
                       [&](const Wall& wall) { return wall.box.overlaps(box) && meets(wall, a, b); });
  }

 private:
  struct Wall {
    Box box;
    std::vector<Point> polygon;
  };
  static bool meets(const Wall& wall, const Point& a, const Point& b) {
    std::vector<double> beside, along;
    for (const Point& p : wall.polygon) {
      beside.push_back(pliant::cross(b - a, p - a));
      along.push_back(dot(b - a, p - a));
    }
    const std::vector<double> places = sign_changes(beside, beside.front() >= 0, beside.back() >= 0);
    return std::any_of(places.begin(), places.end(), [&](double s) {
      double at = 0;
      evaluate_polygon(static_cast<int>(along.size()) - 1, 1, along, s, {&at, 1});
      return at >= 0 && at <= squared_length(b - a);
    });
  }
  std::vector<Wall> walls_;
};

/// The length of a vector whose squares may be out of range.
double magnitude(const Vector& v) { return std::hypot(v.x, v.y); }

double round_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double nice : {5.0, 2.0})
    if (nice * power <= value) return nice * power;
  return power <= value && power > 0 ? power : value;
}

}  // namespace

void write_arrow(const Point& tail, const Point& tip, double width, SvgPath& path) {
  const double size = distance(tail, tip);
  const Vector along = (tip - tail) / size, across = perpendicular(along);
  const double head = std::min(6 * width, 0.5 * size), half_head = 0.4 * head, half = std::min(0.5 * width, 0.1 * size);
  const Point neck = tip - head * along;
  path.move_to(tail + half * across);
  for (const Point& p : {neck + half * across, neck + half_head * across, tip, neck - half_head * across,
                         neck - half * across, tail - half * across})
    path.text("L").point(p);
  path.text("Z");
}

Key draw_arrows(const Drawing& drawing, const ArrowRequest& request, std::string& out) {
  std::optional<ElementValues> values;
  try {
    values.emplace(drawing.mesh, ColorBy{ColorBy::Kind::field, request.field});
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument(field_fault(drawing.mesh, request.field));
  }
  if (values->component() || values->field().components != 2)
    throw std::invalid_argument(field_fault(drawing.mesh, request.field));
  const Box& box = drawing.box;
  const double spacing = std::max(box.high.x - box.low.x, box.high.y - box.low.y) / request.count;
  const std::vector<Sample> samples = sample_grid(drawing, *values, spacing);
  double most = 0;
  for (const Sample& sample : samples) most = std::max(most, magnitude(sample.value));

  out += "<g class=\"arrows\" fill=\"" + hex(drawing.theme.ink) + "\" stroke=\"" + hex(drawing.theme.other_ink) + "\"" +
         drawing.stroke_width(1.4) + " stroke-opacity=\"0.7\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
  SvgPath path = drawing.path(out);
  const Walls walls(drawing);
  const double pixel = drawing.pixel;
  for (const Sample& sample : samples) {
    const Vector arrow = most > 0 ? longest * spacing * (sample.value / most) : Vector{};
    // The arrow is about its point; where that would leave the mesh, it begins or ends there.
    std::optional<Point> tail;
    if (length(arrow) >= shortest * pixel)
      for (const double before : {0.5, 0.0, 1.0})
        if (const Point from = sample.at - before * arrow; !tail && !walls.cross(from, from + arrow)) tail = from;
    if (!tail && length(arrow) >= shortest * pixel) continue;
    path.text("<path d=\"");
    if (tail)
      write_arrow(*tail, *tail + arrow, shaft_width * pixel, path);
    else
      for (const int side : {-1, 1})  // a small disk
        path.text(side < 0 ? "M" : "A" + short_number(0.7 * pixel) + " " + short_number(0.7 * pixel) + " 0 1 0 ")
            .point(sample.at + Vector{side * 0.7 * pixel, 0})
            .text(side < 0 ? "" : "Z");
    const Point at = drawing.placement.in_document(sample.at);
    path.text("\"><title>").text(escape_xml(request.field)).text("(" + exact_number(at.x));
    path.text(", " + exact_number(at.y) + ") = (" + exact_number(sample.value.x));
    path.text(", " + exact_number(sample.value.y) + ")</title></path>\n");
  }
  path.text("</g>\n");
  if (most == 0)
    return {Key::Sign::arrow, 0,
            samples.empty() ? request.field + ": no point of the grid is in the mesh" : "|" + request.field + "| = 0"};
  const double pixels = longest * spacing / pixel;  // of the longest arrow
  const double shown = round_below(most * std::min(1.0, longest_key / pixels));
  return {Key::Sign::arrow, pixels * (shown / most), "|" + request.field + "| = " + short_number(shown)};
}

}  // namespace pliant

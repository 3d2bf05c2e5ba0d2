// formats/picture/svg/shown_parts.cpp: the parts of edges and elements that a picture shows.
#include "formats/picture/svg/shown_parts.h"

#include "formats/picture/mesh_edges.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr double widest_line = 10;    // in pixels
constexpr double most_pictures = 64;  // how many pictures wide a part may be: renderers compute with 24 bits or fewer
constexpr int last_generation = 48;   // of halves: doubles have 53 bits

Box hull_of(std::span<const Point> points) {
  Box hull;
  for (const Point& p : points) hull.extend(p);
  return hull;
}

bool overlaps(const Drawing& drawing, const Box& hull) {
  const Vector reach = widest_line * drawing.pixel * Vector{1, 1};
  return hull.overlaps({drawing.box.low - reach, drawing.box.high + reach});
}

bool is_too_large(const Drawing& drawing, const Box& hull) { return hull.size() > most_pictures * drawing.box.size(); }

Barycentric middle(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

std::vector<Point> points_of(const std::vector<double>& rows) {
  std::vector<Point> points;
  points.reserve(rows.size() / 2);
  for (std::size_t i = 0; i < rows.size(); i += 2) points.push_back({rows[i], rows[i + 1]});
  return points;
}

/// The straight curve between the ends.
std::vector<Point> straight(std::vector<Point> polygon) {
  const Point from = polygon.front(), to = polygon.back();
  const double last = double(polygon.size()) - 1;
  for (std::size_t k = 0; k < polygon.size(); ++k) polygon[k] = from + double(k) / last * (to - from);
  return polygon;
}

/// The straight triangle between the corners.
std::vector<Point> straight_net(int degree, std::vector<Point> net) {
  const NetLayout& layout = NetLayout::of(degree);
  const Point a = net[0], b = net[1], c = net[2];
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    net[static_cast<std::size_t>(n)] = a + (double(j) * (b - a) + double(k) * (c - a)) / degree;
  }
  return net;
}

void for_shown_parts(const Drawing& drawing, const std::vector<Point>& polygon,
                     const std::function<void(const std::vector<Point>&)>& use, int generation) {
  const Box hull = hull_of(polygon);
  if (!overlaps(drawing, hull)) return;
  if (!is_too_large(drawing, hull)) return use(polygon);
  if (generation == last_generation) return use(straight(polygon));
  const std::vector<double> rows = rows_of(polygon);
  std::vector<double> left(rows.size()), right(rows.size());
  split_polygon(static_cast<int>(polygon.size()) - 1, 2, rows, 0.5, left, right);
  for (const std::vector<double>& half : {left, right}) for_shown_parts(drawing, points_of(half), use, generation + 1);
}

}  // namespace

bool is_shown(const Drawing& drawing, std::span<const Point> points) { return overlaps(drawing, hull_of(points)); }

bool is_drawn_whole(const Drawing& drawing, std::span<const Point> points) {
  const Box hull = hull_of(points);
  return overlaps(drawing, hull) && !is_too_large(drawing, hull);
}

void for_shown_parts(const Drawing& drawing, const std::vector<Point>& polygon,
                     const std::function<void(const std::vector<Point>&)>& use) {
  for_shown_parts(drawing, polygon, use, 0);
}

ElementPieces::ElementPieces(const Drawing& drawing, TriangleId t)
    : drawing_(drawing), rows_(rows_of(element_net(drawing.mesh, t))), piece_rows_(rows_.size()) {}

void ElementPieces::for_shown(const Corners& corners, const Use& use, int generation) {
  const auto& [a, b, c] = corners;
  sub_net(drawing_.mesh.degree, 2, rows_, a, b, c, piece_rows_);
  const std::vector<Point> net = points_of(piece_rows_);
  const Box hull = hull_of(net);
  if (!overlaps(drawing_, hull)) return;
  if (!is_too_large(drawing_, hull)) return use(corners, net);
  if (generation == last_generation) return use(corners, straight_net(drawing_.mesh.degree, net));
  const Barycentric ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
  for (const Corners& quarter : {Corners{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
    for_shown(quarter, use, generation + 1);
}

}  // namespace pliant

// lib/pliant/generate/lift_triangles.cpp: numbers and places the control points, then untangles elements (paper §6).
#include "pliant/generate/lift_triangles.h"

#include <algorithm>
#include <array>

#include "pliant/generate/tame_spans.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant {
namespace {

constexpr int most_sweeps = 3;  // sweeps over the elements without certificate
constexpr double way_beyond =
    0.25;  // a point goes on by this share of the way from the first valid place to the best one

}  // namespace

LiftedMesh::LiftedMesh(int degree, const BoundarySpans& spans, const PlanarMesh& planar)
    : degree_(degree), spans_(spans), planar_(planar) {
  number_points();
  place_points();
  find_cusps();
}

std::span<const int> LiftedMesh::net(int t) const {
  const auto size = index(net_size(degree_));
  return {nets_.data() + index(t) * size, size};
}

/// Corners keep their numbers. Then come the points inside edges, in the order in which edges first occur, then those
/// inside elements.
void LiftedMesh::number_points() {
  const NetLayout& layout = NetLayout::of(degree_);
  const std::size_t count = planar_.corners.size(), size = index(layout.size());
  nets_.assign(count * size, -1);
  int next_point = static_cast<int>(planar_.points.size());
  const int half_edges = static_cast<int>(planar_.twins.size());
  for (int h = 0; h < half_edges; ++h) {
    int* const own = nets_.data() + index(h / 3) * size;
    own[h % 3] = planar_.origin(h);
    const int g = planar_.twin(h);
    const bool is_first = g < 0 || g > h;
    for (int k = 1; k < degree_; ++k) {
      int& entry = own[layout.edge_index(h % 3, k)];
      entry = is_first ? next_point++ : nets_[index(g / 3) * size + index(layout.edge_index(g % 3, degree_ - k))];
    }
  }
  for (std::size_t t = 0; t < count; ++t)
    for (int n = layout.first_interior(); n < layout.size(); ++n) nets_[t * size + index(n)] = next_point++;
  points_ = planar_.points;
  points_.resize(index(next_point));
}

void LiftedMesh::place_points() {
  const NetLayout& layout = NetLayout::of(degree_);
  const int p = degree_, half_edges = static_cast<int>(planar_.twins.size());
  for (int h = 0; h < half_edges; ++h) {
    if (planar_.twin(h) > h) continue;  // each edge once
    const Point &a = points_[index(planar_.origin(h))], &b = points_[index(planar_.target(h))];
    const int s = planar_.span(h);
    const bool forward = s >= 0 && spans_[index(s)].from == planar_.origin(h);
    for (int k = 1; k < p; ++k) {
      Point& place = points_[index(net(h / 3)[index(layout.edge_index(h % 3, k))])];
      place = s < 0 ? ((p - k) * a + k * b) / p : spans_.polygon(index(s))[index(forward ? k : p - k)];
    }
  }
  const int count = static_cast<int>(planar_.corners.size());
  for (int t = 0; t < count; ++t) {
    const auto own = net(t);
    for (int n = layout.first_interior(); n < layout.size(); ++n) {
      const std::array<int, 3>& ijk = layout.exponents(n);
      Point place;
      for (int c = 0; c < 3; ++c) place += (double(ijk[index(c)]) / p) * points_[index(own[index(c)])];
      for (int e = 0; e < 3; ++e) {
        if (planar_.span(3 * t + e) < 0) continue;
        // Adds the displacement of the edge at the foot of this point. With the square of the weight, a quadratic edge
        // that was elevated gives a quadratic element that was elevated.
        const double from = ijk[index(e)], to = ijk[index((e + 1) % 3)], weight = (from + to) / p;
        const double foot = p * to / (from + to);
        const int k = std::min(static_cast<int>(foot), p - 1);
        const auto displacement = [&](int m) {
          return points_[index(own[index(layout.edge_index(e, m))])] -
                 ((p - m) * points_[index(own[index(e)])] + m * points_[index(own[index((e + 1) % 3)])]) / p;
        };
        place += weight * weight * ((k + 1 - foot) * displacement(k) + (foot - k) * displacement(k + 1));
      }
      points_[index(own[index(n)])] = place;
    }
  }
}

void LiftedMesh::find_cusps() {
  cusp_corner_.assign(planar_.corners.size(), -1);
  const int half_edges = static_cast<int>(planar_.twins.size());
  for (int h = 0; h < half_edges; ++h) {
    const int back = h % 3 == 0 ? h + 2 : h - 1, s = planar_.span(h), r = planar_.span(back);
    if (s < 0 || r < 0 || s == r) continue;
    const int node = planar_.origin(h);
    if (!is_cusp(tangent_at_end(spans_.polygon(index(s)), spans_[index(s)].from == node),
                 tangent_at_end(spans_.polygon(index(r)), spans_[index(r)].from == node)))
      continue;
    cusp_corner_[index(h / 3)] = h % 3;
    cusps_.push_back(node);
  }
  std::sort(cusps_.begin(), cusps_.end());
  cusps_.erase(std::unique(cusps_.begin(), cusps_.end()), cusps_.end());
}

bool LiftedMesh::is_valid(int t) const {
  std::array<Point, net_size(max_degree)> points;
  const auto own = net(t);
  for (std::size_t n = 0; n < own.size(); ++n) points[n] = points_[index(own[n])];
  const std::span<const Point> element(points.data(), own.size());
  const int corner = cusp_corner_[index(t)];
  return (corner < 0 ? certify(degree_, element) : certify_cusp(degree_, element, corner)) == Validity::valid;
}

/// A place for control point k of an element such that all elements that have the point, one or two, are valid.
std::optional<Point> LiftedMesh::valid_place(int t, int k) {
  const NetLayout& layout = NetLayout::of(degree_);
  Point& moving = points_[index(net(t)[index(k)])];
  std::array<int, 2> around{t, -1};
  if (k < layout.first_interior()) {
    const int e = (k - 3) / (degree_ - 1);
    if (planar_.span(3 * t + e) >= 0) return std::nullopt;
    around[1] = planar_.twin(3 * t + e) / 3;
  }
  std::array<std::array<Point, net_size(max_degree)>, 2> nets;
  std::vector<PlacementElement> elements;
  for (std::size_t i = 0; i < 2 && around[i] >= 0; ++i) {
    const auto own = net(around[i]);
    for (std::size_t n = 0; n < own.size(); ++n) nets[i][n] = points_[index(own[n])];
    const auto entry = std::find(own.begin(), own.end(), net(t)[index(k)]) - own.begin();
    elements.push_back({std::span<const Point>(nets[i].data(), own.size()), static_cast<int>(entry)});
  }
  const Point start = moving;
  const Placement best = untangle_point(degree_, elements, start);
  if (best.outcome != Placement::Outcome::placed) return std::nullopt;
  // The best place may be far away, and bend the edge more than needed. So look for the first valid place on the way.
  const auto is_valid_at = [&](double f) {
    moving = start + f * (best.place - start);
    return is_valid(t) && (around[1] < 0 || is_valid(around[1]));
  };
  double low = 0, high = 1;
  for (int i = 0; i < 10; ++i) {
    const double middle = (low + high) / 2;
    (is_valid_at(middle) ? high : low) = middle;
  }
  const Point place = is_valid_at(high + way_beyond * (1 - high)) ? moving : best.place;
  moving = start;
  return place;
}

/// Makes an element valid by moving the control point for which the shortest way suffices; false if there is none.
bool LiftedMesh::untangle_element(int t, double most_bending) {
  Box box;
  for (int c = 0; c < 3; ++c) box.extend(points_[index(net(t)[index(c)])]);
  double least = most_bending * box.size();
  int moving = -1;
  Point to;
  for (int k = 3; k < net_size(degree_); ++k) {
    const std::optional<Point> place = valid_place(t, k);
    if (!place) continue;
    const double way = distance(*place, points_[index(net(t)[index(k)])]);
    if (way >= least) continue;
    least = way;
    moving = net(t)[index(k)];
    to = *place;
  }
  if (moving < 0) return false;
  points_[index(moving)] = to;
  return true;
}

std::vector<int> LiftedMesh::untangle(double most_bending) {
  std::vector<int> waiting;
  const int count = static_cast<int>(planar_.corners.size());
  for (int t = 0; t < count; ++t)
    if (!is_valid(t)) waiting.push_back(t);
  for (int sweep = 0; sweep < most_sweeps && !waiting.empty(); ++sweep) {
    std::vector<int> left;
    for (const int t : waiting) {
      if (is_valid(t)) continue;
      if ((degree_ > 2 && bend_along_curves(t)) || untangle_element(t, most_bending))
        ++untangled_;
      else
        left.push_back(t);
    }
    if (left.size() == waiting.size()) break;
    waiting = std::move(left);
  }
  return waiting;
}

void LiftedMesh::write(MeshData& data) const {
  const NetLayout& layout = NetLayout::of(degree_);
  std::vector<int> number(points_.size(), -1);
  for (const int v : nets_) number[index(v)] = 0;
  data.points.clear();
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(data.points.size());
    data.points.push_back(points_[v]);
  }
  data.triangles.resize(nets_.size());
  for (std::size_t n = 0; n < nets_.size(); ++n) data.triangles[n] = number[index(nets_[n])];
  data.triangle_faces = planar_.faces;
  data.constrained_edges.assign(spans_.size(), {});
  const int half_edges = static_cast<int>(planar_.twins.size());
  for (int h = 0; h < half_edges; ++h) {
    const int s = planar_.span(h);
    if (s < 0) continue;
    ConstrainedEdge& edge = data.constrained_edges[index(s)];
    const BoundarySpan& span = spans_[index(s)];
    edge.curve = span.curve;
    edge.span = span.index;
    edge.points.resize(index(degree_) + 1);
    const bool forward = span.from == planar_.origin(h);
    for (int k = 0; k <= degree_; ++k)
      edge.points[index(forward ? k : degree_ - k)] = number[index(net(h / 3)[index(layout.edge_index(h % 3, k))])];
  }
}

}  // namespace pliant

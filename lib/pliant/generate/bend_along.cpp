// lib/pliant/generate/bend_along.cpp: bends whole thin elements as the curve beside them bends.
#include <algorithm>
#include <array>

#include "pliant/generate/lift_triangles.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr double most_short = 0.5;  // an element is thin if its third edge is at most this share of the two long ones

/// How far each of an edge's control points is off its straight place, from the edge's origin on.
using Bend = std::array<Vector, max_degree + 1>;

Bend mean(const Bend& a, const Bend& b) {
  Bend both;
  for (std::size_t k = 0; k < both.size(); ++k) both[k] = (a[k] + b[k]) / 2;
  return both;
}
Bend reversed(const Bend& a, int degree) {
  Bend back{};
  for (int k = 0; k <= degree; ++k) back[index(k)] = a[index(degree - k)];
  return back;
}

}  // namespace

/// Takes a thin element with two long edges: `long_edge`, and the one that meets it at its origin (`at_origin`) or at
/// its target. Returns the bend of that other edge, from the corner between the two on. Nothing where it lies on no
/// curve, or where the third edge is not short.
std::optional<std::array<Vector, max_degree + 1>> LiftedMesh::bend_beside(int t, int long_edge, bool at_origin) const {
  const int other = at_origin ? (long_edge + 2) % 3 : (long_edge + 1) % 3, third = 3 - long_edge - other;
  if (planar_.span(3 * t + other) < 0) return std::nullopt;
  const auto own = net(t);
  const auto edge_length = [&](int e) {
    return distance(points_[index(own[index(e)])], points_[index(own[index((e + 1) % 3)])]);
  };
  if (edge_length(third) > most_short * std::min(edge_length(long_edge), edge_length(other))) return std::nullopt;
  const NetLayout& layout = NetLayout::of(degree_);
  Bend bend{};
  const Point &a = points_[index(own[index(other)])], &b = points_[index(own[index((other + 1) % 3)])];
  for (int k = 1; k < degree_; ++k)
    bend[index(k)] = points_[index(own[index(layout.edge_index(other, k))])] - ((degree_ - k) * a + k * b) / degree_;
  return at_origin ? reversed(bend, degree_) : bend;
}

/// Gives the control points of an element that lie k steps from a corner the k-th displacement.
void LiftedMesh::bend_interior(int t, int corner, const std::array<Vector, max_degree + 1>& bend) {
  const NetLayout& layout = NetLayout::of(degree_);
  const auto own = net(t);
  for (int n = layout.first_interior(); n < layout.size(); ++n) {
    const std::array<int, 3>& ijk = layout.exponents(n);
    Point place;
    for (int c = 0; c < 3; ++c) place += (double(ijk[index(c)]) / degree_) * points_[index(own[index(c)])];
    points_[index(own[index(n)])] = place + bend[index(degree_ - ijk[index(corner)])];
  }
}

/// Bends the inside of an element at the tip of a wedge, both of whose long edges lie on curves. Kept where it becomes
/// valid.
bool LiftedMesh::bend_tip(int t) {
  for (int c = 0; c < 3; ++c) {
    // Edge c leaves corner c; the edge before it ends there.
    const auto leaving = bend_beside(t, (c + 2) % 3, false), arriving = bend_beside(t, c, true);
    if (!leaving || !arriving) continue;
    const NetLayout& layout = NetLayout::of(degree_);
    const auto own = net(t);
    std::array<Point, net_size(max_degree)> before;
    for (std::size_t n = 0; n < own.size(); ++n) before[n] = points_[index(own[n])];
    bend_interior(t, c, mean(*leaving, *arriving));
    if (is_valid(t)) return true;
    for (int n = layout.first_interior(); n < layout.size(); ++n) points_[index(own[index(n)])] = before[index(n)];
  }
  return false;
}

/// Bends an inner edge of an element, and the elements on both sides of it, as the curves beside them bend. Between two
/// curves that are closer to each other than they bend, no control point can be placed alone. Kept where the element
/// becomes valid, and the other one does not become invalid.
bool LiftedMesh::bend_along_curves(int t) {
  if (bend_tip(t)) return true;
  const NetLayout& layout = NetLayout::of(degree_);
  for (int e = 0; e < 3; ++e)
    for (const bool at_origin : {true, false}) {
      const int h = 3 * t + e, g = planar_.twin(h);
      if (planar_.span(h) >= 0 || g < 0) continue;
      const auto own_bend = bend_beside(t, e, at_origin);
      if (!own_bend) continue;
      // The element beyond may have a curve, too: at its twin edge's origin or target. Then the mean of both bends
      // counts.
      const int u = g / 3, f = g % 3;
      Bend along = at_origin ? *own_bend : reversed(*own_bend, degree_);
      for (const bool at_twins_origin : {true, false})
        if (const auto beyond = bend_beside(u, f, at_twins_origin)) {
          along = mean(along, at_twins_origin ? reversed(*beyond, degree_) : *beyond);
          break;
        }
      std::array<std::array<Point, net_size(max_degree)>, 2> before;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t n = 0; n < net(t).size(); ++n) before[i][n] = points_[index(net(i == 0 ? t : u)[n])];
      const bool was_valid = is_valid(u);
      const auto own = net(t);
      const Point a = points_[index(own[index(e)])], b = points_[index(own[index((e + 1) % 3)])];
      for (int k = 1; k < degree_; ++k)
        points_[index(own[index(layout.edge_index(e, k))])] = ((degree_ - k) * a + k * b) / degree_ + along[index(k)];
      bend_interior(t, at_origin ? e : (e + 1) % 3, at_origin ? along : reversed(along, degree_));
      for (const bool at_twins_origin : {true, false})
        if (bend_beside(u, f, at_twins_origin)) {
          bend_interior(u, at_twins_origin ? f : (f + 1) % 3, at_twins_origin ? reversed(along, degree_) : along);
          break;
        }
      if (is_valid(t) && (is_valid(u) || !was_valid)) return true;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t n = 0; n < net(t).size(); ++n) points_[index(net(i == 0 ? t : u)[n])] = before[i][n];
    }
  return false;
}

}  // namespace pliant

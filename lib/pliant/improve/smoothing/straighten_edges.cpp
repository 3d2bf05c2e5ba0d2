// lib/pliant/improve/smoothing/straighten_edges.cpp: sweeps over the edges that are not straight.
#include "pliant/improve/smoothing/straighten_edges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/ops/smooth_edge.h"

namespace pliant {
namespace {

constexpr int most_straightening_rounds = 4;

/// Is an edge straight up to rounding? Its control points are off by less than 1e-14 of its length, or by at most four
/// units in the last place of its coordinates.
bool is_straight(const Mesh& mesh, HalfEdgeId h) {
  constexpr double rounding = 1e-14, rounding_of_coordinate = 0x1p-50;
  const Point &a = mesh.point(mesh.origin(h)), &b = mesh.point(mesh.target(h));
  const double of_place = rounding_of_coordinate * std::max(std::fabs(a.x), std::fabs(a.y));
  const double off = std::max(rounding * rounding * squared_length(b - a), of_place * of_place);
  for (int k = 1; k < mesh.degree(); ++k) {
    const double w = static_cast<double>(k) / mesh.degree();
    if (squared_length(mesh.point(mesh.edge_point(h, k)) - ((1 - w) * a + w * b)) > off) return false;
  }
  return true;
}

}  // namespace

StraightenCounts straighten_edges(Mesh& mesh, const RefitOptions& options) {
  std::vector<HalfEdgeId> curved;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || mesh.is_constrained(h) || h > mesh.twin(h)) continue;
    if (!is_straight(mesh, h)) curved.push_back(h);
  }
  StraightenCounts counts;
  for (int round = 0; round < most_straightening_rounds && !curved.empty(); ++round) {
    std::vector<HalfEdgeId> left;
    for (const HalfEdgeId h : curved) {
      if (straighten_edge(mesh, h, 0, options) == Outcome::done)
        ++counts.straightened;
      else
        left.push_back(h);
    }
    if (left.size() == curved.size()) break;
    curved = std::move(left);
  }
  counts.left = static_cast<long>(curved.size());
  return counts;
}

}  // namespace pliant

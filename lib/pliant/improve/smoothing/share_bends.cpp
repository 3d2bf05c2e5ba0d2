// lib/pliant/improve/smoothing/share_bends.cpp: levels det J of elements on curves, then of what changed beside them.
#include "pliant/improve/smoothing/share_bends.h"

#include <algorithm>
#include <array>
#include <vector>

#include "pliant/ops/level_jacobian.h"
#include "pliant/quality/element/element_quality.h"

namespace pliant {
namespace {

constexpr double gain = 0.02;  // a change is kept if it closes this share of the gap between the scaled Jacobian and 1
constexpr int most_sharing_rounds = 6;

double scaled_jacobian_of(const Mesh& mesh, TriangleId t) {
  std::array<Point, net_size(max_degree)> net;
  mesh.gather_points(t, net);
  return scaled_jacobian(mesh.degree(), {net.data(), static_cast<std::size_t>(mesh.net_size())});
}

/// An element and those beyond its unconstrained edges.
struct Neighbourhood {
  std::array<TriangleId, 4> elements;
  std::size_t count = 1;

  Neighbourhood(const Mesh& mesh, TriangleId t) : elements{t} {
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (!mesh.is_constrained(h) && mesh.twin(h) != none) elements[count++] = triangle_of(mesh.twin(h));
    }
  }
  double least_scaled_jacobian(const Mesh& mesh) const {
    double least = 1;
    for (std::size_t k = 0; k < count; ++k) least = std::min(least, scaled_jacobian_of(mesh, elements[k]));
    return least;
  }
};

/// Levels det J of an element, altogether or in part; kept where the neighbourhood gains by it.
bool level(Mesh& mesh, const Neighbourhood& around, const RefitOptions& options) {
  const double before = around.least_scaled_jacobian(mesh);
  for (const double part : {1.0, 0.5, 0.25}) {
    Transaction attempt(mesh);
    if (level_jacobian(mesh, around.elements[0], part, options) != Outcome::done) continue;
    if (around.least_scaled_jacobian(mesh) < before + gain * (1 - before)) continue;
    attempt.commit();
    return true;
  }
  return false;
}

}  // namespace

ShareCounts share_bends(Mesh& mesh, double good, const RefitOptions& options) {
  ShareCounts counts;
  if (mesh.degree() < 2) return counts;
  std::vector<TriangleId> work, touched;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    bool is_on_curve = false;
    for (int e = 0; e < 3; ++e) is_on_curve = is_on_curve || mesh.is_constrained(half_edge(t, e));
    if (is_on_curve) work.push_back(t);
  }
  for (int round = 0; round < most_sharing_rounds && !work.empty(); ++round) {
    touched.clear();
    for (const TriangleId t : work) {
      if (scaled_jacobian_of(mesh, t) >= good) continue;
      ++counts.tried;
      const Neighbourhood around(mesh, t);
      if (!level(mesh, around, options)) continue;
      ++counts.levelled;
      touched.insert(touched.end(), around.elements.begin(),
                     around.elements.begin() + static_cast<std::ptrdiff_t>(around.count));
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    work.swap(touched);
  }
  return counts;
}

}  // namespace pliant

// lib/pliant/improve/smoothing/straighten_together.cpp: a cluster of bent edges, less those beside elements that would
// be invalid.
#include "pliant/improve/smoothing/straighten_together.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/trial_patch.h"

namespace pliant {
namespace {

constexpr std::size_t most_elements = 48;

/// Bent edges that hang together, and the elements beside them.
struct Cluster {
  std::vector<TriangleId> elements;
  std::vector<HalfEdgeId> edges;  ///< one half-edge of each
};

Cluster cluster_around(const Mesh& mesh, HalfEdgeId seed, bool (*is_bent)(const Mesh&, HalfEdgeId)) {
  Cluster cluster;
  const auto add_element = [&](TriangleId t) {
    if (std::find(cluster.elements.begin(), cluster.elements.end(), t) == cluster.elements.end())
      cluster.elements.push_back(t);
  };
  const auto add_edge = [&](HalfEdgeId h) {
    const HalfEdgeId g = mesh.twin(h);
    if (g == none || mesh.is_constrained(h)) return;
    const HalfEdgeId half = std::min(h, g);
    if (std::find(cluster.edges.begin(), cluster.edges.end(), half) != cluster.edges.end() || !is_bent(mesh, half))
      return;
    cluster.edges.push_back(half);
    add_element(triangle_of(h));
    add_element(triangle_of(g));
  };
  add_edge(seed);
  for (std::size_t k = 0; k < cluster.elements.size() && cluster.elements.size() < most_elements; ++k)
    for (int e = 0; e < 3; ++e) add_edge(half_edge(cluster.elements[k], e));
  return cluster;
}

}  // namespace

bool straighten_together(Mesh& mesh, HalfEdgeId seed, bool (*is_bent)(const Mesh& mesh, HalfEdgeId h),
                         const RefitOptions& refit) {
  Cluster cluster = cluster_around(mesh, seed, is_bent);
  thread_local TrialPatch trial;
  while (!cluster.edges.empty()) {
    trial.capture(mesh, cluster.elements);
    for (const HalfEdgeId h : cluster.edges) trial.straighten(mesh, h, 0);
    std::vector<TriangleId> invalid;
    for (std::size_t e = 0; e < trial.count(); ++e)
      if (certify_element(mesh.boundary(), mesh.degree(), trial.net(e)) != Validity::valid)
        invalid.push_back(trial.element(e));
    if (invalid.empty()) return trial.apply(mesh, refit, true) == Outcome::done;
    const auto is_invalid = [&invalid](TriangleId t) {
      return std::find(invalid.begin(), invalid.end(), t) != invalid.end();
    };
    const auto removed = std::erase_if(cluster.edges, [&](HalfEdgeId h) {
      return is_invalid(triangle_of(h)) || is_invalid(triangle_of(mesh.twin(h)));
    });
    if (removed == 0) return false;
    cluster.elements.clear();
    for (const HalfEdgeId h : cluster.edges)
      for (const TriangleId t : {triangle_of(h), triangle_of(mesh.twin(h))})
        if (std::find(cluster.elements.begin(), cluster.elements.end(), t) == cluster.elements.end())
          cluster.elements.push_back(t);
  }
  return false;
}

}  // namespace pliant

#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>
#include <map>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/legalize.h"

namespace pliant {

namespace {

bool is_positive(const Mesh& mesh, TriangleId t) {
  return orient2d(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2))) > 0;
}

/// Neighbours lie anywhere in memory, so what comes next is asked for early: nets, then the points they name.
void fetch_for([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] TriangleId t) {
#ifdef __GNUC__
  constexpr TriangleId far = 32, near = 16;
  const TriangleId end = mesh.triangle_slots();
  for (int e = 0; e < 3 && t + far < end && mesh.is_alive(t + far); ++e) {
    const HalfEdgeId g = mesh.twin(half_edge(t + far, e));
    if (g != none && g < half_edge(t + far, e)) __builtin_prefetch(mesh.net(triangle_of(g)).data());
  }
  for (int e = 0; e < 3 && t + near < end && mesh.is_alive(t + near); ++e) {
    const HalfEdgeId g = mesh.twin(half_edge(t + near, e));
    __builtin_prefetch(&mesh.point(mesh.corner(t + near, e)));
    if (g != none && g < half_edge(t + near, e)) __builtin_prefetch(&mesh.point(mesh.apex(g)));
  }
#endif
}

/// Calls `use` with every inner edge that is on no curve, once, and its state.
template <class Use>
void for_each_state(const Mesh& mesh, const Use& use) {
  std::vector<bool> positive(static_cast<std::size_t>(mesh.triangle_slots()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    fetch_for(mesh, t);
    if (!mesh.is_alive(t)) continue;
    const bool is_t_positive = is_positive(mesh, t);
    positive[static_cast<std::size_t>(t)] = is_t_positive;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh.twin(h);
      if (g == none || g > h || mesh.is_constrained(h)) continue;
      use(h, edge_state(mesh, h, is_t_positive, positive[static_cast<std::size_t>(triangle_of(g))]));
    }
  }
}

struct Census {
  long not_delaunay = 0, inverted = 0;
  std::vector<HalfEdgeId> wanted;  ///< edges that want their flip
};

Census take_census(const Mesh& mesh) {
  Census census;
  for_each_state(mesh, [&census](HalfEdgeId h, EdgeState state) {
    if (state == EdgeState::not_delaunay) ++census.not_delaunay;
    if (state == EdgeState::inverted || state == EdgeState::turned_over) ++census.inverted;
    if (wants_flip(state)) census.wanted.push_back(h);
  });
  return census;
}

Point middle_of(const Mesh& mesh, HalfEdgeId h) {
  const auto n = static_cast<std::size_t>(mesh.degree() + 1);
  std::vector<double> basis(n);
  bernstein_basis(mesh.degree(), 0.5, basis);
  Point middle;
  for (std::size_t k = 0; k < n; ++k) middle += basis[k] * mesh.point(mesh.edge_point(h, static_cast<int>(k)));
  return middle;
}

/// Of the edges that still want their flip, those that did not get it; why and where.
void list_refused(const Mesh& mesh, const std::vector<HalfEdgeId>& wanted, const std::vector<RefusedEdge>& refused,
                  PassReport& report) {
  std::map<std::pair<PointId, PointId>, Refusal> last;
  for (const RefusedEdge& edge : refused) last[std::minmax(edge.origin, edge.target)] = edge.reason;
  for (const HalfEdgeId h : wanted) {
    const PointId from = mesh.origin(h), to = mesh.target(h);
    const Refusal reason = last.at(std::minmax(from, to));
    if (reason != Refusal::done) report.refuse(describe(reason), middle_of(mesh, h));
  }
}

}  // namespace

PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options) {
  Census census = take_census(mesh);
  std::vector<HalfEdgeId> stack(census.wanted.rbegin(), census.wanted.rend());  // the first is tried first
  LegalizeCounts counts;
  counts.lists_edges = true;
  legalize(mesh, stack, options.refit, counts, options.max_flips);
  if (counts.flips > 0) census = take_census(mesh);
  PassReport report;
  report.add("flips", static_cast<double>(counts.flips));
  report.add("not_delaunay", static_cast<double>(census.not_delaunay));
  report.add("logically_inverted", static_cast<double>(census.inverted));
  report.add("triangles", mesh.triangle_count());
  list_refused(mesh, census.wanted, counts.refused_edges, report);
  mesh.compact();
  return report;
}

}  // namespace pliant

// lib/pliant/improve/enforce_delaunay.cpp: finds the edges that want a flip by a quick test, then by the exact one.
#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "pliant/geometry/bernstein.h"
#include "pliant/improve/legalize.h"

namespace pliant {

namespace {

/// Asks early for the memory that triangles a little further on will need, since their neighbours lie anywhere.
void fetch_for([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] TriangleId t,
               [[maybe_unused]] const std::vector<float>& cotangents) {
#ifdef __GNUC__
  constexpr TriangleId near = 16;
  if (t + near >= mesh.triangle_slots() || !mesh.is_alive(t + near)) return;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t + near, e);
    __builtin_prefetch(&mesh.point(mesh.origin(h)));
    if (mesh.twin(h) != none) __builtin_prefetch(&cotangents[index(mesh.twin(h))]);
  }
#endif
}

/// Lower bounds of the cotangents of the angles opposite the three edges of a logical triangle; minus infinity where
/// the triangle is not certain to be positive. The error bounds are several times Shewchuk's, plus what underflow may
/// add.
std::array<float, 3> least_cotangents(const Mesh& mesh, TriangleId t) {
  constexpr double relative = 4e-15, absolute = 1e-300;
  constexpr float least = -std::numeric_limits<float>::infinity(), rounding = 2e-7f;
  const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
              &c = mesh.point(mesh.corner(t, 2));
  const Vector ab = b - a, bc = c - b, ca = a - c;
  const double left = ab.x * bc.y, right = ab.y * bc.x, twice_area = left - right;
  const double error = relative * (std::fabs(left) + std::fabs(right)) + absolute;
  if (!(twice_area > error)) return {least, least, least};
  const auto between = [&](const Vector& u, const Vector& v) {
    const double x = u.x * v.x, y = u.y * v.y;
    const double cosine = -(x + y) - relative * (std::fabs(x) + std::fabs(y)) - absolute;
    const double quotient = cosine / (twice_area + (cosine > 0 ? error : -error));
    if (!(quotient > -1e30)) return least;
    const auto cotangent = static_cast<float>(std::min(quotient, 1e30));
    return cotangent - rounding * std::fabs(cotangent);
  };
  return {between(bc, ca), between(ca, ab), between(ab, bc)};
}

/// Calls `use` once for every edge that is on no curve and not certain to be Delaunay, with its state. An edge is
/// Delaunay where the two angles opposite it add up to less than 180 degrees, that is where the sum of their cotangents
/// is positive. So the points of each triangle are read once, and a single number of each neighbour.
template <class Use>
void for_each_doubtful(const Mesh& mesh, const Use& use) {
  constexpr float positive = 1e-30f;  // a sum above this is surely positive: it is well above what underflow may add
  std::vector<float> cotangents(3 * static_cast<std::size_t>(mesh.triangle_slots()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    fetch_for(mesh, t, cotangents);
    if (!mesh.is_alive(t)) continue;
    const std::array<float, 3> opposite = least_cotangents(mesh, t);
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh.twin(h);
      const float cotangent = cotangents[index(h)] = opposite[static_cast<std::size_t>(e)];
      if (g == none || g > h || mesh.is_constrained(h)) continue;
      if (cotangent + cotangents[index(g)] > positive) continue;
      use(h, edge_state(mesh, h));
    }
  }
}

/// The edges that are not Delaunay.
struct Census {
  long not_delaunay = 0, inverted = 0;
  std::vector<HalfEdgeId> wanted;  ///< edges that want their flip
};

Census take_census(const Mesh& mesh) {
  Census census;
  for_each_doubtful(mesh, [&census](HalfEdgeId h, EdgeState state) {
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

/// Reports the edges that still want their flip and were refused it, with the reason and the place.
void list_refused(const Mesh& mesh, const std::vector<HalfEdgeId>& wanted, const std::vector<RefusedEdge>& refused,
                  PassReport& report) {
  std::map<std::pair<PointId, PointId>, Outcome> last;
  for (const RefusedEdge& edge : refused) last[std::minmax(edge.origin, edge.target)] = edge.reason;
  for (const HalfEdgeId h : wanted) {
    const PointId from = mesh.origin(h), to = mesh.target(h);
    const Outcome reason = last.at(std::minmax(from, to));
    if (reason != Outcome::done) report.refuse(describe(reason), middle_of(mesh, h));
  }
}

}  // namespace

PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options) {
  Census census = take_census(mesh);
  LegalizeCounts counts;
  counts.lists_edges = true;
  for (long before = -1; !census.wanted.empty() && counts.flips > before;) {  // a flip may make room for others
    before = counts.flips;
    std::vector<HalfEdgeId> stack(census.wanted.rbegin(), census.wanted.rend());  // the first is tried first
    legalize(mesh, stack, options.refit, counts, options.max_flips, nullptr, true);
    if (counts.flips > before) census = take_census(mesh);
  }
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

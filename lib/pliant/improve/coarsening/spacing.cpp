// lib/pliant/improve/coarsening/spacing.cpp: roles by Douglas and Peucker's method; wanted lengths spread by
// Dijkstra's.
#include "pliant/improve/coarsening/spacing.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/geometry/spline/douglas_peucker.h"

namespace pliant {
namespace {

/// Which vertices of a chain stand at knots that the control polygon needs.
std::vector<bool> needed_knots(const BSpline& spline, const CurveChain& chain, double tolerance) {
  std::vector<bool> needed(chain.vertices.size(), false);
  const std::vector<bool> keep = douglas_peucker(spline.points().to_vector(), spline.closed(), tolerance);
  const int p = spline.degree();
  for (int i = 0; i < static_cast<int>(keep.size()); ++i) {
    if (!keep[index(i)]) continue;
    for (int k = i + 1; k <= i + p; ++k) {  // the inner knots of the support of control point i
      double knot = spline.knot(k);
      if (spline.closed() && knot >= spline.last_parameter()) knot -= spline.period();
      const auto found = std::lower_bound(chain.breaks.begin(), chain.breaks.end(), knot);
      if (found != chain.breaks.end() && *found == knot)
        needed[static_cast<std::size_t>(found - chain.breaks.begin())] = true;
    }
  }
  return needed;
}

/// Calls `visit` with the ends of each stretch of a chain between two kept vertices.
template <class Visit>
void visit_stretches(const CurveChain& chain, const std::vector<VertexRole>& roles, const Visit& visit) {
  PointId first = none, last = none;
  for (const PointId v : chain.vertices) {
    if (roles[index(v)] != VertexRole::kept) continue;
    if (last != none) visit(last, v);
    if (first == none) first = v;
    last = v;
  }
  if (chain.closed && first != last) visit(last, first);
}

}  // namespace

std::vector<VertexRole> vertex_roles(const Mesh& mesh, const std::vector<CurveChain>& chains,
                                     double polygon_tolerance) {
  std::vector<VertexRole> roles(index(mesh.point_slots()), VertexRole::inner);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const CurveChain& chain = chains[c];
    std::vector<bool> needed(chain.vertices.size(), false);
    if (polygon_tolerance > 0) needed = needed_knots(mesh.spline(static_cast<CurveId>(c)), chain, polygon_tolerance);
    for (std::size_t k = 0; k < chain.vertices.size(); ++k) {
      VertexRole& role = roles[index(chain.vertices[k])];
      const bool is_end = !chain.closed && (k == 0 || k + 1 == chain.vertices.size());
      role = role != VertexRole::inner || is_end || needed[k] ? VertexRole::kept : VertexRole::curve;
    }
  }
  for (const LoneVertex& each : mesh.lone_vertices())
    if (each.point != none) roles[index(each.point)] = VertexRole::kept;
  return roles;
}

std::vector<double> wanted_spacing(const Mesh& mesh, const VertexGraph& graph, const std::vector<CurveChain>& chains,
                                   const std::vector<VertexRole>& roles, const QualityGoals& goals,
                                   const std::vector<double>& bounds, double gradation) {
  std::vector<double> spacing = bounds;
  spacing.resize(index(mesh.point_slots()), HUGE_VAL);
  const auto lower = [&spacing](PointId v, double wanted) { spacing[index(v)] = std::min(spacing[index(v)], wanted); };
  std::vector<double> by_area;  // of each face
  for (FaceId f = 0; f < static_cast<FaceId>(mesh.boundary().faces.size()); ++f)
    by_area.push_back(goals.length_for_area(f));
  if (goals.bounds_area() || goals.size_field != none)
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
      if (mesh.is_alive(t))
        for (int c = 0; c < 3; ++c)
          lower(mesh.corner(t, c), std::min(by_area[index(mesh.face(t))], goals.length_by_field(mesh, t, c)));
  if (goals.size)
    for (PointId v = 0; v < mesh.point_slots(); ++v)
      if (mesh.is_vertex(v)) lower(v, goals.length_at(mesh.point(v), mesh.time));
  for (const CurveChain& chain : chains)  // the spacing of the vertices that the geometry needs
    visit_stretches(chain, roles, [&](PointId v, PointId w) {
      const double apart = distance(mesh.point(v), mesh.point(w));
      lower(v, apart);
      lower(w, apart);
    });

  // Dijkstra's algorithm from all vertices at once makes the wanted lengths Lipschitz.
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto spread = [&](double wanted, int k) {
    const PointId v = graph.vertex(k);
    for (const int near : graph.around(k)) {
      const PointId w = graph.vertex(near);
      const double room = (spacing[index(w)] - wanted) / gradation;
      if (!(room > 0)) continue;
      // Most edges are far too long to matter, as their squares tell without a root.
      const double squared = squared_length(mesh.point(w) - mesh.point(v));
      if (squared > 1e-280 && squared > room * room * (1 + 1e-9)) continue;
      const double graded = wanted + gradation * quick_distance(mesh.point(v), mesh.point(w));
      if (graded >= spacing[index(w)]) continue;
      spacing[index(w)] = graded;
      queue.push({graded, near});
    }
  };
  for (int k = 0; k < graph.count(); ++k)
    if (const double wanted = spacing[index(graph.vertex(k))]; wanted < HUGE_VAL) spread(wanted, k);
  while (!queue.empty()) {
    const auto [wanted, k] = queue.top();
    queue.pop();
    if (wanted == spacing[index(graph.vertex(k))]) spread(wanted, k);
  }
  const double widest = mesh.size();
  for (double& wanted : spacing) wanted = std::min(wanted, widest);
  return spacing;
}

}  // namespace pliant

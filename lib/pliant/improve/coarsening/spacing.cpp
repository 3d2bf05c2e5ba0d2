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

/// Makes wanted lengths Lipschitz: each becomes the least that any vertex asks for, plus `gradation` times the way from
/// there. Sweeps to and fro settle most vertices, since numbers that are near belong to vertices that are near;
/// Dijkstra's algorithm does the rest. Any order ends with the same lengths.
class Grading {
 public:
  Grading(const VertexGraph& graph, double gradation, std::vector<double>& wanted)
      : graph_(graph), gradation_(gradation), wanted_(wanted), is_due_(index(graph.count()), 0) {}

  void run() {
    const auto mark = [this](int k) { is_due_[index(k)] = 1; };
    for (int k = 0; k < graph_.count(); ++k) visit(k, mark);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (int i = 0; i < graph_.count(); ++i) {
        const int k = sweep % 2 == 0 ? graph_.count() - 1 - i : i;
        if (is_due_[index(k)] == 0) continue;
        is_due_[index(k)] = 0;
        visit(k, mark);
      }
    for (int k = 0; k < graph_.count(); ++k)
      if (is_due_[index(k)] != 0) enqueue(k);
    while (!queue_.empty()) {
      const auto [wanted, k] = queue_.top();
      queue_.pop();
      if (wanted == wanted_[index(k)]) visit(k, [this](int near) { enqueue(near); });
    }
  }

 private:
  static constexpr int sweeps = 3;
  using Item = std::pair<double, int>;

  void enqueue(int k) { queue_.push({wanted_[index(k)], k}); }

  /// Lowers what the neighbours of k want, if that is too much; calls `lowered` with each of these.
  template <class Lowered>
  void visit(int k, const Lowered& lowered) {
    const Point place = graph_.place(k);
    const double least = wanted_[index(k)], square = gradation_ * gradation_;
    if (!(least < HUGE_VAL)) return;
    for (const int near : graph_.around(k)) {
      double& wanted = wanted_[index(near)];
      // Most edges are far too long to matter, as their squares tell without a root.
      const double room = std::max(wanted - least, 0.0), squared = squared_length(graph_.place(near) - place);
      if (square * squared >= room * room * (1 + 1e-9) && squared > 1e-280) continue;
      const double graded = least + gradation_ * quick_distance(place, graph_.place(near));
      if (graded >= wanted) continue;
      wanted = graded;
      lowered(near);
    }
  }

  const VertexGraph& graph_;
  double gradation_;
  std::vector<double>& wanted_;  // by number in the graph
  std::vector<char> is_due_;     // its wanted length has been lowered since it was last visited
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue_;
};

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
                                   std::vector<double> bounds, double gradation) {
  std::vector<double> spacing = std::move(bounds);
  const auto lower = [&](PointId v, double wanted) {
    double& here = spacing[index(graph.number(v))];
    here = std::min(here, wanted);
  };
  std::vector<double> by_area;  // of each face
  for (FaceId f = 0; f < static_cast<FaceId>(mesh.boundary().faces.size()); ++f)
    by_area.push_back(goals.length_for_area(f));
  if (goals.bounds_area() || goals.size_field != none)
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
      if (mesh.is_alive(t))
        for (int c = 0; c < 3; ++c)
          lower(mesh.corner(t, c), std::min(by_area[index(mesh.face(t))], goals.length_by_field(mesh, t, c)));
  if (goals.size)
    for (int k = 0; k < graph.count(); ++k) lower(graph.vertex(k), goals.length_at(graph.place(k), mesh.time));
  for (const CurveChain& chain : chains)  // the spacing of the vertices that the geometry needs
    visit_stretches(chain, roles, [&](PointId v, PointId w) {
      const double apart = distance(mesh.point(v), mesh.point(w));
      lower(v, apart);
      lower(w, apart);
    });
  Grading(graph, gradation, spacing).run();
  const double widest = mesh.size();
  for (double& wanted : spacing) wanted = std::min(wanted, widest);
  return spacing;
}

}  // namespace pliant

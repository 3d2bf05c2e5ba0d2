#include "pliant/improve/coarsen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>

#include "pliant/geometry/douglas_peucker.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/remove_point.h"
#include "pliant/quality/element_quality.h"

namespace pliant {
namespace {

constexpr double spacing_factor = 0.6;  // least distance of kept vertices, in wanted edge lengths
constexpr double gradation = 0.7;       // Lipschitz bound of the wanted length
constexpr double least_shape = 0.25;    // a removal must not leave curved elements worse than this and than before

std::size_t at(int i) { return static_cast<std::size_t>(i); }

enum class Role : char { inner, curve, kept };  // of a vertex; kept: corners and what geometry needs

class Coarsener {
 public:
  Coarsener(Mesh& mesh, const CoarsenOptions& options) : mesh_(mesh), options_(options) {}

  PassReport run() {
    find_roles();
    find_spacing();
    choose();
    for (const Role role : {Role::inner, Role::curve})
      for (PointId v = 0; v < static_cast<PointId>(roles_.size()); ++v)
        if (mesh_.is_vertex(v) && roles_[at(v)] == role && !chosen_[at(v)]) remove(v, role);
    mesh_.compact();
    return report();
  }

 private:
  void find_roles() {
    roles_.assign(at(mesh_.point_slots()), Role::inner);
    vertices_.clear();
    for (PointId v = 0; v < mesh_.point_slots(); ++v) {
      if (!mesh_.is_vertex(v)) continue;
      vertices_.push_back(v);
      find_star(mesh_, v, star_);
      if (is_on_curve(mesh_, star_)) roles_[at(v)] = Role::curve;
    }
    if (options_.polygon_tolerance > 0) find_needed_knots();
  }

  /// A knot is needed if Douglas-Peucker keeps any of its degree neighbouring control points.
  void find_needed_knots() {
    std::vector<std::vector<double>> needed(mesh_.boundary().curves.size());
    for (std::size_t c = 0; c < needed.size(); ++c) {
      const BSpline& spline = mesh_.spline(static_cast<CurveId>(c));
      const std::vector<bool> keep = douglas_peucker(spline.points(), spline.closed(), options_.polygon_tolerance);
      const int count = static_cast<int>(keep.size()), p = spline.degree();
      const auto breaks = spline.breaks();
      for (std::size_t s = 0; s + (spline.closed() ? 1 : 0) < breaks.size(); ++s) {
        // Control point i is next to the knots i + 1 .. i + degree of its support.
        for (int i = 0; i < count; ++i) {
          if (!keep[at(i)]) continue;
          bool near = false;
          for (int k = i + 1; k <= i + p && !near; ++k) {
            double knot = spline.knot(k);
            if (spline.closed() && knot >= spline.last_parameter()) knot -= spline.period();
            near = knot == breaks[s];
          }
          if (near) {
            needed[c].push_back(breaks[s]);
            break;
          }
        }
      }
    }
    for (HalfEdgeId h = 0; h < 3 * mesh_.triangle_slots(); ++h) {
      if (!mesh_.is_alive(triangle_of(h)) || !mesh_.is_constrained(h)) continue;
      const ConstraintId c = mesh_.constraint(h);
      const auto& breaks = needed[at(mesh_.constraint_curve(c))];
      if (std::find(breaks.begin(), breaks.end(), mesh_.constraint_start(c)) != breaks.end())
        roles_[at(mesh_.constraint_first(c))] = Role::kept;
    }
  }

  /// The wanted edge length at each vertex, graded.
  void find_spacing() {
    spacing_.assign(roles_.size(), HUGE_VAL);
    using Item = std::pair<double, PointId>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (const PointId v : vertices_) {
      double wanted = HUGE_VAL;
      find_star(mesh_, v, star_);
      for (const HalfEdgeId h : star_.outgoing)
        wanted = std::min(wanted,
                          std::sqrt(options_.goals.area_bound(mesh_.face(triangle_of(h))) * 4 / std::numbers::sqrt3));
      if (options_.goals.size) wanted = std::min(wanted, options_.goals.size(mesh_.point(v), mesh_.time));
      if (roles_[at(v)] == Role::kept)  // geometry's own spacing
        for (const HalfEdgeId h : star_.outgoing)
          if (mesh_.is_constrained(h)) wanted = std::min(wanted, edge_length(h));
      spacing_[at(v)] = wanted;
      if (wanted < HUGE_VAL) queue.push({wanted, v});
    }
    while (!queue.empty()) {  // Dijkstra: wanted(v) <= wanted(u) + gradation * distance
      const auto [wanted, v] = queue.top();
      queue.pop();
      if (wanted > spacing_[at(v)]) continue;
      find_star(mesh_, v, star_);
      for (const HalfEdgeId h : star_.outgoing) {
        const PointId w = mesh_.target(h);
        const double graded = wanted + gradation * edge_length(h);
        if (graded >= spacing_[at(w)]) continue;
        spacing_[at(w)] = graded;
        queue.push({graded, w});
      }
    }
    const double widest = mesh_.size();
    for (double& wanted : spacing_) wanted = std::min(wanted, widest);
  }
  double edge_length(HalfEdgeId h) const {
    return distance(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)));
  }

  /// A maximal set of vertices with disjoint spheres: what geometry needs first, then curves, then the rest. A chosen
  /// vertex shuts out those in its sphere, so that the work is the sum of the chosen spheres' vertices.
  void choose() {
    chosen_.assign(roles_.size(), 0);
    std::vector<char> shut_out(roles_.size(), 0);
    std::vector<std::int32_t> visited(roles_.size(), none);
    std::vector<PointId> front;
    for (const Role role : {Role::kept, Role::curve, Role::inner})
      for (const PointId v : vertices_) {
        if (roles_[at(v)] != role || (shut_out[at(v)] && role != Role::kept)) continue;
        chosen_[at(v)] = 1;
        front.assign(1, v);
        visited[at(v)] = v;
        const double scale = options_.factor * spacing_factor;
        for (std::size_t k = 0; k < front.size(); ++k) {
          find_star(mesh_, front[k], star_);
          const auto look_at = [&](PointId w) {
            if (visited[at(w)] == v) return;
            visited[at(w)] = v;
            const double far = distance(mesh_.point(v), mesh_.point(w));
            if (far >= scale * spacing_[at(v)]) return;
            if (far < scale * spacing_[at(w)]) shut_out[at(w)] = 1;
            front.push_back(w);
          };
          for (const HalfEdgeId h : star_.outgoing) {
            look_at(mesh_.target(h));
            look_at(mesh_.apex(h));
          }
        }
      }
  }

  using Corners = std::array<PointId, 3>;
  Corners corners_of(TriangleId t) const {
    Corners corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  double shape_of(TriangleId t) const {
    std::array<Point, net_size(max_degree)> net;
    mesh_.gather_points(t, net);
    return curved_shape(mesh_.degree(), {net.data(), at(mesh_.net_size())});
  }

  /// The triangles around the link of what is removed: which ones refine would attack, and the worst shape.
  void look_around(std::vector<TriangleId>& triangles, const std::vector<PointId>& link) {
    triangles.clear();
    for (const PointId w : link) {
      find_star(mesh_, w, star_);
      for (const HalfEdgeId h : star_.outgoing) triangles.push_back(triangle_of(h));
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  }

  /// Knot removal moves vertices along its curve, too: up to `degree` spans away.
  void add_curve_neighbors(PointId v) {
    chain_.assign(1, v);
    std::size_t first = 0;
    for (int k = 0; k < mesh_.degree(); ++k)
      for (const std::size_t last = chain_.size(); first < last; ++first) {
        const PointId w = chain_[first];
        find_star(mesh_, w, star_);
        for (const HalfEdgeId h : star_.outgoing)
          for (const HalfEdgeId side : {h, previous(h)}) {
            const PointId next = mesh_.origin(side) == w ? mesh_.target(side) : mesh_.origin(side);
            if (mesh_.is_constrained(side) && std::find(chain_.begin(), chain_.end(), next) == chain_.end())
              chain_.push_back(next);
          }
      }
    link_.insert(link_.end(), chain_.begin() + 1, chain_.end());
  }

  void remove(PointId v, Role role) {
    find_star(mesh_, v, star_);
    link_.clear();
    for (const HalfEdgeId h : star_.outgoing) link_.push_back(mesh_.target(h));
    if (!star_.is_closed) link_.push_back(mesh_.apex(star_.outgoing.back()));
    if (role == Role::curve) add_curve_neighbors(v);
    look_around(around_, link_);
    attacked_.clear();
    double worst_before = 1;
    for (const TriangleId t : around_) {
      if (refine_reason(mesh_, t, options_.goals)) attacked_.push_back(corners_of(t));
      worst_before = std::min(worst_before, shape_of(t));
    }
    std::sort(attacked_.begin(), attacked_.end());

    Transaction transaction(mesh_);
    double error = 0;
    Refusal refusal;
    if (role == Role::curve) {
      const CurveRemoval removal = remove_curve_vertex(
          mesh_, v, {options_.tolerance, options_.step_tolerance, options_.keep_area, options_.goals.max_turning},
          options_.refit);
      refusal = removal.refusal;
      error = removal.error;
    } else {
      refusal = remove_inner_vertex(mesh_, v, options_.refit);
    }
    if (refusal != Refusal::done) {
      ++refusals_[describe(refusal)];
      return;
    }
    // Flips that the hole's edges now want; then the verdict.
    look_around(around_, link_);
    for (const TriangleId t : around_)
      for (int e = 0; e < 3; ++e)
        if (wants_flip(edge_state(mesh_, half_edge(t, e)))) stack_.push_back(half_edge(t, e));
    touched_.clear();
    legalize(mesh_, stack_, options_.refit, counts_, -1, &touched_);
    look_around(around_, link_);
    around_.insert(around_.end(), touched_.begin(), touched_.end());
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const TriangleId t : around_) {
      const char* reason = refine_reason(mesh_, t, options_.goals);
      if (reason && !std::binary_search(attacked_.begin(), attacked_.end(), corners_of(t))) {
        ++refusals_[std::string("would be refined again: ") + reason];
        return;
      }
      if (shape_of(t) < std::min(worst_before, least_shape)) {
        ++refusals_["would be misshapen"];
        return;
      }
    }
    transaction.commit();
    ++(role == Role::curve ? curve_removals_ : inner_removals_);
    largest_error_ = std::max(largest_error_, error);
  }

  PassReport report() const {
    PassReport report;
    report.add("removals", static_cast<double>(inner_removals_ + curve_removals_));
    report.add("interior_removals", static_cast<double>(inner_removals_));
    report.add("curve_removals", static_cast<double>(curve_removals_));
    report.add("largest_error", largest_error_);
    double accumulated = 0;
    for (const Curve& curve : mesh_.boundary().curves) accumulated = std::max(accumulated, curve.removal_error);
    report.add("accumulated_error", accumulated);
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [reason, times] : refusals_) report.refuse(reason, times);
    return report;
  }

  Mesh& mesh_;
  const CoarsenOptions& options_;
  std::vector<PointId> vertices_, link_, chain_;
  std::vector<Role> roles_;
  std::vector<double> spacing_;
  std::vector<char> chosen_;
  std::vector<TriangleId> around_, touched_;
  std::vector<Corners> attacked_;
  std::vector<HalfEdgeId> stack_;
  Star star_;
  LegalizeCounts counts_;
  std::map<std::string, long> refusals_;
  long inner_removals_ = 0, curve_removals_ = 0;
  double largest_error_ = 0;
};

}  // namespace

PassReport coarsen(Mesh& mesh, const CoarsenOptions& options) { return Coarsener(mesh, options).run(); }

}  // namespace pliant

// lib/pliant/improve/coarsening/removal_forecast.cpp: chains of removals on straight triangles, judged by refine's
// bounds.
#include "pliant/improve/coarsening/removal_forecast.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/refining/refine_attack.h"

namespace pliant {
namespace {

constexpr double slack = 1e-9;  // relative; by so much the forecast is milder than refine, because of rounding
// The area between an edge and its chord is at most this share of the product of the chord's length and the edge's
// bend: of a parabola, and of any edge.
constexpr double parabola = (1 + slack) / 3, segment = 1.5;

constexpr const char* too_large = "too large";
constexpr const char* too_poor = "too poor";

/// The curve that passes through a vertex.
CurveId curve_at(const Mesh& mesh, PointId v) {
  HalfEdgeId h = mesh.vertex_half_edge(v);
  while (!mesh.is_constrained(h)) h = next(mesh.twin(h));  // clockwise; only edges on curves have no twin
  return mesh.constraint_curve(mesh.constraint(h));
}

}  // namespace

const char* attack_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  return refine_reason(mesh, t, goals);
}

Culprit find_culprit(const Mesh& mesh, const std::array<PointId, 3>& corners, const std::array<Point, 3>& places,
                     const std::vector<bool>& slated) {
  const auto squared = [&](int e) { return squared_length(places[index((e + 1) % 3)] - places[index(e)]); };
  const std::array<double, 3> sides{squared(0), squared(1), squared(2)};
  int shortest = 0;  // of equal ones the side that starts at the lowest number, wherever the triangle starts
  for (int e = 1; e < 3; ++e)
    if (sides[index(e)] < sides[index(shortest)] ||
        (sides[index(e)] == sides[index(shortest)] && corners[index(e)] < corners[index(shortest)]))
      shortest = e;
  Culprit culprit{none, sides[index(shortest)], corners};
  std::sort(culprit.triangle.begin(), culprit.triangle.end());
  for (const int c : {shortest + 2, shortest + 1, shortest}) {
    const PointId w = corners[index(c % 3)];
    if (slated[index(w)] && mesh.is_vertex(w)) culprit.vertex = w;
  }
  return culprit;
}

RemovalForecast::RemovalForecast(Mesh& mesh, const QualityGoals& goals, const CurveTolerance& tolerance,
                                 const std::vector<bool>& slated)
    : mesh_(mesh),
      goals_(goals),
      tolerance_(tolerance),
      slated_(slated),
      patch_(mesh),
      versions_(mesh.boundary().curves.size(), 0),
      least_sine_(std::sin(goals.min_angle * std::numbers::pi / 180) * (1 - slack)) {
  is_poor_asked_ = goals.min_angle > 0 && !goals.keeps_thin;  // what crosses a thin gap may be poor
  is_size_asked_ = goals.bounds_area() || goals.size || goals.size_field != none;
  bounds_area_ = goals.max_area < HUGE_VAL ||
                 std::any_of(goals.face_area.begin(), goals.face_area.end(), [](double a) { return a < HUGE_VAL; });
}

/// Is the least angle surely too small? It lies opposite the shortest side, and its sine is twice the area over the
/// product of the two other sides.
bool RemovalForecast::is_surely_poor(const Point& a, const Point& b, const Point& c) const {
  const double twice_area = cross(b - a, c - a);
  if (!(twice_area > 0)) return true;
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  const double least = std::min({ab, bc, ca});
  const double product = least == ab ? bc * ca : least == bc ? ab * ca : ab * bc;
  if (!(product > 1e-280 && product < 1e280))  // near the limits of doubles: the slower test
    return radius_edge_ratio(a, b, c) > (1 + slack) / (2 * least_sine_);
  return twice_area * twice_area < least_sine_ * least_sine_ * product;
}

/// Is the area of an element on this triangle surely above the bound? It differs from that of the triangle by less than
/// the lengths of its sides times `share` of how far they are off their chords. No flip makes that larger, but the
/// removal of a knot may.
bool RemovalForecast::exceeds_area(FaceId face, const Point& a, const Point& b, const Point& c, double share) const {
  if (!bounds_area_ || !foreseen_.curves.empty()) return false;
  const double around = distance(a, b) + distance(b, c) + distance(c, a);
  const double least = cross(b - a, c - a) / 2 - share * patch_.bend() * around;
  return least > (1 + slack) * goals_.area_bound(face);
}

bool RemovalForecast::is_surely_large(FaceId face, const std::array<PointId, 3>& corners, const Point& a,
                                      const Point& b, const Point& c) const {
  if (exceeds_area(face, a, b, c, segment)) return true;
  if (!goals_.size && goals_.size_field == none) return false;
  double wanted = goals_.length_at((1.0 / 3) * (a + b + c), mesh_.time);
  if (goals_.size_field != none) {
    double sum = 0;
    for (const PointId v : corners) sum += goals_.length_by_field_at(mesh_, v, face);
    wanted = std::min(wanted, sum / 3);
  }
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  return longest > (1 + slack) * size_slack * wanted;
}

/// What the curve of w has said to its removal before, if it refused for its own sake and has not changed since.
const RemovalForecast::Refusal* RemovalForecast::known_refusal(PointId w) const {
  if (index(w) >= refused_.size() || !foreseen_.curves.empty()) return nullptr;
  const Refusal& known = refused_[index(w)];
  return known.curve != none && known.version == versions_[index(known.curve)] ? &known : nullptr;
}

/// Asks the curve of w, which lies on one.
Outcome RemovalForecast::ask_curve(PointId w) {
  const bool is_as_in_mesh = foreseen_.curves.empty();
  const Outcome outcome = foresee_curve_removal(mesh_, w, tolerance_, foreseen_).outcome;
  if (is_as_in_mesh && (outcome == Outcome::exceeds_tolerance || outcome == Outcome::too_curved)) {
    if (index(w) >= refused_.size()) refused_.resize(index(mesh_.point_slots()));
    const CurveId curve = curve_at(mesh_, w);
    refused_[index(w)] = {curve, versions_[index(curve)], outcome};
  }
  return outcome;
}

/// Removes w from the patch. `reason` is what its curve says to that, if it is on one: that does not depend on what the
/// mesh around it has become in the chain.
LogicalPatch::Outcome RemovalForecast::remove(PointId w, bool is_surely_on_curve, Outcome& reason) {
  if (const Refusal* known = known_refusal(w); known != nullptr) {
    reason = known->outcome;
    return LogicalPatch::Outcome::stuck;
  }
  if (is_surely_on_curve) {
    // Most are refused by their curves, so that the mesh around need not be looked at.
    reason = ask_curve(w);
    if (reason != Outcome::done) return LogicalPatch::Outcome::stuck;
  }
  reason = Outcome::not_removable;
  const LogicalPatch::Outcome outcome = patch_.remove_inner(w);
  if (outcome != LogicalPatch::Outcome::on_curve) return outcome;
  if (!is_surely_on_curve) reason = ask_curve(w);
  if (!is_surely_on_curve && reason != Outcome::done) return LogicalPatch::Outcome::stuck;
  reason = Outcome::not_removable;
  return patch_.remove_on_curve(w, foreseen_.moved);
}

/// Why refine would attack a piece that is new or has moved; null if it would not, or would have before.
const char* RemovalForecast::reason_of(const LogicalPatch::Piece& piece) const {
  const bool has_moved = patch_.has_moved(piece);
  if (!piece.is_alive || !(piece.is_new || has_moved)) return nullptr;
  const Point &a = patch_.place(piece.corners[0]), &b = patch_.place(piece.corners[1]),
              &c = patch_.place(piece.corners[2]);
  const char* reason = is_size_asked_ && is_surely_large(piece.face, patch_.vertices(piece), a, b, c) ? too_large
                       : is_poor_asked_ && is_surely_poor(a, b, c)                                    ? too_poor
                                                                                                      : nullptr;
  if (reason == nullptr || piece.is_new) return reason;
  return attack_reason(mesh_, piece.triangle, goals_) ? nullptr : reason;
}

/// After one removal: is there a new element, with no slated corner, that a closer bound shows to be surely too large?
/// Then the removal is refused, and for that reason, unless another one can come before it, as it may beside curves.
bool RemovalForecast::leaves_too_large() const {
  if (mesh_.degree() != 2) return false;
  bool any = false;
  for (const LogicalPatch::Piece& piece : patch_.pieces()) {
    if (!piece.is_alive || !piece.is_new) continue;
    if (piece.is_constrained[0] || piece.is_constrained[1] || piece.is_constrained[2]) return false;
    const std::array<Point, 3> places = patch_.places(piece);
    any = any || (exceeds_area(piece.face, places[0], places[1], places[2], parabola) &&
                  find_culprit(mesh_, patch_.vertices(piece), places, slated_).vertex == none);
  }
  return any;
}

RemovalRefusal RemovalForecast::of(PointId v, bool is_on_curve) {
  patch_.start(bounds_area_);
  foreseen_.clear();
  Transaction trial(mesh_);        // the curves change; rolled back at the end
  RemovalRefusal last, otherwise;  // `otherwise`: what is known where the chain itself does not tell
  int removed = 0;
  for (PointId w = v;;) {
    Outcome refusal = Outcome::done;
    const LogicalPatch::Outcome outcome = remove(w, w == v && is_on_curve, refusal);
    if (outcome == LogicalPatch::Outcome::unknown) return otherwise;
    if (outcome == LogicalPatch::Outcome::stuck) {
      if (w == v) return {describe(refusal)};
      if (refusal == Outcome::edge_exists) return otherwise;
      return last;
    }
    last = {};
    bool is_any_poor = false;
    Culprit first;
    for (const LogicalPatch::Piece& piece : patch_.pieces()) {
      const char* reason = reason_of(piece);
      if (reason == nullptr) continue;
      last = {reason, true};
      is_any_poor = is_any_poor || reason == too_poor;
      const Culprit culprit = find_culprit(mesh_, patch_.vertices(piece), patch_.places(piece), slated_);
      if (culprit.vertex == none) return last;
      first = std::min(first, culprit);
    }
    if (w == v && !is_any_poor && leaves_too_large()) otherwise = {too_large, true};
    if (last.reason == nullptr) return otherwise;
    if (++removed == most_chained) return last;
    w = first.vertex;
  }
}

}  // namespace pliant

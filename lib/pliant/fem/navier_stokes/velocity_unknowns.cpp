// lib/pliant/fem/navier_stokes/velocity_unknowns.cpp: splines on curves, conditions, and the numbers of the rest.
#include "pliant/fem/navier_stokes/velocity_unknowns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "pliant/fem/edge_map.h"
#include "pliant/fem/navier_stokes/spline_weights.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Kind = FlowCondition::Kind;

/// Where normals of slip at one place differ by more than this sine, it is a corner, from which nothing can glide away.
constexpr double corner_sine = 0.1;

}  // namespace

/// Places carry unknowns: the control points of edges and elements, and the coefficients of splines.
class VelocityUnknowns::Builder {
 public:
  Builder(VelocityUnknowns& result, std::span<const char> jumps, bool by_splines)
      : to_(result), mesh_(result.mesh_), problem_(result.problem_), sums_(index(mesh_.point_slots())) {
    places_.resize(index(mesh_.point_slots()));
    for (PointId p = 0; p < mesh_.point_slots(); ++p) themselves_.push_back({p, 1.0});
    if (by_splines) add_splines();
    for (std::size_t c = 0; c < to_.edges_.size(); ++c)
      for (const HalfEdgeId h : to_.edges_[c]) apply_condition(static_cast<CurveId>(c), h);
    number();
    find_parts(jumps);
  }

 private:
  struct Place {
    bool is_fixed = false, is_slip = false;
    Vector normal;                // of slip: the integral of the normal times the basis function
    std::vector<Vector> corners;  // of slip: unit normals of edges that end here, outward ones on the outer boundary
    bool is_outer = false;        // of slip: the normals are outward ones
    int first = -1;               // unknown
  };

  const FlowCondition* condition(CurveId c) const {
    const int k = problem_.condition_of_curve[index(c)];
    return k == none ? nullptr : &problem_.conditions[index(k)];
  }

  void add_splines() {
    for (std::size_t c = 0; c < to_.edges_.size(); ++c) {
      const FlowCondition* const on_it = condition(static_cast<CurveId>(c));
      if (problem_.motion_of_curve[c] != CurveMotion::follows) continue;
      if (on_it != nullptr && on_it->kind == Kind::velocity) continue;
      if (!to_.edges_[c].empty()) add_spline(static_cast<CurveId>(c));
    }
  }

  void add_spline(CurveId c) {
    const BSpline& spline = mesh_.spline(c);
    const int p = mesh_.degree(), count = static_cast<int>(spline.points().size());
    const int base = static_cast<int>(places_.size());
    places_.resize(places_.size() + index(count));
    PointId first_point = none, last_point = none;
    if (!spline.closed())
      for (const HalfEdgeId h : to_.edges_[index(c)]) {
        const double start = mesh_.constraint_start(mesh_.constraint(h));
        const bool forward = mesh_.runs_forward(h);
        if (start == spline.first_parameter()) first_point = mesh_.edge_point(h, forward ? 0 : p);
        if (spline.span_end(start) == spline.last_parameter()) last_point = mesh_.edge_point(h, forward ? p : 0);
      }
    SplineWeights weights(spline);
    for (const HalfEdgeId h : to_.edges_[index(c)]) {
      const bool forward = mesh_.runs_forward(h);
      weights.set(mesh_.constraint_start(mesh_.constraint(h)));
      for (int k = 0; k <= p; ++k) {
        const PointId point = mesh_.edge_point(h, forward ? k : p - k);
        if (point == first_point || point == last_point) continue;
        std::vector<Weighted>& sum = sums_[index(point)];
        if (!sum.empty()) continue;  // the end of the span before, whose sum is the same
        for (const auto& [coefficient, weight] : weights.of(k)) {
          const PointId end = spline.closed()            ? none
                              : coefficient == 0         ? first_point
                              : coefficient == count - 1 ? last_point
                                                         : none;
          sum.push_back({end == none ? base + coefficient : end, weight});
        }
      }
    }
  }

  /// The places that a control point is made of.
  std::span<const Weighted> sum(PointId p) const {
    return sums_[index(p)].empty() ? std::span(themselves_).subspan(index(p), 1) : std::span(sums_[index(p)]);
  }

  void apply_condition(CurveId c, HalfEdgeId h) {
    const FlowCondition* const on_it = condition(c);
    if (on_it == nullptr) return;
    const int p = mesh_.degree();
    if (on_it->kind == Kind::velocity)
      for (int k = 0; k <= p; ++k) places_[index(mesh_.edge_point(h, k))].is_fixed = true;
    if (on_it->kind != Kind::slip) return;
    map_.set(mesh_, mesh_.points(), h);
    for (int k = 0; k <= p; ++k) {
      Vector normal;
      for (int q = 0; q < map_.points(); ++q)
        normal += map_.weight(q) * map_.values_at(q)[index(k)] * Vector{map_.along(q).y, -map_.along(q).x};
      const PointId point = mesh_.edge_point(h, k);
      // Normals of one curve agree, and those of the outer boundary. Which way curves run inside is free: where two
      // meet, one normal counts as it is.
      const bool is_outer = mesh_.twin(h) == none;
      if (!is_outer && (k == 0 || k == p) && dot(places_[index(point)].normal, normal) < 0) normal = -1.0 * normal;
      for (const auto& [place, weight] : sum(point)) {
        places_[index(place)].is_slip = true;
        places_[index(place)].is_outer = is_outer;
        places_[index(place)].normal += weight * normal;
      }
      if (k > 0 && k < p) continue;
      const Vector leg = k == 0 ? mesh_.point(mesh_.edge_point(h, 1)) - mesh_.point(point)
                                : mesh_.point(point) - mesh_.point(mesh_.edge_point(h, p - 1));
      if (sums_[index(point)].empty() && length(leg) > 0)
        places_[index(point)].corners.push_back(Vector{leg.y, -leg.x} / length(leg));
    }
  }

  /// Corners of slip walls hold the fluid, and so do cusps.
  void hold_corners() {
    for (Place& place : places_)
      for (const Vector& normal : place.corners)
        if (std::abs(cross(normal, place.corners[0])) > corner_sine ||
            (place.is_outer && dot(normal, place.corners[0]) < 0))
          place.is_fixed = true;
  }

  int unknown(Place& place) {
    if (place.first < 0) {
      place.first = to_.size_;
      to_.size_ += place.is_slip ? 1 : 2;
    }
    return place.first;
  }

  void number() {
    hold_corners();
    // The unknowns have the order in which the elements name them, the rows the order of the points.
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
      for (const PointId p : mesh_.net(t))
        for (const auto& [place, weight] : sum(p))
          if (!places_[index(place)].is_fixed) unknown(places_[index(place)]);
    to_.has_given_.assign(index(mesh_.point_slots()), 0);
    to_.starts_.push_back(0);
    for (PointId p = 0; p < mesh_.point_slots(); ++p) {
      for (int component = 0; component < 2; ++component) {
        for (const auto& [number, weight] : sum(p)) {
          const Place& place = places_[index(number)];
          if (place.is_fixed) {
            to_.has_given_[index(p)] = 1;  // itself: the end of a clamped spline reaches no other control point
          } else if (place.first >= 0 && place.is_slip) {
            const Vector along = Vector{-place.normal.y, place.normal.x} / length(place.normal);
            const double part = component == 0 ? along.x : along.y;
            if (part != 0) to_.terms_.push_back({place.first, weight * part});
          } else if (place.first >= 0) {
            to_.terms_.push_back({place.first + component, weight});
          }
        }
        to_.starts_.push_back(static_cast<int>(to_.terms_.size()));
      }
    }
  }

  bool is_wall(CurveId c) const {
    const FlowCondition* const on_it = condition(c);
    return on_it != nullptr && (on_it->kind == Kind::velocity || on_it->kind == Kind::slip);
  }

  void find_parts(std::span<const char> jumps) {
    std::vector<int> parent(index(mesh_.triangle_slots()));
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int i) {
      while (parent[index(i)] != i) i = parent[index(i)] = parent[index(parent[index(i)])];
      return i;
    };
    const auto curve = [this](HalfEdgeId h) {
      return mesh_.is_constrained(h) ? mesh_.constraint_curve(mesh_.constraint(h)) : none;
    };
    std::map<std::pair<PointId, FaceId>, TriangleId> at_corner;  // a face has one pressure there
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
      for (int e = 0; e < 3; ++e) {
        const TriangleId other = at_corner.try_emplace({mesh_.corner(t, e), mesh_.face(t)}, t).first->second;
        parent[index(root(t))] = root(other);
        const HalfEdgeId h = half_edge(t, e), twin = mesh_.twin(h);
        const CurveId c = curve(h);
        if (twin != none && (c == none || jumps[index(c)] == 0 || !is_wall(c)))
          parent[index(root(t))] = root(triangle_of(twin));
      }
    std::vector<int> numbers(parent.size(), none);
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
      int& number = numbers[index(root(t))];
      if (number == none) {
        number = static_cast<int>(to_.enclosed_.size());
        to_.enclosed_.push_back(1);
      }
      to_.part_of_triangle_.push_back(number);
    }
    for (const HalfEdgeId h : mesh_.half_edges())
      if (mesh_.twin(h) == none && !is_wall(curve(h))) to_.enclosed_[index(to_.part_of(triangle_of(h)))] = 0;
  }

  VelocityUnknowns& to_;
  const Mesh& mesh_;
  const FlowProblem& problem_;
  EdgeMap map_{mesh_.degree()};
  std::vector<std::vector<Weighted>> sums_;  // for each control point; empty: itself
  std::vector<Weighted> themselves_;         // each control point as such a sum
  std::vector<Place> places_;                // the control points, then coefficients
};

VelocityUnknowns::VelocityUnknowns(const FlowProblem& problem, const Mesh& mesh, std::span<const char> jumps,
                                   bool by_splines)
    : problem_(problem), mesh_(mesh), edges_(curve_edges(mesh)) {
  Builder(*this, jumps, by_splines);
}

void VelocityUnknowns::expand(std::span<const double> unknowns, std::span<double> values) const {
  for (std::size_t row = 0; row < values.size(); ++row)
    for (int k = starts_[row]; k < starts_[row + 1]; ++k)
      values[row] += terms_[index(k)].weight * unknowns[index(terms_[index(k)].unknown)];
}

}  // namespace pliant

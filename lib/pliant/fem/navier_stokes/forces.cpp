// lib/pliant/fem/navier_stokes/forces.cpp: what the fluid does to curves, by the residual.
#include <algorithm>
#include <array>
#include <set>

#include "pliant/fem/edge_map.h"
#include "pliant/fem/element_values.h"
#include "pliant/fem/navier_stokes/navier_stokes.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// The stress of a solution on edges, as far as one basis function sees it.
class EdgeStress {
 public:
  EdgeStress(const FlowEquation& equation, const Configuration& at, const FlowState& state)
      : equation_(equation),
        mesh_(equation.mesh()),
        at_(at),
        state_(state),
        pressures_(elevated_values(equation.pressures(), state.pressure, mesh_.degree())),
        edge_(mesh_.degree()),
        rows_(5 * index(mesh_.net_size())) {}

  /// The integral of the force of the fluid on the edge times the k-th basis function of the edge.
  Vector operator()(HalfEdgeId h, int k) {
    const TriangleId t = triangle_of(h);
    const double unit = mesh_.boundary().unit;
    std::size_t i = 0;
    for (const PointId p : mesh_.net(t)) {
      const Point& place = at_.points[index(p)];
      const double* const u = state_.velocity.data() + 2 * index(p);
      const std::array row{place.x, place.y, u[0], u[1], pressures_[index(t) * index(mesh_.net_size()) + i]};
      std::ranges::copy(row, rows_.begin() + static_cast<std::ptrdiff_t>(5 * i++));
    }
    edge_.set(mesh_, at_.points, h);
    const Coefficient& viscosity = equation_.problem().materials[index(mesh_.face(t))].viscosity;
    Vector sum;
    for (int q = 0; q < edge_.points(); ++q) {
      std::array<double, 5> value, d2, d3;
      evaluate_net(mesh_.degree(), 5, rows_, edge_.xi(q), value, d2, d3);
      const double det = d2[0] * d3[1] - d3[0] * d2[1];
      const auto along_x = [&](std::size_t c) { return (d2[c] * d3[1] - d3[c] * d2[1]) / det; };
      const auto along_y = [&](std::size_t c) { return (d3[c] * d2[0] - d2[c] * d3[0]) / det; };
      const double mu =
          evaluate_at(viscosity, {mesh_, t, edge_.xi(q), unit * Point{value[0], value[1]}, at_.time}) / unit;
      const double back = equation_.form().is_stress ? mu : 0, p = unit * value[4];
      const double xx = (mu + back) * along_x(2) - p, yy = (mu + back) * along_y(3) - p;
      const double xy = mu * along_y(2) + back * along_x(3), yx = mu * along_x(3) + back * along_y(2);
      const Vector outward =
          (unit * edge_.weight(q) * edge_.values_at(q)[index(k)]) * Vector{edge_.along(q).y, -edge_.along(q).x};
      sum -= Vector{xx * outward.x + xy * outward.y, yx * outward.x + yy * outward.y};
    }
    return sum;
  }

 private:
  const FlowEquation& equation_;
  const Mesh& mesh_;
  const Configuration& at_;
  const FlowState& state_;
  std::vector<double> pressures_;
  EdgeMap edge_;
  std::vector<double> rows_;  // of one element: x, y, velocity, pressure
};

}  // namespace

void NavierStokes::find_forces(const Configuration& at, const FlowTerms& terms) {
  const std::vector<double> reactions = equation_.reactions(at, terms, state_);
  struct AtPoint {
    Vector direct;      // the stress of the solution
    double weight = 0;  // how many edges
  };
  std::map<PointId, std::map<std::string, AtPoint>> corners;
  std::map<std::string, std::set<PointId>> points;
  const auto for_each_edge = [&](const auto& use) {
    for (const HalfEdgeId h : mesh_.half_edges()) {
      if (!mesh_.is_constrained(h)) continue;
      const CurveId c = mesh_.constraint_curve(mesh_.constraint(h));
      const int k = problem_.condition_of_curve[index(c)];
      if (k == none) continue;
      const FlowCondition::Kind kind = problem_.conditions[index(k)].kind;
      if (kind == FlowCondition::Kind::velocity || kind == FlowCondition::Kind::slip)
        use(h, mesh_.boundary().curves[index(c)].name, c);
    }
  };
  for_each_edge([&](HalfEdgeId h, const std::string& name, CurveId) {
    for (int i = 0; i <= mesh_.degree(); ++i) points[name].insert(mesh_.edge_point(h, i));
    for (const int i : {0, mesh_.degree()}) corners[mesh_.edge_point(h, i)][name].weight += 1;
  });
  std::erase_if(corners, [](const auto& corner) { return corner.second.size() < 2; });

  // Where curves of several names meet, the residual is that of all of them: each has its part of the stress, and the
  // residual corrects their sum.
  if (!corners.empty()) {
    EdgeStress stress(equation_, at, state_);
    for_each_edge([&](HalfEdgeId h, const std::string& name, CurveId) {
      for (const int i : {0, mesh_.degree()})
        if (const auto corner = corners.find(mesh_.edge_point(h, i)); corner != corners.end())
          corner->second[name].direct += stress(h, i);
    });
  }
  forces_.clear();
  for (const auto& [name, on_curve] : points)
    for (const PointId p : on_curve) {
      const Vector reaction{reactions[2 * index(p)], reactions[2 * index(p) + 1]};
      const auto corner = corners.find(p);
      if (corner == corners.end()) {
        forces_[name] += reaction;
        continue;
      }
      Vector rest = reaction;
      double weights = 0;
      for (const auto& [other, part] : corner->second) {
        rest -= part.direct;
        weights += part.weight;
      }
      const AtPoint& mine = corner->second[name];
      forces_[name] += mine.direct + (mine.weight / weights) * rest;
    }
  // A curve that moves feels the force, too, but no residual is known on splines; nor is it where fluid glides, which
  // has had its part at corners only.
  for_each_edge([&](HalfEdgeId, const std::string& name, CurveId c) {
    const int k = problem_.condition_of_curve[index(c)];
    if (problem_.motion_of_curve[index(c)] != CurveMotion::stays ||
        problem_.conditions[index(k)].kind == FlowCondition::Kind::slip)
      forces_.erase(name);
  });
}

}  // namespace pliant

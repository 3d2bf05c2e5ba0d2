// lib/pliant/fem/diffusion/curve_fluxes.cpp: residuals by control point and face, shared out to curves.
#include "pliant/fem/diffusion/curve_fluxes.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "pliant/fem/edge_map.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Is the flux through a curve that which its condition says?
bool is_given(const DiffusionProblem& problem, const Mesh& mesh, CurveId c) {
  const int condition = problem.condition_of_curve[index(c)];
  const Curve& curve = mesh.boundary().curves[index(c)];
  const bool outer = curve.left == outside || curve.right == outside;
  if (condition == none) return outer;
  const auto kind = problem.conditions[index(condition)].kind;
  return kind == DiffusionCondition::Kind::jump || (outer && kind != DiffusionCondition::Kind::value);
}

}  // namespace

CurveFluxes::CurveFluxes(const DiffusionProblem& problem, const Mesh& mesh) : problem_(problem), mesh_(mesh) {
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_constrained(h))
      for (int k = 0; k <= mesh.degree(); ++k) places_.push_back({mesh.edge_point(h, k), mesh.face(triangle_of(h))});
  std::ranges::sort(places_);
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  residuals_.assign(places_.size(), 0.0);

  starts_.push_back(0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const auto net = mesh.net(t);
    for (std::size_t k = 0; k < net.size(); ++k)
      if (const int place = find_place(net[k], mesh.face(t)); place >= 0) {
        local_.push_back(static_cast<int>(k));
        touched_.push_back(place);
      }
    starts_.push_back(static_cast<int>(local_.size()));
  }

  EdgeMap map(mesh.degree());
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_constrained(h)) continue;
    map.set(mesh, mesh.points(), h);
    for (int k = 0; k <= mesh.degree(); ++k) {
      double length = 0;
      for (int q = 0; q < map.points(); ++q) length += map.measure(q) * map.values_at(q)[index(k)];
      sides_.push_back({mesh.constraint_curve(mesh.constraint(h)), mesh.runs_forward(h),
                        find_place(mesh.edge_point(h, k), mesh.face(triangle_of(h))), length, 0});
    }
  }
  const auto key = [](const Side& side) { return std::tuple(side.place, side.curve, side.is_left); };
  std::ranges::stable_sort(sides_, {}, key);
  std::size_t kept = 0;
  for (std::size_t k = 1; k < sides_.size(); ++k) {
    if (key(sides_[k]) == key(sides_[kept]))
      sides_[kept].length += sides_[k].length;
    else
      sides_[++kept] = sides_[k];
  }
  sides_.resize(sides_.empty() ? 0 : kept + 1);
}

int CurveFluxes::find_place(PointId p, FaceId f) const {
  const std::array<std::int32_t, 2> place{p, f};
  const auto found = std::ranges::lower_bound(places_, place);
  return found == places_.end() || *found != place ? -1 : static_cast<int>(found - places_.begin());
}

CurveFluxes::Side* CurveFluxes::find_side(CurveId c, bool is_left, int place) {
  const auto key = [](const Side& side) { return std::tuple(side.place, side.curve, side.is_left); };
  const auto found = std::ranges::lower_bound(sides_, std::tuple(place, c, is_left), {}, key);
  assert(found != sides_.end());
  return &*found;
}

void CurveFluxes::add_element(TriangleId t, double factor, std::span<const double> residual) {
  for (int k = starts_[index(t)]; k < starts_[index(t) + 1]; ++k)
    residuals_[index(touched_[index(k)])] += factor * residual[index(local_[index(k)])];
}

void CurveFluxes::add_edge(HalfEdgeId h, double factor, std::span<const double> enters) {
  for (int k = 0; k <= mesh_.degree(); ++k)
    find_side(mesh_.constraint_curve(mesh_.constraint(h)), mesh_.runs_forward(h),
              find_place(mesh_.edge_point(h, k), mesh_.face(triangle_of(h))))
        ->known += factor * enters[index(k)];
}

CurveFluxes::Totals CurveFluxes::totals() const {
  const std::size_t curves = mesh_.boundary().curves.size();
  Totals totals{std::vector<double>(curves, 0.0), std::vector<double>(curves, 0.0)};
  for (std::size_t first = 0, last = 0; first < sides_.size(); first = last) {
    double rest = residuals_[index(sides_[first].place)], length = 0;
    for (last = first; last < sides_.size() && sides_[last].place == sides_[first].place; ++last) {
      if (is_given(problem_, mesh_, sides_[last].curve))
        rest -= sides_[last].known;
      else
        length += sides_[last].length;
    }
    for (std::size_t k = first; k < last; ++k) {
      const Side& side = sides_[k];
      const Curve& curve = mesh_.boundary().curves[index(side.curve)];
      const bool between = curve.left != outside && curve.right != outside && curve.left != curve.right;
      const double enters = is_given(problem_, mesh_, side.curve) ? side.known
                            : length > 0                          ? rest * (side.length / length)
                                                                  : 0;
      if (!between)
        totals.fluxes[index(side.curve)] += enters;
      else if (side.is_left)
        totals.fluxes[index(side.curve)] -= enters;
      if (between) totals.freed[index(side.curve)] += enters;
    }
  }
  return totals;
}

}  // namespace pliant

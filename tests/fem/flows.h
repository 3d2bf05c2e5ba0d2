// tests/fem/flows.h: flow problems on the meshes of these tests, and how far a solution is from an exact one.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/fem/error_norms.h"
#include "pliant/fem/navier_stokes/navier_stokes.h"
#include "pliant/geometry/index.h"

namespace pliant::samples {

inline double zero(const Point&, double) { return 0; }

using Scalar = std::function<double(const Point&, double time)>;

inline Coefficient coefficient(Scalar f) {
  return {[f = std::move(f)](const CoefficientPoint& at) { return f(at.place, at.time); }, "test"};
}

/// One fluid, no condition anywhere; curves between two faces follow the flow.
inline FlowProblem flow_problem(const Mesh& mesh, double density, double viscosity) {
  FlowProblem problem;
  problem.materials.assign(mesh.boundary().faces.size(), {Coefficient(density), Coefficient(viscosity)});
  const std::size_t curves = mesh.boundary().curves.size();
  problem.condition_of_curve.assign(curves, none);
  problem.tensions.resize(curves);
  for (const Curve& curve : mesh.boundary().curves)
    problem.motion_of_curve.push_back(curve.left == outside || curve.right == outside ? CurveMotion::stays
                                                                                      : CurveMotion::follows);
  return problem;
}

/// Adds a condition on all curves of one name.
inline void set_condition(FlowProblem& problem, const Mesh& mesh, const std::string& curve, FlowCondition condition) {
  for (std::size_t c = 0; c < mesh.boundary().curves.size(); ++c)
    if (mesh.boundary().curves[c].name == curve)
      problem.condition_of_curve[c] = static_cast<int>(problem.conditions.size());
  problem.conditions.push_back(std::move(condition));
}

inline void set_velocity(FlowProblem& problem, const Mesh& mesh, const std::vector<std::string>& curves,
                         const Scalar& u, const Scalar& v) {
  for (const std::string& curve : curves)
    set_condition(problem, mesh, curve,
                  {FlowCondition::Kind::velocity, coefficient(u), coefficient(v), "/problem/navierstokes/conditions"});
}

inline double error_of(const Mesh& mesh, const std::string& field, int component, const Scalar& exact,
                       bool of_gradient = false) {
  const std::vector<std::optional<Coefficient>> coefficients(mesh.boundary().faces.size(), coefficient(exact));
  const ErrorNorms norms = error_norms(mesh, field, coefficients, component);
  return of_gradient ? norms.h1 : norms.l2;
}

}  // namespace pliant::samples

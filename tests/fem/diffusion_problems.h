// tests/fem/diffusion_problems.h: problems made in code, solutions compared with formulas.
#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/fem/diffusion/diffusion.h"
#include "pliant/fem/element_values.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/symmetric_rule.h"

namespace pliant::samples {

using Formula = std::function<double(double x, double y, double t)>;

inline Coefficient coefficient(Formula formula, std::string name = "formula") {
  return Coefficient(
      [formula = std::move(formula)](const CoefficientPoint& at) { return formula(at.place.x, at.place.y, at.time); },
      std::move(name));
}

/// The field "c" on all faces, diffusivity 1, initially 0; conditions are added by name.
inline DiffusionProblem plain_problem(const BoundaryComplex& boundary) {
  DiffusionProblem problem;
  problem.field = "c";
  problem.materials.resize(boundary.faces.size());
  problem.initial.assign(boundary.faces.size(), Coefficient(0));
  problem.condition_of_curve.assign(boundary.curves.size(), none);
  return problem;
}

inline void add_condition(DiffusionProblem& problem, const BoundaryComplex& boundary, const std::string& curve,
                          DiffusionCondition::Kind kind, Coefficient first, Coefficient second = Coefficient(0)) {
  for (std::size_t c = 0; c < boundary.curves.size(); ++c)
    if (boundary.curves[c].name == curve) problem.condition_of_curve[c] = static_cast<int>(problem.conditions.size());
  problem.conditions.push_back({kind, std::move(first), std::move(second), "/conditions/" + curve});
}

/// Solves for the steady state; the report has fluxes, too.
inline PassReport solve_steady(const DiffusionProblem& problem, Mesh& mesh) {
  DiffusionOptions options;
  options.wants_fluxes = true;
  Diffusion diffusion(problem, mesh, options);
  diffusion.solve_steady();
  PassReport report;
  diffusion.report(report);
  return report;
}

/// The L2 norm of the difference between the field "c" and a formula, and of the difference of their gradients.
struct Errors {
  double l2 = 0, h1 = 0;
};
struct Exact {
  Formula value, along_x, along_y;
};
inline Errors errors_of(const Mesh& mesh, const Exact& exact, FaceId only = none) {
  int field = none;
  for (std::size_t f = 0; f < mesh.fields().size(); ++f)
    if (mesh.fields()[f].name == "c") field = static_cast<int>(f);
  const std::vector<double> values = element_values(mesh, field, 0);
  const int p = mesh.degree();
  const std::size_t n = index(mesh.net_size());
  Errors errors;
  std::vector<double> rows(3 * n);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (only != none && mesh.face(t) != only) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const Point& at = mesh.point(mesh.net(t)[k]);
      rows[3 * k] = at.x;
      rows[3 * k + 1] = at.y;
      rows[3 * k + 2] = values[index(t) * n + k];
    }
    for (const auto& [xi, weight] : symmetric_rule(std::min(4 * p + 6, 40))) {
      std::array<double, 3> value, d2, d3;
      evaluate_net(p, 3, rows, xi, value, d2, d3);
      const double det = d2[0] * d3[1] - d2[1] * d3[0];
      const double gx = (d2[2] * d3[1] - d3[2] * d2[1]) / det, gy = (d3[2] * d2[0] - d2[2] * d3[0]) / det;
      const double e = value[2] - exact.value(value[0], value[1], mesh.time);
      errors.l2 += weight * det * e * e;
      if (!exact.along_x) continue;
      const double ex = gx - exact.along_x(value[0], value[1], mesh.time);
      const double ey = gy - exact.along_y(value[0], value[1], mesh.time);
      errors.h1 += weight * det * (ex * ex + ey * ey);
    }
  }
  return {std::sqrt(errors.l2), std::sqrt(errors.h1)};
}

/// The observed order between two errors when sizes are halved.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace pliant::samples

// lib/pliant/fem/solve/conjugate_gradients.cpp: conjugate gradients with symmetric overrelaxation, in Eisenstat's form.
#include <cmath>

#include "pliant/fem/solve/gradients.h"
#include "pliant/fem/solve/residual.h"
#include "pliant/fem/solve/scaled_lower.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// The factor of overrelaxation: for M + dt K with 936,000 unknowns, dt = 1e-4, 92 iterations; 102 with 1, 97 with 1.5.
constexpr double relaxation = 1.3;

/// With A = L + I + L^T and G = I + w L, w A = G + G^T + (w - 2) I. Conjugate gradients run on w G^-1 A G^-T, which
/// costs one solution with G and one with G^T: no more than a product with A (Eisenstat 1981).
class ConjugateGradients : public LinearSolver {
 public:
  const char* name() const override { return "conjugate gradients"; }

  std::string factor(const CsrMatrix& a) override {
    a_ = &a;
    return lower_.set(a, relaxation);
  }

  SolveOutcome solve(std::span<const double> b, std::span<double> x, double tolerance) const override {
    return correct(*a_, b, x, tolerance, false,
                   [&](std::span<const double> r, double residual, std::span<double> y, std::string& why) {
                     return step(r, tolerance / residual, y, why);
                   });
  }

 private:
  int step(std::span<const double> r, double reduction, std::span<double> x, std::string& why) const {
    const std::size_t n = r.size();
    std::vector<double> scaled(n), y(n), inner(n);
    const double unit = nearest_power_of_two(norm(r));
    for (std::size_t i = 0; i < n; ++i) scaled[i] = relaxation * lower_.scaling[i] * (r[i] / unit);
    // Out of range only where rows differ by far more than numbers have digits.
    const double size = norm(scaled);
    const double inner_unit = size > 0 && std::isfinite(size) ? nearest_power_of_two(size) : 1;
    for (double& value : scaled) value /= inner_unit;
    lower_.forward(scaled);
    GradientsProblem problem;
    problem.apply = [&](std::span<const double> v, std::span<double> image) {
      std::ranges::copy(v, inner.begin());
      lower_.backward(inner);
      for (std::size_t i = 0; i < n; ++i) image[i] = v[i] + (relaxation - 2) * inner[i];
      lower_.forward(image);
      for (std::size_t i = 0; i < n; ++i) image[i] += inner[i];
    };
    problem.original_norm = [&](std::span<const double> v) {
      lower_.lower_product(v, inner);
      for (std::size_t i = 0; i < n; ++i) inner[i] = (v[i] + inner[i]) / lower_.scaling[i];
      return norm(inner);
    };
    problem.norm_is_costly = true;
    const int iterations = conjugate_gradients(problem, scaled, y, reduction, why);
    lower_.backward(y);
    for (std::size_t i = 0; i < n; ++i) x[i] += lower_.scaling[i] * (y[i] * inner_unit) * unit;
    return iterations;
  }

  const CsrMatrix* a_ = nullptr;
  ScaledLower lower_;  // w L
};

}  // namespace

std::unique_ptr<LinearSolver> make_conjugate_gradients() { return std::make_unique<ConjugateGradients>(); }

}  // namespace pliant

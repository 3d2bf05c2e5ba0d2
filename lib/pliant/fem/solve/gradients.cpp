// lib/pliant/fem/solve/gradients.cpp: conjugate gradients; sums are those of `dot`, in a fixed order.
#include "pliant/fem/solve/gradients.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/fem/csr_matrix.h"

namespace pliant {
namespace {

/// No more iterations than this, however many unknowns: at a million of them, some five minutes.
constexpr int most_iterations = 20000;
/// A small system may take so many for each unknown: rounding spoils that n steps end it.
constexpr std::size_t iterations_per_row = 10;
/// Iterations stop where so many have not lowered the least residual: rounding, or a matrix that is singular.
constexpr int patience = 500;
/// A costly norm is asked for again when r has fallen this far below what is expected to do.
constexpr double caution = 0.9;

}  // namespace

int conjugate_gradients(const GradientsProblem& problem, std::span<double> r, std::span<double> y, double reduction,
                        std::string& why) {
  const std::size_t n = r.size();
  const int limit = static_cast<int>(std::min<std::size_t>(most_iterations, iterations_per_row * n + 100));
  std::vector<double> direction(n), image(n), own;
  std::span<double> z = r;
  if (problem.precondition) {
    own.resize(n);
    z = own;
    problem.precondition(r, z);
  }
  std::ranges::fill(y, 0);
  std::ranges::copy(z, direction.begin());
  const double target = reduction * problem.original_norm(r);
  double product = dot(r, z), least = HUGE_VAL;
  // The original norm, relative to that of r: as it was when last asked for.
  double ratio = problem.original_norm(r) / norm(r);
  int since_least = 0;
  for (int iteration = 1;; ++iteration) {
    problem.apply(direction, image);
    const double curvature = dot(direction, image);
    if (!(curvature > 0) || !(product > 0) || !std::isfinite(curvature) || !std::isfinite(product)) {
      why = curvature <= 0 || product <= 0 ? "the matrix is not positive definite, or singular up to rounding"
                                           : "numbers leave their range";
      return iteration;
    }
    const double step = product / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      y[i] += step * direction[i];
      r[i] -= step * image[i];
    }
    double size = 0;
    if (!problem.norm_is_costly) {
      size = problem.original_norm(r);
      if (size <= target) return iteration;
    } else {
      size = norm(r);
      if (size * ratio <= caution * target || size == 0) {
        const double original = problem.original_norm(r);
        if (original <= target) return iteration;
        ratio = original / size;
      }
    }
    since_least = size < least ? 0 : since_least + 1;
    least = std::min(least, size);
    if (since_least >= patience || iteration >= limit) {
      why = "conjugate gradients do not get further";
      return iteration;
    }
    if (problem.precondition) problem.precondition(r, z);
    const double next = dot(r, z), share = next / product;
    product = next;
    for (std::size_t i = 0; i < n; ++i) direction[i] = z[i] + share * direction[i];
  }
}

}  // namespace pliant

// lib/pliant/fem/solve/residual.cpp: residuals, corrections as long as they help, scaling by powers of two.
#include "pliant/fem/solve/residual.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// As many corrections at most; each but the last halves the residual, so that 1e-12 needs 40 at the worst.
constexpr int most_corrections = 60;

std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// | |A||x| + |b| |, row by row.
double rounding_level(const CsrMatrix& a, std::span<const double> b, std::span<const double> x,
                      std::span<double> levels) {
  const CsrPattern& pattern = *a.pattern;
  for (std::size_t i = 0; i < b.size(); ++i) {
    double sum = std::abs(b[i]);
    for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k)
      sum += std::abs(a.values[index(k)] * x[index(pattern.columns[index(k)])]);
    levels[i] = sum;
  }
  return norm(levels);
}

std::string why_not(const SolveOutcome& outcome, double tolerance, const std::string& reason) {
  std::string text = "the residual stays at " + figure(outcome.residual) + " of the right-hand side";
  if (outcome.iterations > 0) text += " after " + std::to_string(outcome.iterations) + " iterations";
  if (outcome.refinements > 0)
    text += std::string(outcome.iterations > 0 ? " and " : " after ") + std::to_string(outcome.refinements) +
            (outcome.refinements == 1 ? " refinement" : " refinements");
  text += "; " + figure(tolerance) + " was asked for, and rounding may leave " + figure(outcome.rounding);
  if (!reason.empty()) return text + ": " + reason;
  return outcome.rounding > greatest_rounding ? text + ": the matrix is singular up to rounding" : text;
}

}  // namespace

std::string refuse_non_finite(const CsrMatrix& a) {
  assert(a.values.size() == a.pattern->columns.size());
  for (int i = 0; i < a.rows(); ++i)
    for (int k = a.pattern->starts[index(i)]; k < a.pattern->starts[index(i) + 1]; ++k)
      if (!std::isfinite(a.values[index(k)]))
        return "the matrix is not finite in row " + std::to_string(i) + ", column " +
               std::to_string(a.pattern->columns[index(k)]);
  return {};
}

std::string refuse_non_finite(std::span<const double> values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) return what + " is not finite in row " + std::to_string(i);
  return {};
}

double true_residual(const CsrMatrix& a, std::span<const double> b, std::span<const double> x, std::span<double> r) {
  const CsrPattern& pattern = *a.pattern;
  for (std::size_t i = 0; i < b.size(); ++i) {
    double sum = b[i];
    for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k)
      sum -= a.values[index(k)] * x[index(pattern.columns[index(k)])];
    r[i] = sum;
  }
  return norm(r) / norm(b);
}

SolveOutcome correct(const CsrMatrix& a, std::span<const double> b, std::span<double> x, double tolerance,
                     bool starts_at_zero, const Correction& correction) {
  assert(index(a.rows()) == b.size() && b.size() == x.size());
  SolveOutcome outcome;
  outcome.residual = HUGE_VAL;
  outcome.why = refuse_non_finite(b, "the right-hand side");
  if (outcome.why.empty() && !starts_at_zero) outcome.why = refuse_non_finite(x, "the guess");
  if (!outcome.why.empty()) return outcome;
  if (std::ranges::all_of(b, [](double value) { return value == 0; })) {
    std::ranges::fill(x, 0);
    outcome.residual = 0;
    outcome.converged = true;
    return outcome;
  }
  if (starts_at_zero) std::ranges::fill(x, 0);
  const double size = norm(b);
  if (!std::isfinite(size)) {
    outcome.why = "the norm of the right-hand side is out of range";
    return outcome;
  }
  std::vector<double> r(b.begin(), b.end());
  outcome.residual = starts_at_zero ? 1 : true_residual(a, b, x, r);
  // A guess that is worse than 0 is none.
  if (starts_at_zero || !(outcome.residual <= 1)) {
    std::ranges::fill(x, 0);
    std::ranges::copy(b, r.begin());
    outcome.residual = 1;
  }
  std::vector<double> best(x.begin(), x.end()), levels;
  std::string reason;
  const auto rounding_of = [&](std::span<const double> solution) {
    levels.resize(b.size());
    return rounding_factor * (rounding_level(a, b, solution, levels) / size);
  };
  const auto is_rounding = [&] {
    outcome.rounding = rounding_of(best);
    return outcome.residual <= outcome.rounding;
  };
  for (int corrections = 0; outcome.residual > tolerance && corrections <= most_corrections; ++corrections) {
    if (corrections > 0 && is_rounding()) break;
    outcome.refinements = corrections;
    outcome.iterations += correction(r, outcome.residual, x, reason);
    const double residual = true_residual(a, b, x, r);
    const bool helps = residual <= outcome.residual / 2;
    if (residual < outcome.residual) {
      outcome.residual = residual;
      std::ranges::copy(x, best.begin());
    }
    if (!helps && reason.empty() && !(rounding_of(x) <= greatest_rounding))
      reason = "the matrix is singular up to rounding";
    if (!reason.empty() || !helps) break;
  }
  std::ranges::copy(best, x.begin());
  outcome.converged = outcome.residual <= tolerance || (is_rounding() && outcome.rounding <= greatest_rounding);
  if (!outcome.converged) outcome.why = why_not(outcome, tolerance, reason);
  return outcome;
}

void LinearSolver::apply(std::span<const double> b, std::span<double> x) const {
  std::ranges::fill(x, 0);
  solve(b, x, approximate_tolerance);
}

double nearest_power_of_two(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // from 1/2 to 1
  return std::ldexp(1.0, fraction < std::sqrt(0.5) ? exponent - 1 : exponent);
}

std::vector<double> symmetric_scaling(const CsrMatrix& a) {
  const CsrPattern& pattern = *a.pattern;
  std::vector<double> diagonal(index(a.rows()), 0), scaling(index(a.rows()), 1);
  for (int i = 0; i < a.rows(); ++i)
    if (const int k = pattern.find(i, i); k >= 0) diagonal[index(i)] = a.values[index(k)];
  // Square roots first: products of entries of 1e-150 would leave the range.
  for (std::size_t i = 0; i < scaling.size(); ++i) {
    double root = std::sqrt(std::abs(diagonal[i]));
    if (diagonal[i] <= 0) {
      double greatest = 0, sum = 0;  // of squares, in units of the greatest
      for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k) {
        const double other = diagonal[index(pattern.columns[index(k)])];
        if (!(other > 0) || a.values[index(k)] == 0) continue;
        const double term = std::abs(a.values[index(k)]) / std::sqrt(other);
        if (term > greatest) {
          sum = sum * (greatest / term) * (greatest / term) + 1;
          greatest = term;
        } else {
          sum += (term / greatest) * (term / greatest);
        }
      }
      root = std::max(root, greatest * std::sqrt(sum));
    }
    if (root > 0) scaling[i] = 1 / nearest_power_of_two(root);
  }
  return scaling;
}

}  // namespace pliant

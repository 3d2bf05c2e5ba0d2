// lib/pliant/fem/solve/gmres.cpp: Arnoldi's process, rotations, and cycles from the true residual.
#include "pliant/fem/solve/gmres.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pliant/fem/solve/residual.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// A direction of which less than this is left once the others are taken out was in their span.
constexpr double nothing_new = 0x1p-50;
/// Where less than this is left, cancellation has spoilt the directions' being orthogonal: they are taken out again.
constexpr double much_taken_out = 0.1;

struct Rotation {
  double cosine, sine;
  void turn(double& a, double& b) const { std::tie(a, b) = std::pair(cosine * a + sine * b, cosine * b - sine * a); }
};

/// One cycle from the residual r, until its norm has fallen by `reduction` or `most` iterations are made. Rows are
/// scaled, so that great ones, as those of a great viscosity, do not hide what is left in others.
class Cycle {
 public:
  Cycle(const CsrMatrix& a, const LinearSolver& preconditioner, const std::vector<double>& scaling,
        std::span<const double> r)
      : a_(a), preconditioner_(preconditioner), scaling_(scaling), left_{1} {
    basis_.emplace_back(r.begin(), r.end());
    for (std::size_t i = 0; i < r.size(); ++i) basis_.back()[i] *= scaling_[i];
    unit_ = norm(basis_.back());
    for (double& each : basis_.back()) each /= unit_;
  }

  /// Returns     iterations; `why` says what stopped them, where it was neither the reduction nor their number
  int run(int most, double reduction, std::string& why) {
    int iterations = 0;
    while (iterations < most && std::abs(left_.back()) > reduction) {
      ++iterations;
      if (!extend(why)) break;
    }
    return iterations;
  }

  /// Adds the combination of directions that leaves the least residual.
  void add_to(std::span<double> x) const {
    std::vector<double> shares(columns_.size());
    for (std::size_t k = shares.size(); k-- > 0;) {
      double sum = left_[k];
      for (std::size_t j = k + 1; j < shares.size(); ++j) sum -= columns_[j][k] * shares[j];
      shares[k] = sum / columns_[k][k];
    }
    for (std::size_t k = 0; k < shares.size(); ++k)
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += unit_ * (shares[k] * directions_[k][i]);
  }

 private:
  /// One direction more. Returns     false where there is none, with nothing changed; or where it was the last
  bool extend(std::string& why) {
    std::vector<double> direction(basis_.back().size()), image(direction.size());
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = basis_.back()[i] / scaling_[i];
    preconditioner_.apply(image, direction);
    multiply(a_, direction, image);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] *= scaling_[i];
    const double size = norm(image);
    if (!std::isfinite(size) || size == 0) {
      why = size == 0 ? "the matrix is singular, or its preconditioner is" : "numbers leave their range";
      return false;
    }
    std::vector<double> column(basis_.size(), 0.0);
    double rest = take_out(image, column);
    if (rest < much_taken_out * size) rest = take_out(image, column);
    const bool is_last = rest <= nothing_new * size;
    if (is_last) rest = 0;
    for (std::size_t k = 0; k < rotations_.size(); ++k) rotations_[k].turn(column[k], column[k + 1]);
    const double length = std::hypot(column.back(), rest);
    if (length <= nothing_new * size) {
      why = "the matrix is singular up to rounding";
      return false;
    }
    rotations_.push_back({column.back() / length, rest / length});
    column.back() = length;
    columns_.push_back(std::move(column));
    directions_.push_back(std::move(direction));
    left_.push_back(0);
    rotations_.back().turn(left_[left_.size() - 2], left_.back());
    if (is_last) return false;
    for (double& each : image) each /= rest;
    basis_.push_back(std::move(image));
    return true;
  }

  /// Makes an image orthogonal to the basis, and adds to `column` what was taken out. Returns     the norm of the rest
  double take_out(std::span<double> image, std::span<double> column) const {
    for (std::size_t k = 0; k < basis_.size(); ++k) {
      const double share = dot(basis_[k], image);
      column[k] += share;
      for (std::size_t i = 0; i < image.size(); ++i) image[i] -= share * basis_[k][i];
    }
    return norm(image);
  }

  const CsrMatrix& a_;
  const LinearSolver& preconditioner_;
  const std::vector<double>& scaling_;
  double unit_;                                  // norm of the first residual, scaled
  std::vector<std::vector<double>> basis_;       // of residuals, orthonormal
  std::vector<std::vector<double>> directions_;  // of solutions: the preconditioner's
  std::vector<std::vector<double>> columns_;     // of the triangular factor of Hessenberg's matrix
  std::vector<Rotation> rotations_;
  std::vector<double> left_;  // the first residual in the basis, rotated; the last one is what is left, in units
};

}  // namespace

SolveOutcome solve_by_gmres(const CsrMatrix& a, const LinearSolver& preconditioner, std::span<const double> b,
                            std::span<double> x, const GmresOptions& options) {
  assert(options.restart > 0);
  SolveOutcome refused;
  refused.residual = HUGE_VAL;
  refused.why = refuse_non_finite(a);
  if (!refused.why.empty()) return refused;
  const std::vector<double> scaling = symmetric_scaling(a);
  int remaining = options.most_iterations;
  return correct(a, b, x, options.tolerance, false,
                 [&](std::span<const double> r, double residual, std::span<double> y, std::string& why) {
                   if (remaining <= 0) {
                     why = "GMRES does not get there";
                     return 0;
                   }
                   Cycle cycle(a, preconditioner, scaling, r);
                   const int iterations =
                       cycle.run(std::min(remaining, options.restart), options.tolerance / residual, why);
                   cycle.add_to(y);
                   remaining -= iterations;
                   return iterations;
                 });
}

}  // namespace pliant

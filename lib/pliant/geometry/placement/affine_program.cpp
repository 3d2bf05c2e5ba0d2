// lib/pliant/geometry/placement/affine_program.cpp: dual simplex in three variables.
#include "pliant/geometry/placement/affine_program.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Row = Eigen::Vector3d;

constexpr double tolerance = 1e-13;  // a constraint that is violated by less holds; a multiplier below it is 0
constexpr int most_pivots = 200;

/// The constraints row . (x, y, value) <= limit: one for each function, then one for each side of the square.
class Constraints {
 public:
  Constraints(std::span<const AffineFunction> functions, double reach) : functions_(functions), reach_(reach) {}
  int functions() const { return static_cast<int>(functions_.size()); }
  Row row(int i) const {
    const int side = i - functions();
    if (side >= 0) return side < 2 ? Row(side == 0 ? 1.0 : -1.0, 0, 0) : Row(0, side == 2 ? 1.0 : -1.0, 0);
    const AffineFunction& f = functions_[index(i)];
    return Row(-f.a, -f.b, 1);
  }
  double limit(int i) const { return i < functions() ? functions_[index(i)].c : reach_; }

  /// The constraint that z breaks most, or -1.
  int most_violated(const Row& z) const {
    int worst = -1;
    double most = tolerance * std::max(1.0, std::fabs(z[2]));
    const Point q{z[0], z[1]};
    for (int i = 0; i < functions(); ++i)
      if (const double excess = z[2] - functions_[index(i)](q); excess > most) {
        most = excess;
        worst = i;
      }
    const std::array<double, 4> sides{z[0], -z[0], z[1], -z[1]};
    for (int side = 0; side < 4; ++side)
      if (const double excess = sides[static_cast<std::size_t>(side)] - reach_;
          excess > std::max(most, tolerance * reach_)) {
        most = excess;
        worst = functions() + side;
      }
    return worst;
  }

 private:
  std::span<const AffineFunction> functions_;
  double reach_;
};

/// Three constraints that hold with equality.
struct Basis {
  std::array<int, 3> members;
  Eigen::Matrix3d rows, inverse;
  Eigen::Vector3d limits;

  void take(const Constraints& constraints) {
    for (int i = 0; i < 3; ++i) {
      rows.row(i) = constraints.row(members[index(i)]);
      limits[i] = constraints.limit(members[index(i)]);
    }
    inverse = rows.inverse();
  }
  Row vertex() const {
    const Row z = inverse * limits;
    // One step of iterative refinement, so that the three hold to rounding even where they are nearly parallel.
    return z + inverse * (limits - rows * z);
  }
  /// The factors with which the members' rows add up to `row`.
  std::array<double, 3> shares_of(const Row& row) const {
    const Row shares = inverse.transpose() * row;
    return {shares[0], shares[1], shares[2]};
  }
};

/// The place nearest to `near` where all functions are at least `level`, from half-planes that are added one by one.
/// `known` is such a place; it is the answer where rounding leaves no other, or none that is nearer.
Point nearest_at_level(std::span<const AffineFunction> functions, double level, const Point& near, const Point& known) {
  Point best = near;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const AffineFunction& f = functions[i];
    if (f(best) >= level) continue;
    const double square = f.a * f.a + f.b * f.b;
    if (square == 0) return known;
    // On the line f = level: foot + s direction; the half-planes before this one leave an interval of s.
    const Point foot = near + (level - f(near)) / square * Point{f.a, f.b};
    const Vector direction{-f.b, f.a};
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t j = 0; j < i; ++j) {
      const AffineFunction& g = functions[j];
      const double slope = g.a * direction.x + g.b * direction.y, gap = level - g(foot);
      if (slope > 0)
        low = std::max(low, gap / slope);
      else if (slope < 0)
        high = std::min(high, gap / slope);
      else if (gap > 0)
        return known;
    }
    if (low > high) return known;
    best = foot + std::clamp(0.0, low, high) * direction;
  }
  return squared_length(best - near) < squared_length(known - near) ? best : known;
}

}  // namespace

AffineOptimum maximise_least(std::span<const AffineFunction> functions, double reach, const Point& near) {
  assert(!functions.empty());
  const Constraints constraints(functions, reach);
  const auto least = std::min_element(functions.begin(), functions.end(),
                                      [](const AffineFunction& f, const AffineFunction& g) { return f.c < g.c; });
  const int first_side = constraints.functions();
  Basis basis;
  basis.members = {static_cast<int>(least - functions.begin()), first_side + (least->a > 0 ? 0 : 1),
                   first_side + (least->b > 0 ? 2 : 3)};
  Row z;
  std::array<double, 3> shares;
  for (int steps = 0;; ++steps) {
    basis.take(constraints);
    z = basis.vertex();
    shares = basis.shares_of(Row::UnitZ());
    const int entering = constraints.most_violated(z);
    if (entering < 0 || steps == most_pivots) break;
    const std::array<double, 3> mixture = basis.shares_of(constraints.row(entering));
    std::size_t leaving = 3;
    double ratio = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      if (mixture[i] <= tolerance) continue;
      const double candidate = std::max(shares[i], 0.0) / mixture[i];
      const bool tie = leaving < 3 && std::fabs(candidate - ratio) <= tolerance;
      if (tie ? mixture[i] > mixture[leaving] : candidate < ratio) {
        leaving = i;
        ratio = candidate;
      }
    }
    if (leaving == 3) break;  // only rounding leads here, because there always is an optimum in the square
    basis.members[leaving] = entering;
  }

  AffineOptimum result{{z[0], z[1]}, z[2], basis.members, shares, true};
  bool unique = true;
  for (std::size_t i = 0; i < 3; ++i) {
    unique = unique && shares[i] > 1e-9;
    if (basis.members[i] < first_side) continue;
    result.active[i] = -1;
    if (shares[i] > 1e-9) result.bounded = false;
  }
  // The value is computed anew at the place, so that it is true there whatever rounding did.
  const auto value_at = [functions](const Point& q) {
    double value = std::numeric_limits<double>::infinity();
    for (const AffineFunction& f : functions) value = std::min(value, f(q));
    return value;
  };
  result.value = value_at(result.place);
  if (!unique) {
    const double slack = 1e-11 * std::max(1.0, std::fabs(result.value));
    const Point nearest = nearest_at_level(functions, result.value - slack, near, result.place);
    if (const double value = value_at(nearest); value >= result.value - 2 * slack) {
      result.place = nearest;
      result.value = value;
    }
  }
  return result;
}

}  // namespace pliant

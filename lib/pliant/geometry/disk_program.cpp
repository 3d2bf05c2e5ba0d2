#include "pliant/geometry/disk_program.h"  // lib/pliant/geometry/disk_program.cpp: exchange of at most three disks

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pliant {
namespace {

// Throughout, `level` is s = 1 / t >= 1: the disk of a function at level s has centre base + s v and radius
// |v| sqrt(s^2 - 1), and grows with s.
constexpr double slack = 1e-11;
constexpr int most_exchanges = 60;

struct Meeting {
  Point place;
  double level;
};

Point centre(const ShapeFunction& f, double level) { return f.base + level * f.v; }

bool contains(const ShapeFunction& f, const Meeting& at) { return f(at.place) * at.level >= 1 - 10 * slack; }

/// Where the growing disks of two functions first touch: |c1 - c2| = r1 + r2 is a quadratic equation for the level.
std::optional<Meeting> meeting(const ShapeFunction& f, const ShapeFunction& g) {
  const Vector between = g.base - f.base, drift = g.v - f.v;
  const double reach_f = length(f.v), reach_g = length(g.v), reach = reach_f + reach_g;
  // reach^2 - |drift|^2, without cancellation where the two point in nearly opposite directions.
  const double along = dot(f.v, g.v), product = reach_f * reach_g, across = cross(f.v, g.v);
  const double a = 2 * (along > 0 ? product + along : across * across / (product - along));
  const double half_b = dot(between, drift);
  const double c = reach * reach + squared_length(between);
  if (!(a > 1e-24 * reach * reach)) return std::nullopt;  // opposite directions: never both positive
  const double root = std::sqrt(half_b * half_b + a * c);
  const double level = half_b >= 0 ? (half_b + root) / a : c / (root - half_b);
  const Point from = centre(f, level);
  return Meeting{from + reach_f / reach * (centre(g, level) - from), level};
}

using Three = std::array<const ShapeFunction*, 3>;

/// The common point of three circles near `start`, by Newton's method on (place, level); empty unless it is the
/// optimum, that is unless some mean of the three gradients vanishes there.
std::optional<Meeting> newton(const Three& three, Meeting at) {
  for (int steps = 0; steps < 12; ++steps) {
    // |r|^2 - 2 s v.r + |v|^2 = 0; divided by 2 v.r the equation says 1 / tau = s, of which we take gradients.
    std::array<Vector, 3> slope;
    std::array<double, 3> value;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector r = at.place - three[i]->base;
      const double height = dot(three[i]->v, r);
      if (!(height > 0)) return std::nullopt;
      value[i] = (squared_length(r) + squared_length(three[i]->v)) / (2 * height);
      slope[i] = (r - value[i] * three[i]->v) / height;
    }
    const Vector u = slope[1] - slope[0], v = slope[2] - slope[0];
    const double determinant = cross(u, v);
    const double rise_1 = value[0] - value[1], rise_2 = value[0] - value[2];
    const Vector move = Vector{rise_1 * v.y - rise_2 * u.y, rise_2 * u.x - rise_1 * v.x} / determinant;
    if (!is_finite(move)) return std::nullopt;
    at.place += move;
    at.level = value[0] + dot(slope[0], move);
    if (std::max(std::fabs(rise_1), std::fabs(rise_2)) > 1e-13 * at.level) continue;
    const double share_1 = cross(slope[2], slope[0]), share_2 = cross(slope[0], slope[1]);
    const double share_0 = cross(slope[1], slope[2]), sign = share_0 + share_1 + share_2;
    const double least = std::min({share_0 * sign, share_1 * sign, share_2 * sign});
    if (least < -1e-9 * sign * sign) return std::nullopt;
    return at;
  }
  return std::nullopt;
}

/// The optimum of three disks that no two of them determine. Bisection of the level comes close to it until Newton's
/// method takes over: three disks have a point in common if one's centre, or a point where two circles cross, lies in
/// all.
std::optional<Meeting> meeting_of_three(const Three& three, const Meeting& below) {
  const auto common_point = [&three](double level) -> std::optional<Point> {
    std::array<Point, 9> candidates;
    std::size_t count = 0;
    const double growth = std::sqrt(std::max(0.0, level * level - 1));
    for (std::size_t i = 0; i < 3; ++i) {
      const ShapeFunction &f = *three[i], &g = *three[(i + 1) % 3];
      const Point c = centre(f, level);
      const Vector offset = centre(g, level) - c;
      const double r = length(f.v) * growth, q = length(g.v) * growth, square = squared_length(offset);
      candidates[count++] = c;
      if (square == 0) continue;
      const double along = (square + r * r - q * q) / (2 * square);
      const double across = std::sqrt(std::max(0.0, r * r / square - along * along));
      candidates[count++] = c + along * offset + across * perpendicular(offset);
      candidates[count++] = c + along * offset - across * perpendicular(offset);
    }
    for (std::size_t i = 0; i < count; ++i)
      if (std::all_of(three.begin(), three.end(), [&](const ShapeFunction* f) {
            return contains(*f, {candidates[i], level});
          }))
        return candidates[i];
    return std::nullopt;
  };
  if (const auto at = newton(three, below)) return at;
  double low = below.level, high = 1.25 * low;
  std::optional<Point> found;
  while (!(found = common_point(high))) {
    low = high;
    if ((high *= 3) > 1e12) return std::nullopt;
  }
  for (int steps = 0; steps < 60 && high - low > slack * high; ++steps) {
    if (const auto at = steps % 4 == 0 ? newton(three, {*found, high}) : std::nullopt) return at;
    const double middle = (low + high) / 2;
    if (const auto place = common_point(middle)) {
      found = place;
      high = middle;
    } else {
      low = middle;
    }
  }
  return Meeting{*found, high};
}

}  // namespace

std::optional<DiskOptimum> maximise_least(std::span<const ShapeFunction> functions, DiskBasis& basis) {
  assert(!functions.empty());
  for (const ShapeFunction& f : functions)
    if (f.v == Vector{}) return std::nullopt;
  const auto worst_at = [functions](const Point& q) {
    std::size_t worst = 0;
    double least = functions[0](q);
    for (std::size_t i = 1; i < functions.size(); ++i)
      if (const double value = functions[i](q); value < least) {
        least = value;
        worst = i;
      }
    return std::pair{worst, least};
  };

  if (basis.count == 0) {
    const std::size_t first = worst_at({}).first;
    basis = {{first, 0, 0}, 1, centre(functions[first], 1), 1};
  }
  DiskOptimum best{basis.place, -1};
  for (int exchanges = 0; exchanges < most_exchanges; ++exchanges) {
    const auto [entering, least] = worst_at(basis.place);
    if (least > best.value) best = {basis.place, least};
    const std::span<const std::size_t> members(basis.members.data(), basis.count);
    if (least * basis.level >= 1 - slack || std::find(members.begin(), members.end(), entering) != members.end()) break;

    // The optimum of basis and newcomer has the newcomer in its basis: alone with one of the others, or with two.
    const ShapeFunction& h = functions[entering];
    const auto holds = [&](const Meeting& candidate) {
      return std::all_of(members.begin(), members.end(),
                         [&](std::size_t i) { return contains(functions[i], candidate); });
    };
    std::optional<DiskBasis> next;
    std::array<Meeting, 3> pairs;
    for (std::size_t i = 0; !next && i < members.size(); ++i) {
      const auto pair = meeting(functions[members[i]], h);
      if (!pair) return std::nullopt;
      pairs[i] = *pair;
      if (holds(*pair)) next = {{members[i], entering, 0}, 2, pair->place, pair->level};
    }
    for (std::size_t i = 0; !next && i < members.size(); ++i)
      for (std::size_t j = i + 1; !next && j < members.size(); ++j) {
        const Three three{&functions[members[i]], &functions[members[j]], &h};
        const auto triple = meeting_of_three(three, pairs[i].level > pairs[j].level ? pairs[i] : pairs[j]);
        if (triple && holds(*triple)) next = {{members[i], members[j], entering}, 3, triple->place, triple->level};
      }
    if (!next) break;  // rounding: the best so far
    basis = *next;
  }
  if (!(best.value > 0)) return std::nullopt;
  return best;
}

}  // namespace pliant

// lib/pliant/geometry/placement/disk_program.cpp: exchange of at most three disks.
#include "pliant/geometry/placement/disk_program.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pliant {
namespace {

// The disk of a function f at t, {f >= t}, has centre base + v / t and radius |v| sqrt(1 / t^2 - 1); it shrinks to a
// point at t = 1 and fills a half-plane at t = 0. A computed value of f is wrong by some 1e-16, however small it is,
// and by what rounding q to doubles changes.
constexpr int most_exchanges = 60;
constexpr double greatest_level = 1e11;  // a level is 1 / t; if two disks only meet at a greater one, no place is good
/// How far a computed value near t may be off.
double rounding_at(double t) { return 1e-15 + 1e-12 * t; }
/// The same for one function at a place where |r|^2 + |v|^2 is `square`, so that its slope is at most 2 / sqrt(square).
double rounding_at(double t, const Point& place, double square) {
  return rounding_at(t) + 1e-15 * std::sqrt((squared_length(place) + 1) / square);
}

/// A place where two or three functions have the same value.
struct Meeting {
  Point place;
  double value;
};

/// Whether the disk of f at the value of a meeting contains its place, up to rounding.
bool contains(const ShapeFunction& f, const Meeting& at) {
  const Vector r = at.place - f.base;
  const double square = squared_length(r) + squared_length(f.v);
  return 2 * dot(f.v, r) >= (at.value - 10 * rounding_at(at.value, at.place, square)) * square;
}

/// Where the disks of two functions first touch as t falls: |c1 - c2| = r1 + r2 is a quadratic equation for 1 / t.
std::optional<Meeting> meeting(const ShapeFunction& one, const ShapeFunction& other) {
  // The place is computed relative to the base of the smaller disk, which is the nearer base.
  const bool is_ordered = squared_length(one.v) <= squared_length(other.v);
  const ShapeFunction &f = is_ordered ? one : other, &g = is_ordered ? other : one;
  const double size_f = std::sqrt(squared_length(f.v)), size_g = std::sqrt(squared_length(g.v));
  const Vector between = g.base - f.base, drift = g.v - f.v;
  const double sizes = size_f + size_g, product = size_f * size_g;
  // a = sizes^2 - |drift|^2, without cancellation where the two v have nearly opposite directions.
  const double cosine = dot(f.v, g.v), sine = cross(f.v, g.v);
  const double a = 2 * (cosine > 0 ? product + cosine : sine * sine / (product - cosine));
  const double half_b = dot(between, drift), c = sizes * sizes + squared_length(between);
  const double root = std::sqrt(half_b * half_b + a * c);
  const double level = half_b >= 0 ? (half_b + root) / a : c / (root - half_b);
  if (!(level < greatest_level)) return std::nullopt;
  // (x, y) is the way from the centre of f to that of g, in the frame of f.v, divided by the level. The place is
  // base + level v + radius (unit vector along this way). However great the level is, the place is near the base if
  // that vector is nearly -v / |v|, so the terms that cancel are combined first.
  const Vector unit = f.v / size_f;
  const double x = (cosine + dot(between, f.v) / level) / size_f - size_f;
  const double y = (sine + cross(f.v, between) / level) / size_f;
  const double way = std::sqrt(x * x + y * y), far = level * size_f;
  const double along = x < 0 ? y * y / (way * (way - x)) : 1 + x / way, across = y / way;
  const double less = size_f / (level + std::sqrt(std::max(0.0, level * level - 1)));
  const Vector local{far * along - less * (x / way), (far - less) * across};
  if (way == 0) return Meeting{f.base + level * f.v, 1 / level};
  return Meeting{f.base + local.x * unit + local.y * perpendicular(unit), 1 / level};
}

using Three = std::array<const ShapeFunction*, 3>;

enum class Found {
  optimum,  ///< the three are equal there, and it is their optimum
  other,    ///< the three are equal there, but it is not their optimum
  nothing   ///< no such place was found
};

/// Moves `at` to where three functions are equal, by Newton's method on (place, value). That is their optimum if some
/// mean of the three gradients vanishes there.
Found newton(const Three& three, Meeting& at) {
  for (int steps = 0; steps < 12; ++steps) {
    std::array<Vector, 3> slope;
    std::array<double, 3> value;
    double least_square = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector r = at.place - three[i]->base, &v = three[i]->v;
      const double square = squared_length(r) + squared_length(v), by = 2 / square;
      least_square = std::min(least_square, square);
      value[i] = by * dot(v, r);
      slope[i] = by * (v - value[i] * r);
    }
    const double rise_1 = value[0] - value[1], rise_2 = value[0] - value[2];
    const Vector u = slope[1] - slope[0], v = slope[2] - slope[0];
    const double share_1 = cross(slope[2], slope[0]), share_2 = cross(slope[0], slope[1]);
    const double share_0 = cross(slope[1], slope[2]), sum = share_0 + share_1 + share_2;  // = cross(u, v)
    const Vector move = Vector{rise_1 * v.y - rise_2 * u.y, rise_2 * u.x - rise_1 * v.x} / sum;
    if (!(squared_length(move) < 1e8)) return Found::nothing;
    const double rounding = rounding_at(value[0], at.place, least_square);
    at.place += move;
    at.value = value[0] + dot(slope[0], move);
    if (std::max(std::fabs(rise_1), std::fabs(rise_2)) > rounding) continue;
    const double least = std::min({share_0 * sum, share_1 * sum, share_2 * sum});
    return at.value > 0 && least >= -1e-14 * sum * sum ? Found::optimum : Found::other;
  }
  return Found::nothing;
}

/// The optimum of three functions that no two of them determine, for when Newton's method fails: by Dinkelbach's method
/// and bisection. For a given t the functions 2 v.r - t (|r|^2 + |v|^2) are affine, apart from the term -t |q|^2, which
/// all three have. The place where the least of them is greatest is one of seven: the summit of one, the best place
/// where two are equal, or the place where three are. The least is positive there if t is less than the optimum.
std::optional<Meeting> search_meeting(const Three& three, double most) {
  Meeting best{{}, 0};
  double high = most;
  for (int steps = 0; steps < 120 && high - best.value > rounding_at(high); ++steps) {
    const double t = steps % 2 == 0 || best.value == 0 ? (best.value + high) / 2 : best.value;
    std::array<Vector, 3> slope;
    std::array<double, 3> constant;
    for (std::size_t i = 0; i < 3; ++i) {
      const ShapeFunction& f = *three[i];
      slope[i] = 2 * (f.v + t * f.base);
      constant[i] = -2 * dot(f.v, f.base) - t * (squared_length(f.base) + squared_length(f.v));
    }
    std::array<Point, 7> places;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      places[count++] = slope[i] / (2 * t);
      const std::size_t j = (i + 1) % 3;
      const Vector difference = slope[i] - slope[j];
      const double square = squared_length(difference);
      if (square == 0) continue;
      const Vector side = perpendicular(difference);
      places[count++] = ((constant[j] - constant[i]) * difference + dot(slope[i], side) / (2 * t) * side) / square;
    }
    const Vector u = slope[1] - slope[0], v = slope[2] - slope[0];
    const double rise_1 = constant[0] - constant[1], rise_2 = constant[0] - constant[2];
    places[count++] = Vector{rise_1 * v.y - rise_2 * u.y, rise_2 * u.x - rise_1 * v.x} / cross(u, v);
    double reached = -1;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_finite(places[i])) continue;
      const double least = std::min({(*three[0])(places[i]), (*three[1])(places[i]), (*three[2])(places[i])});
      reached = std::max(reached, least);
      if (least > best.value) best = {places[i], least};
    }
    if (reached < t - rounding_at(t)) high = t;
    if (Meeting at = best; steps % 8 == 7 && best.value > 0 && newton(three, at) == Found::optimum) return at;
  }
  if (!(best.value > 0)) return std::nullopt;
  return best;
}

/// Which member of a basis of three leaves it when h enters, found from the gradients at the place as in the simplex
/// method.
std::size_t leaving_member(const Three& members, const Point& place, const ShapeFunction& h) {
  const auto slope_at = [&place](const ShapeFunction& f) {
    const Vector r = place - f.base;
    const double by = 2 / (squared_length(r) + squared_length(f.v));
    return by * (f.v - by * dot(f.v, r) * r);
  };
  const std::array<Vector, 3> slope{slope_at(*members[0]), slope_at(*members[1]), slope_at(*members[2])};
  const Vector entering = slope_at(h);
  std::size_t leaving = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector &a = slope[(i + 1) % 3], &b = slope[(i + 2) % 3];
    const double sign = cross(slope[1] - slope[0], slope[2] - slope[0]) < 0 ? -1 : 1;
    const double share = sign * cross(a, b), mixture = sign * cross(a - entering, b - entering);
    if (!(mixture > 0) || share >= least * mixture) continue;
    least = share / mixture;
    leaving = i;
  }
  return leaving;
}

/// The basis of the members and one more function, `entering`, which it contains together with one or two of the
/// members. Empty where rounding hides it; also, with `is_none` set, where two functions have no good place in common.
std::optional<DiskBasis> exchange(std::span<const ShapeFunction> functions, const DiskBasis& basis,
                                  std::size_t entering, bool& is_none) {
  const std::span<const std::size_t> members(basis.members.data(), basis.count);
  const ShapeFunction& h = functions[entering];
  const Meeting here{basis.place, basis.value};
  const auto holds = [&](const Meeting& candidate) {
    return std::all_of(members.begin(), members.end(),
                       [&](std::size_t i) { return contains(functions[i], candidate); });
  };
  const auto triple = [&](std::size_t i, std::size_t j, const Meeting& at) {
    return DiskBasis{{members[i], members[j], entering}, 3, at.place, at.value};
  };
  if (members.size() == 3) {  // this guess is nearly always right
    const std::size_t leaving =
        leaving_member({&functions[members[0]], &functions[members[1]], &functions[members[2]]}, here.place, h);
    const std::size_t i = leaving == 0 ? 1 : 0, j = leaving == 2 ? 1 : 2;
    Meeting at = here;
    if (newton({&functions[members[i]], &functions[members[j]], &h}, at) == Found::optimum && holds(at))
      return triple(i, j, at);
  }
  std::array<Meeting, 3> pairs;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto pair = meeting(functions[members[i]], h);
    if (!pair) {
      is_none = true;
      return std::nullopt;
    }
    pairs[i] = *pair;
    if (holds(*pair)) return DiskBasis{{members[i], entering, 0}, 2, pair->place, pair->value};
  }
  // Searches take long, and are for what Newton's method does not find.
  for (const bool is_search : {false, true})
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const Three three{&functions[members[i]], &functions[members[j]], &h};
        const Meeting& below = pairs[i].value < pairs[j].value ? pairs[i] : pairs[j];
        if (is_search) {
          const auto at = search_meeting(three, below.value);
          if (at && holds(*at)) return triple(i, j, *at);
          continue;
        }
        Meeting at = below;
        Found found = newton(three, at);
        if (found == Found::nothing) found = newton(three, at = here);
        if (found == Found::optimum && holds(at)) return triple(i, j, at);
      }
  return std::nullopt;
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
    basis = {{first, 0, 0}, 1, functions[first].base + functions[first].v, 1};
  }
  DiskOptimum best{basis.place, -1};
  for (int exchanges = 0; exchanges < most_exchanges; ++exchanges) {
    const auto [entering, least] = worst_at(basis.place);
    if (least > best.value) best = {basis.place, least};
    const auto end = basis.members.begin() + static_cast<std::ptrdiff_t>(basis.count);
    if (contains(functions[entering], {basis.place, basis.value}) ||
        std::find(basis.members.begin(), end, entering) != end)
      break;
    bool is_none = false;
    const auto next = exchange(functions, basis, entering, is_none);
    if (is_none) return std::nullopt;
    if (!next) break;  // rounding hides the next basis; the best place so far is the answer
    basis = *next;
  }
  if (!(best.value > 0)) return std::nullopt;
  return best;
}

}  // namespace pliant

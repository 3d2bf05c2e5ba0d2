// tests/support/oracle_element.h: det J and tau of one element as functions of a place, in long double.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "support/cut_polygon.h"
#include "support/placement_stars.h"
#include "support/quadratic_forms.h"

namespace pliant::samples {

/// The columns of J (along xi2 and xi3) at one point of an element: fixed + place * rate. det J and tau follow from
/// them.
struct Columns {
  Place fixed_2{}, fixed_3{};
  Real rate_2 = 0, rate_3 = 0;

  Place along_2(const Place& q) const { return {fixed_2.x + q.x * rate_2, fixed_2.y + q.y * rate_2}; }
  Place along_3(const Place& q) const { return {fixed_3.x + q.x * rate_3, fixed_3.y + q.y * rate_3}; }
};

/// The cost -scale * (determinant of the columns), and its slope.
inline Cost area_cost(const Columns& c, const Place& q, Real scale) {
  const Place a = c.along_2(q), b = c.along_3(q);
  return {-scale * (a.x * b.y - a.y * b.x),
          {-scale * (c.rate_2 * b.y - c.rate_3 * a.y), -scale * (c.rate_3 * a.x - c.rate_2 * b.x)},
          true};
}
/// The cost 1 / tau, and its slope.
inline Cost shape_cost(const Columns& c, const Place& q) {
  static const Real root = 1 / std::sqrt(Real{3});
  const Place a = c.along_2(q), b = c.along_3(q), w{root * (2 * b.x - a.x), root * (2 * b.y - a.y)};
  const Real rate = root * (2 * c.rate_3 - c.rate_2);
  const Real area = 2 * (a.x * w.y - a.y * w.x), square = a.x * a.x + a.y * a.y + w.x * w.x + w.y * w.y;
  const Place area_slope{2 * (c.rate_2 * w.y - rate * a.y), 2 * (rate * a.x - c.rate_2 * w.x)};
  const Place square_slope{2 * (a.x * c.rate_2 + w.x * rate), 2 * (a.y * c.rate_2 + w.y * rate)};
  const Real cost = square / area;
  return {cost, {(square_slope.x - cost * area_slope.x) / area, (square_slope.y - cost * area_slope.y) / area}, true};
}

inline Real power(Real base, int exponent) { return exponent <= 0 ? 1 : base * power(base, exponent - 1); }

class OracleElement {
 public:
  OracleElement(int degree, const std::vector<Point>& net, int moving, int fineness)
      : degree_(degree), net_(net), moving_(moving), tried_(static_cast<std::size_t>(5 * fineness)) {
    Real low_x = 1e300L, low_y = 1e300L, high_x = -1e300L, high_y = -1e300L;
    for (std::size_t n = 0; n < net.size(); ++n) {
      if (static_cast<int>(n) == moving) continue;
      low_x = std::min(low_x, Real{net[n].x}), high_x = std::max(high_x, Real{net[n].x});
      low_y = std::min(low_y, Real{net[n].y}), high_y = std::max(high_y, Real{net[n].y});
    }
    scale_ = 1 / ((high_x - low_x) * (high_x - low_x) + (high_y - low_y) * (high_y - low_y));
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<Real, 3> corner{};
      corner[c] = 1;
      at_corner_[c] = columns(corner);
    }
    if (degree == 2) return;
    const int steps = degree == 1 ? 1 : 4 * degree * fineness;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Real by = Real{1} / steps;
        samples_.push_back({i * by, j * by, (steps - i - j) * by});
        at_sample_.push_back(columns(samples_.back()));
      }
    steps_ = steps;
  }

  Columns columns(const std::array<Real, 3>& xi) const {
    Columns result;
    const NetLayout& layout = NetLayout::of(degree_);
    for (int n = 0; n < layout.size(); ++n) {
      const auto& e = layout.exponents(n);
      std::array<Real, 3> by{};  // the derivatives of the Bernstein polynomial by xi1, xi2, xi3
      for (std::size_t c = 0; c < 3; ++c) {
        if (e[c] == 0) continue;
        by[c] = static_cast<Real>(layout.multinomial(n)) * e[c];
        for (std::size_t d = 0; d < 3; ++d) by[c] *= power(xi[d], e[d] - (c == d));
      }
      const Real weight_2 = by[1] - by[0], weight_3 = by[2] - by[0];
      if (n == moving_) {
        result.rate_2 = weight_2;
        result.rate_3 = weight_3;
        continue;
      }
      const Point& p = net_[static_cast<std::size_t>(n)];
      result.fixed_2 = {result.fixed_2.x + weight_2 * p.x, result.fixed_2.y + weight_2 * p.y};
      result.fixed_3 = {result.fixed_3.x + weight_3 * p.x, result.fixed_3.y + weight_3 * p.y};
    }
    return result;
  }

  /// The greatest -scale * det J over the element, and its slope.
  Cost area_cost(const Place& q) const {
    return degree_ == 2 ? area_cost(blend(lowest_form(forms(q).area)), q)
                        : area_cost(lowest([this, &q](const Columns& c) { return -area_cost(c, q).cost; }), q);
  }
  /// The greatest 1 / tau over the element, and its slope.   Requires    det J > 0 everywhere
  Cost shape_cost(const Place& q) const {
    return degree_ == 2
               ? samples::shape_cost(blend(lowest_shape(q)), q)
               : samples::shape_cost(lowest([&q](const Columns& c) { return 1 / samples::shape_cost(c, q).cost; }), q);
  }
  /// The control triangles that have the moving point as a corner, each as if it were an element.
  std::vector<Columns> control_triangles() const {
    std::vector<Columns> all;
    const NetLayout& layout = NetLayout::of(degree_);
    const auto look = [&](std::array<int, 3> corners) {
      const auto found = std::find(corners.begin(), corners.end(), moving_);
      if (found == corners.end()) return;
      std::rotate(corners.begin(), found, corners.end());
      const Point &b = net_[static_cast<std::size_t>(corners[1])], &c = net_[static_cast<std::size_t>(corners[2])];
      all.push_back({{b.x, b.y}, {c.x, c.y}, -1, -1});
    };
    for (int i = 0; i < degree_; ++i)
      for (int j = 0; i + j < degree_; ++j) {
        look({layout.index(i + 1, j), layout.index(i, j + 1), layout.index(i, j)});
        if (i + j + 1 < degree_) look({layout.index(i + 1, j + 1), layout.index(i, j + 1), layout.index(i + 1, j)});
      }
    return all;
  }
  /// All coefficients of -scale * det J with their slopes, as sums over pairs of differences.
  std::vector<Cost> coefficient_costs(const Place& q) const {
    const NetLayout &partial = NetLayout::of(degree_ - 1), &product = NetLayout::of(2 * (degree_ - 1));
    const NetLayout& layout = NetLayout::of(degree_);
    std::vector<Columns> partials;
    for (int m = 0; m < partial.size(); ++m) {
      const auto& [i, j, k] = partial.exponents(m);
      Columns c;
      const auto add = [&](int n, Real w2, Real w3) {
        if (n == moving_) {
          c.rate_2 += w2;
          c.rate_3 += w3;
          return;
        }
        const Point& p = net_[static_cast<std::size_t>(n)];
        c.fixed_2 = {c.fixed_2.x + w2 * p.x, c.fixed_2.y + w2 * p.y};
        c.fixed_3 = {c.fixed_3.x + w3 * p.x, c.fixed_3.y + w3 * p.y};
      };
      add(layout.index(i + 1, j), -degree_, -degree_);
      add(layout.index(i, j + 1), degree_, 0);
      add(layout.index(i, j), 0, degree_);
      partials.push_back(c);
    }
    std::vector<Cost> costs(static_cast<std::size_t>(product.size()), Cost{0, {0, 0}, true});
    for (int m = 0; m < partial.size(); ++m)
      for (int n = 0; n < partial.size(); ++n) {
        const auto &e = partial.exponents(m), &f = partial.exponents(n);
        const int target = product.index(e[0] + f[0], e[1] + f[1]);
        const Real weight = static_cast<Real>(partial.multinomial(m)) * static_cast<Real>(partial.multinomial(n)) /
                            static_cast<Real>(product.multinomial(target));
        const Columns &a = partials[static_cast<std::size_t>(m)], &b = partials[static_cast<std::size_t>(n)];
        const Cost one = area_cost({a.fixed_2, b.fixed_3, a.rate_2, b.rate_3}, q);
        Cost& sum = costs[static_cast<std::size_t>(target)];
        sum.cost += weight * one.cost;
        sum.slope = {sum.slope.x + weight * one.slope.x, sum.slope.y + weight * one.slope.y};
      }
    return costs;
  }

 private:
  using Xi = BarycentricPlace;
  struct Forms {
    QuadraticForm area, square;
  };

  Cost area_cost(const Columns& c, const Place& q) const { return pliant::samples::area_cost(c, q, scale_); }
  std::size_t sample(int i, int j) const { return static_cast<std::size_t>(i * (steps_ + 1) - i * (i - 1) / 2 + j); }

  // For any degree: searches with ever smaller steps, from each sample that is lower than its neighbours.
  template <class Value>
  Columns lowest(Value value) const {
    std::vector<Real> values;
    for (const Columns& c : at_sample_) values.push_back(value(c));
    std::vector<std::pair<Real, std::size_t>> order;
    for (int i = 0; i <= steps_; ++i)
      for (int j = 0; i + j <= steps_; ++j) {
        const Real here = values[sample(i, j)];
        const auto is_below = [&](int k, int l) {
          return k < 0 || l < 0 || k + l > steps_ || here <= values[sample(k, l)];
        };
        if (is_below(i + 1, j) && is_below(i - 1, j) && is_below(i, j + 1) && is_below(i, j - 1) &&
            is_below(i + 1, j - 1) && is_below(i - 1, j + 1))
          order.push_back({here, sample(i, j)});
      }
    std::sort(order.begin(), order.end());
    const std::size_t tried = std::min(tried_, order.size());
    Real least = HUGE_VALL;
    Columns best;
    for (std::size_t s = 0; s < tried; ++s) {
      Xi xi = samples_[order[s].second];
      Real here = order[s].first;
      Columns at = at_sample_[order[s].second];
      for (Real step = degree_ == 1 ? 0 : Real{1} / (2 * steps_); step > 1e-8L;) {
        bool moved = false;
        for (std::size_t from = 0; from < 3; ++from)
          for (std::size_t to = 0; to < 3; ++to) {
            if (from == to) continue;
            const Real by = std::min(step, xi[from]);
            if (!(by > 0)) continue;
            Xi next = xi;
            next[from] -= by;
            next[to] += by;
            const Columns c = columns(next);
            if (const Real v = value(c); v < here) {
              here = v;
              xi = next;
              at = c;
              moved = true;
            }
          }
        if (!moved) step /= 3;
      }
      if (here >= least) continue;
      least = here;
      best = at;
    }
    return best;
  }

  // For p = 2: quadratic forms, whose stationary points are roots of polynomials.
  Columns blend(const Xi& xi) const {
    Columns c;
    for (std::size_t i = 0; i < 3; ++i) {
      const Columns& at = at_corner_[i];
      c.fixed_2 = {c.fixed_2.x + xi[i] * at.fixed_2.x, c.fixed_2.y + xi[i] * at.fixed_2.y};
      c.fixed_3 = {c.fixed_3.x + xi[i] * at.fixed_3.x, c.fixed_3.y + xi[i] * at.fixed_3.y};
      c.rate_2 += xi[i] * at.rate_2;
      c.rate_3 += xi[i] * at.rate_3;
    }
    return c;
  }
  Xi lowest_shape(const Place& q) const {
    const Forms both = forms(q);
    return lowest_quotient(both.area, both.square);
  }
  Forms forms(const Place& q) const {
    static const Real root = 1 / std::sqrt(Real{3});
    std::array<Place, 3> a, w;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = at_corner_[i].along_2(q);
      const Place b = at_corner_[i].along_3(q);
      w[i] = {root * (2 * b.x - a[i].x), root * (2 * b.y - a[i].y)};
    }
    Forms f;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) {
        f.area[i][j] = f.area[j][i] = a[i].x * w[j].y - a[i].y * w[j].x + a[j].x * w[i].y - a[j].y * w[i].x;
        f.square[i][j] = f.square[j][i] = a[i].x * a[j].x + a[i].y * a[j].y + w[i].x * w[j].x + w[i].y * w[j].y;
      }
    return f;
  }
  int degree_;
  const std::vector<Point>& net_;
  int moving_;
  std::size_t tried_;
  Real scale_ = 1;
  int steps_ = 1;
  std::array<Columns, 3> at_corner_;
  std::vector<Xi> samples_;
  std::vector<Columns> at_sample_;
};

}  // namespace pliant::samples

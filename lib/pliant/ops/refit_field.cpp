// The fields of a patch in its new geometry: least squares, integral kept, values limited.
#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/geometry/jacobian.h"
#include "pliant/ops/node_basis.h"
#include "pliant/ops/refit.h"
#include "pliant/ops/solve_dense.h"

namespace pliant {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double rough = 0.1;  // residuals against the variation of the best linear function

using Net = std::array<Point, net_size(max_degree)>;
using Weights = std::array<double, net_size(max_degree)>;

struct Range {
  double low, high;
  double clamp(double v) const { return std::clamp(v, low, high); }
  Range moved(double by) const { return {low + by, high + by}; }
};

/// Spreads a missing integral over values with positive weights, least change, each within its range (none: any value).
/// Returns what could not be placed.
double spread(double missing, std::span<const double> weights, std::span<double> values,
              std::span<const Range> ranges) {
  thread_local std::vector<char> full;
  full.assign(values.size(), 0);
  for (std::size_t round = 0; round <= values.size(); ++round) {
    double squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!full[k]) squares += weights[k] * weights[k];
    if (!(squares > 0) || missing == 0) return missing;
    const double step = missing / squares;
    bool clipped = false;
    if (!ranges.empty())
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (full[k]) continue;
        const double wanted = values[k] + step * weights[k];
        const double held = step * weights[k] > 0 ? std::min(wanted, std::max(ranges[k].high, values[k]))
                                                  : std::max(wanted, std::min(ranges[k].low, values[k]));
        if (held == wanted) continue;
        missing -= (held - values[k]) * weights[k];
        values[k] = held;
        full[k] = 1;
        clipped = true;
      }
    if (clipped) continue;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!full[k]) values[k] += step * weights[k];
    return 0;
  }
  return missing;
}

}  // namespace

struct Patch::Group {
  std::vector<int> columns;  // of the rows
  std::vector<int> fields, components;
  bool by_face;
  FaceId face;
};

void Patch::fit_fields(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                       const RefitOptions& options, bool region_kept) const {
  if (width_ == 2) return;
  thread_local Group continuous, by_face;
  for (Group* group : {&continuous, &by_face}) {
    group->columns.clear();
    group->fields.clear();
    group->components.clear();
  }
  continuous.by_face = false;
  continuous.face = none;
  by_face.by_face = true;
  int column = 2;
  for (std::size_t k = 0; k < mesh.fields().size(); ++k)
    for (int c = 0; c < mesh.fields()[k].components; ++c, ++column) {
      Group& group = mesh.fields()[k].by_face ? by_face : continuous;
      group.columns.push_back(column);
      group.fields.push_back(static_cast<int>(k));
      group.components.push_back(c);
    }
  if (!continuous.columns.empty()) fit_group(mesh, now, free, continuous, options, region_kept);
  if (by_face.columns.empty()) return;
  thread_local std::vector<FaceId> faces;
  faces.clear();
  for (const TriangleId t : now)
    if (std::find(faces.begin(), faces.end(), mesh.face(t)) == faces.end()) faces.push_back(mesh.face(t));
  for (const FaceId f : faces) {
    by_face.face = f;
    fit_group(mesh, now, free, by_face, options, region_kept);
  }
}

void Patch::fit_group(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free, const Group& group,
                      const RefitOptions& options, bool region_kept) const {
  const auto in_group = [&](FaceId f) { return !group.by_face || f == group.face; };
  const bool conserve = region_kept && options.projection != Projection::l2;
  const bool limit = options.projection == Projection::limited;
  const int columns = static_cast<int>(group.columns.size());

  // Unknowns: the free points that the group's elements contain.
  thread_local std::vector<PointId> unknowns;
  unknowns.clear();
  for (const PointId p : free)
    for (const TriangleId t : now) {
      const auto ids = mesh.net(t);
      if (in_group(mesh.face(t)) && std::find(ids.begin(), ids.end(), p) != ids.end()) {
        unknowns.push_back(p);
        break;
      }
    }
  const int n = static_cast<int>(unknowns.size());
  if (n == 0 && !conserve) return;
  const auto unknown_of = [&](PointId p) {
    const auto found = std::find(unknowns.begin(), unknowns.end(), p);
    return found == unknowns.end() ? -1 : static_cast<int>(found - unknowns.begin());
  };

  // The old function less its best linear part, so that linear functions are reproduced to rounding.
  thread_local std::vector<Linear> linear;
  linear.clear();
  const FaceId of_face = group.by_face ? group.face : none;
  const Moments moments = moments_of(of_face);
  for (const int column : group.columns) linear.push_back(linear_of(column, of_face, moments));
  thread_local std::vector<double> old_rest;  // per element: n_ x columns
  old_rest.assign(elements_.size() * at(n_ * columns), 0.0);
  thread_local std::vector<Range> values, rests, trends;  // of old control values, residuals, linear functions
  values.assign(at(columns), {HUGE_VAL, -HUGE_VAL});
  rests.assign(at(columns), {HUGE_VAL, -HUGE_VAL});
  trends.assign(at(columns), {HUGE_VAL, -HUGE_VAL});
  Net net;
  Weights weights;
  const std::span<const Point> net_points{net.data(), at(n_)};
  thread_local std::vector<double> target;  // integral of the residual
  target.assign(at(columns), 0.0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& old = elements_[e];
    if (!in_group(old.face)) continue;
    for (int k = 0; k < n_; ++k) net[at(k)] = old_point(old, k);
    if (conserve) integral_weights(degree_, net_points, weights);
    for (int k = 0; k < n_; ++k)
      for (int c = 0; c < columns; ++c) {
        const double u = rows(old)[at(k * width_ + group.columns[at(c)])];
        const double l = evaluate(linear[at(c)], net[at(k)]), r = u - l;
        old_rest[e * at(n_ * columns) + at(k * columns + c)] = r;
        values[at(c)] = {std::min(values[at(c)].low, u), std::max(values[at(c)].high, u)};
        rests[at(c)] = {std::min(rests[at(c)].low, r), std::max(rests[at(c)].high, r)};
        trends[at(c)] = {std::min(trends[at(c)].low, l), std::max(trends[at(c)].high, l)};
        if (conserve) target[at(c)] += weights[at(k)] * r;
      }
  }

  const auto current = [&](PointId p, FaceId f, int c) {
    const std::ptrdiff_t first = mesh.value_index(group.fields[at(c)], p, f);
    const Field& field = mesh.fields()[at(group.fields[at(c)])];
    return first < 0 ? 0.0 : field.values[static_cast<std::size_t>(first + group.components[at(c)])];
  };
  const bool sample = n > 0 && !(conserve && n == 1);         // one value and one integral: nothing is left to fit
  thread_local std::vector<double> normal, right, system, x;  // n x n, n x columns; of what is open now
  thread_local std::vector<double> weight, rest;
  thread_local std::vector<char> held;
  thread_local std::vector<int> open;
  normal.assign(at(n * n), 0.0);
  right.assign(at(n * columns), 0.0);
  weight.assign(at(n), 0.0);
  std::array<int, net_size(max_degree)> unknown;
  thread_local std::vector<double> known, value;
  known.resize(at(n_ * columns));
  value.resize(at(columns));
  const NodeBasis& table = node_basis(degree_);
  for (const TriangleId t : now) {
    if (!in_group(mesh.face(t))) continue;
    const auto ids = mesh.net(t);
    mesh.gather_points(t, net);
    if (conserve) integral_weights(degree_, net_points, weights);
    for (int k = 0; k < n_; ++k) {
      unknown[at(k)] = unknown_of(ids[at(k)]);
      if (unknown[at(k)] >= 0) {
        if (conserve) weight[at(unknown[at(k)])] += weights[at(k)];
        continue;
      }
      for (int c = 0; c < columns; ++c) {
        const double r = current(ids[at(k)], mesh.face(t), c) - evaluate(linear[at(c)], net[at(k)]);
        known[at(k * columns + c)] = r;
        if (conserve) target[at(c)] -= weights[at(k)] * r;
      }
    }
    if (!sample) continue;
    for (std::size_t q = 0; q < table.nodes.size(); ++q) {
      const TriangleNode& node = table.nodes[q];
      const std::span<const double> basis = table.at(q);
      std::array<double, 2> place, along_2, along_3;
      evaluate_net(degree_, 2, {&net[0].x, at(2 * n_)}, node.xi, place, along_2, along_3);
      const double measure = node.weight * (along_2[0] * along_3[1] - along_2[1] * along_3[0]);
      const Point here{place[0], place[1]};
      std::size_t best = elements_.size();
      double depth = -HUGE_VAL;
      Barycentric best_xi{};
      Net old_net;
      for (std::size_t e = 0; e < elements_.size() && depth < -1e-12; ++e) {
        const Element& old = elements_[e];
        if (!in_group(old.face)) continue;
        for (int k = 0; k < n_; ++k) old_net[at(k)] = old_point(old, k);
        const auto xi = invert_map(degree_, {old_net.data(), at(n_)}, here, 1e-13 * size_);
        if (!xi) continue;
        const double least = std::min({(*xi)[0], (*xi)[1], (*xi)[2]});
        if (least > depth) depth = least, best = e, best_xi = *xi;
      }
      if (best == elements_.size()) continue;
      evaluate_net(degree_, columns,
                   std::span<const double>(old_rest).subspan(best * at(n_ * columns), at(n_ * columns)), best_xi,
                   value);
      for (int k = 0; k < n_; ++k)
        if (unknown[at(k)] < 0)
          for (int c = 0; c < columns; ++c) value[at(c)] -= basis[at(k)] * known[at(k * columns + c)];
      for (int k = 0; k < n_; ++k) {
        if (unknown[at(k)] < 0) continue;
        for (int c = 0; c < columns; ++c)
          right[at(unknown[at(k)] * columns + c)] += measure * basis[at(k)] * value[at(c)];
        for (int m = 0; m < n_; ++m)
          if (unknown[at(m)] >= 0)
            normal[at(unknown[at(k)] * n + unknown[at(m)])] += measure * basis[at(k)] * basis[at(m)];
      }
    }
  }

  // What a residual may be at a place: within the ranges of residuals and values, or 0, the linear function's own
  // value. In a field so rough that this function says nothing the values' range alone holds, also outside the old
  // control points; there always is a place for the integral in it.
  const auto residual_range = [&](const Point& place, int c) {
    const double l = evaluate(linear[at(c)], place);
    const Range &v = values[at(c)], &r = rests[at(c)], &trend = trends[at(c)];
    if (std::max(-r.low, r.high) > rough * (trend.high - trend.low)) return Range{v.low - l, v.high - l};
    return Range{std::min(0.0, std::max(v.low - l, r.low)), std::max(0.0, std::min(v.high - l, r.high))};
  };

  double unit = 0, weight_unit = 0;  // the equality's row in the scale of the others
  for (int i = 0; i < n; ++i) {
    unit += normal[at(i * n + i)] / n;
    weight_unit = std::max(weight_unit, std::abs(weight[at(i)]));
  }
  for (int c = 0; c < columns; ++c) {
    // Least squares with one equality; what leaves its range is held at the bound, and the rest solved again.
    rest.assign(at(n), 0.0);
    held.assign(at(n), 0);
    double missing = conserve ? target[at(c)] : 0;
    const double largest = std::max(std::abs(values[at(c)].low), std::abs(values[at(c)].high));
    const bool is_linear = std::max(-rests[at(c)].low, rests[at(c)].high) <= rounding_of(linear[at(c)], largest);
    if (is_linear) spread(missing, weight, rest, {});
    for (int round = 0; round <= n && n > 0 && !is_linear; ++round) {
      open.clear();
      for (int i = 0; i < n; ++i)
        if (!held[at(i)]) open.push_back(i);
      if (open.empty()) break;
      const int m = static_cast<int>(open.size()), size = m + (conserve ? 1 : 0);
      double integral = missing;
      for (int i = 0; i < n; ++i)
        if (held[at(i)]) integral -= weight[at(i)] * rest[at(i)];
      if (conserve && m == 1) {
        rest[at(open[0])] = integral / weight[at(open[0])];
      } else {
        system.assign(at(size * size), 0.0);
        x.assign(at(size), 0.0);
        for (int i = 0; i < m; ++i) {
          const int row = open[at(i)];
          x[at(i)] = right[at(row * columns + c)];
          for (int j = 0; j < m; ++j) system[at(i * size + j)] = normal[at(row * n + open[at(j)])];
          for (int j = 0; j < n; ++j)
            if (held[at(j)]) x[at(i)] -= normal[at(row * n + j)] * rest[at(j)];
          if (conserve) system[at(i * size + m)] = system[at(m * size + i)] = weight[at(row)] * unit / weight_unit;
        }
        if (conserve) x[at(m)] = integral * unit / weight_unit;
        solve_dense(size, system, 1, x);
        for (int i = 0; i < m; ++i) rest[at(open[at(i)])] = x[at(i)];
      }
      bool clipped = false;
      for (const int i : open) {
        if (!limit) continue;
        const double within = residual_range(mesh.point(unknowns[at(i)]), c).clamp(rest[at(i)]);
        if (within == rest[at(i)] && std::isfinite(rest[at(i)])) continue;
        rest[at(i)] = std::isfinite(rest[at(i)]) ? within : 0.0;
        held[at(i)] = 1;
        clipped = true;
      }
      if (!clipped) break;
    }
    for (int i = 0; i < n; ++i) {
      missing -= conserve ? weight[at(i)] * rest[at(i)] : 0;
      const PointId p = unknowns[at(i)];
      mesh.put_component(group.fields[at(c)], group.components[at(c)], p, group.face,
                         rest[at(i)] + evaluate(linear[at(c)], mesh.point(p)));
    }
    double weights_sum = 0;
    for (const double w : weight) weights_sum += std::abs(w);
    const double noise = 1e-15 * weights_sum * (std::abs(values[at(c)].low) + std::abs(values[at(c)].high));
    if (!conserve || std::abs(missing) <= noise) continue;

    // The integral that the free values could not keep: over the values of the elements' own edges, then the corners.
    for (const bool corners : {false, true}) {
      thread_local std::vector<double> shares, held_values;
      thread_local std::vector<PointId> takers;
      thread_local std::vector<FaceId> taker_faces;
      thread_local std::vector<Range> ranges;
      shares.clear();
      held_values.clear();
      takers.clear();
      taker_faces.clear();
      ranges.clear();
      for (const TriangleId t : now) {
        if (!in_group(mesh.face(t))) continue;
        const auto ids = mesh.net(t);
        for (int k = corners ? 0 : 3; k < (corners ? 3 : mesh.layout().first_interior()); ++k) {
          const PointId p = ids[at(k)];
          if (unknown_of(p) >= 0 || std::find(takers.begin(), takers.end(), p) != takers.end()) continue;
          takers.push_back(p);
          taker_faces.push_back(mesh.face(t));
          shares.push_back(weight_in_mesh(mesh, p, t, k, group.by_face));
          held_values.push_back(current(p, mesh.face(t), c));
          // Limited as the free values are: residuals must not grow either, or functions of degree 1 do not last.
          if (limit) ranges.push_back(residual_range(mesh.point(p), c).moved(evaluate(linear[at(c)], mesh.point(p))));
        }
      }
      missing = spread(missing, shares, held_values, ranges);
      for (std::size_t k = 0; k < takers.size(); ++k)
        mesh.put_component(group.fields[at(c)], group.components[at(c)], takers[k], taker_faces[k], held_values[k]);
      if (std::abs(missing) <= noise) break;
    }
  }
}

}  // namespace pliant

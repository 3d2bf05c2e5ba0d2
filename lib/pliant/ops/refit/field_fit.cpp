// lib/pliant/ops/refit/field_fit.cpp: solves for the residuals, within their ranges, and keeps the integral.
#include "pliant/ops/refit/field_fit.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double most_missing = 1e3;  // an integral is kept if no more than so many times its rounding is missing
constexpr double rough = 0.1;         // a field is rough if residuals exceed this part of its linear trend's variation

/// Changes values so that the sum of weight times value grows by what is missing of an integral; the sum of the squared
/// changes is least. Values stay within their ranges (`ranges` may be empty: no limits). Returns what is still missing.
template <typename Range>
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

bool FieldFit::run(const Patch& patch, Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                   const FieldGroup& group, const RefitOptions& options, bool region_kept) {
  patch_ = &patch;
  mesh_ = &mesh;
  now_ = now;
  group_ = &group;
  conserves_ = region_kept && options.projection != Projection::l2;
  limits_ = options.projection == Projection::limited;
  columns_ = static_cast<int>(group.components.size());
  size_ = patch.n_;
  collect_unknowns(free);
  if (unknowns_.empty() && !conserves_) return true;
  take_residuals();
  assemble();
  double weights_sum = 0;
  for (const double w : weights_) weights_sum += std::abs(w);
  for (int c = 0; c < columns_; ++c) {
    solve_component(c);
    const Component& component = components_[index(c)];
    double missing = put_values(component);
    const double noise = 1e-15 * weights_sum * (std::abs(component.values.low) + std::abs(component.values.high));
    if (conserves_ && !(std::abs(missing) <= noise)) missing = spread_missing(component, missing, noise);
    if (conserves_ && !(std::abs(missing) <= most_missing * noise)) return false;
  }
  return true;
}

FieldFit::Range FieldFit::residual_range(const Component& component, const Point& place) const {
  // A residual must be within the range of the old residuals, and the value within the range of the old values; 0 is
  // always allowed, since the linear function itself is. In a rough field the linear function says little, and only the
  // range of values counts: values that have the integral always exist within it.
  const double l = trend(component, place);
  const Range &v = component.values, &r = component.residuals, &linear = component.trends;
  if (std::max(-r.low, r.high) > rough * (linear.high - linear.low)) return {v.low - l, v.high - l};
  return {std::min(0.0, std::max(v.low - l, r.low)), std::max(0.0, std::min(v.high - l, r.high))};
}

bool FieldFit::is_linear(const Component& component) const {
  const Range &v = component.values, &r = component.residuals;
  const double largest = std::max(std::abs(v.low), std::abs(v.high));
  return std::max(-r.low, r.high) <= patch_->rounding_of(component.linear, largest);
}

void FieldFit::solve_component(int c) {
  const int n = unknown_count();
  solution_.assign(index(n), 0.0);
  held_.assign(index(n), 0);
  const Component& component = components_[index(c)];
  const double integral = conserves_ ? component.target : 0;
  if (is_linear(component)) {
    spread<Range>(integral, weights_, solution_, {});
    return;
  }
  for (int round = 0; round <= n; ++round) {
    open_.clear();
    for (int i = 0; i < n; ++i)
      if (!held_[index(i)]) open_.push_back(i);
    if (open_.empty()) return;
    solve_open(c, integral);
    if (!limits_ || !hold_outside(component)) return;
  }
}

void FieldFit::solve_open(int c, double integral) {
  const int n = unknown_count(), m = static_cast<int>(open_.size()), size = m + (conserves_ ? 1 : 0);
  for (int i = 0; i < n; ++i)
    if (held_[index(i)]) integral -= weights_[index(i)] * solution_[index(i)];
  if (conserves_ && m == 1) {
    solution_[index(open_[0])] = integral / weights_[index(open_[0])];
    return;
  }
  system_.assign(index(size * size), 0.0);
  system_right_.assign(index(size), 0.0);
  for (int i = 0; i < m; ++i) {
    const int row = open_[index(i)];
    double& right = system_right_[index(i)];
    right = right_[index(row * columns_ + c)];
    for (int j = 0; j < m; ++j) system_[index(i * size + j)] = normal_[index(row * n + open_[index(j)])];
    for (int j = 0; j < n; ++j)
      if (held_[index(j)]) right -= normal_[index(row * n + j)] * solution_[index(j)];
    // The row of the equality is scaled to the size of the others.
    if (conserves_)
      system_[index(i * size + m)] = system_[index(m * size + i)] =
          weights_[index(row)] * equation_scale_ / weight_scale_;
  }
  if (conserves_) system_right_[index(m)] = integral * equation_scale_ / weight_scale_;
  solve_dense(size, system_, 1, system_right_);
  for (int i = 0; i < m; ++i) solution_[index(open_[index(i)])] = system_right_[index(i)];
}

bool FieldFit::hold_outside(const Component& component) {
  bool any = false;
  for (const int i : open_) {
    double& residual = solution_[index(i)];
    const double within = residual_range(component, mesh_->point(unknowns_[index(i)])).clamp(residual);
    if (within == residual && std::isfinite(residual)) continue;
    residual = std::isfinite(residual) ? within : 0.0;
    held_[index(i)] = 1;
    any = true;
  }
  return any;
}

double FieldFit::put_values(const Component& component) {
  double missing = conserves_ ? component.target : 0;
  for (int i = 0; i < unknown_count(); ++i) {
    if (conserves_) missing -= weights_[index(i)] * solution_[index(i)];
    const PointId p = unknowns_[index(i)];
    mesh_->put_component(component.field, component.component, p, group_->face,
                         solution_[index(i)] + trend(component, mesh_->point(p)));
  }
  return missing;
}

double FieldFit::spread_missing(const Component& component, double missing, double noise) {
  for (const bool corners : {false, true}) {
    collect_takers(component, corners);
    missing = spread<Range>(missing, taker_weights_, taker_values_, taker_ranges_);
    for (std::size_t k = 0; k < takers_.size(); ++k)
      mesh_->put_component(component.field, component.component, takers_[k], taker_faces_[k], taker_values_[k]);
    if (std::abs(missing) <= noise) break;
  }
  return missing;
}

void FieldFit::collect_takers(const Component& component, bool corners) {
  takers_.clear();
  taker_faces_.clear();
  taker_weights_.clear();
  taker_values_.clear();
  taker_ranges_.clear();
  for (const TriangleId t : now_) {
    if (!group_->contains(mesh_->face(t))) continue;
    const auto ids = mesh_->net(t);
    for (int k = corners ? 0 : 3; k < (corners ? 3 : mesh_->layout().first_interior()); ++k) {
      const PointId p = ids[index(k)];
      if (unknown_of(p) >= 0 || std::find(takers_.begin(), takers_.end(), p) != takers_.end()) continue;
      takers_.push_back(p);
      taker_faces_.push_back(mesh_->face(t));
      taker_weights_.push_back(weight_in_mesh(*mesh_, p, t, k, group_->by_face));
      taker_values_.push_back(current(p, mesh_->face(t), component));
      // These values have the same limits as the unknowns: if residuals could grow, linear functions would not last.
      const Point& place = mesh_->point(p);
      if (limits_) taker_ranges_.push_back(residual_range(component, place).moved(trend(component, place)));
    }
  }
}

}  // namespace pliant

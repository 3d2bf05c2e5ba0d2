// lib/pliant/ops/refit/field_fit_equations.cpp: least-squares equations from samples of the old residuals.
#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/geometry/node_basis.h"
#include "pliant/ops/refit/field_fit.h"

namespace pliant {
namespace {

constexpr double inside = -1e-12;  // a place is in an element, but for rounding, if no barycentric coordinate is below

}  // namespace

void FieldFit::collect_unknowns(std::span<const PointId> free) {
  unknowns_.clear();
  for (const PointId p : free)
    for (const TriangleId t : now_) {
      const auto ids = mesh_->net(t);
      if (group_->contains(mesh_->face(t)) && std::find(ids.begin(), ids.end(), p) != ids.end()) {
        unknowns_.push_back(p);
        break;
      }
    }
}

int FieldFit::unknown_of(PointId p) const {
  const auto found = std::find(unknowns_.begin(), unknowns_.end(), p);
  return found == unknowns_.end() ? -1 : static_cast<int>(found - unknowns_.begin());
}

void FieldFit::take_residuals() {
  const FaceId face = group_->by_face ? group_->face : none;
  const Patch::Moments moments = patch_->moments_of(face);
  components_.clear();
  for (const FieldGroup::Component& component : group_->components) {
    constexpr Range empty{HUGE_VAL, -HUGE_VAL};
    components_.push_back({component, patch_->linear_of(component.column, face, moments), empty, empty, empty, 0});
  }
  old_residuals_.assign(patch_->elements_.size() * index(size_ * columns_), 0.0);
  Net net;
  Weights weights{};
  for (std::size_t e = 0; e < patch_->elements_.size(); ++e) {
    const Patch::Element& old = patch_->elements_[e];
    if (!group_->contains(old.face)) continue;
    for (int k = 0; k < size_; ++k) net[index(k)] = patch_->old_point(old, k);
    if (conserves_) integral_weights(patch_->degree_, {net.data(), index(size_)}, weights);
    for (int c = 0; c < columns_; ++c) take_residuals(e, c, net, weights);
  }
}

void FieldFit::take_residuals(std::size_t element, int c, const Net& net, const Weights& weights) {
  Component component = components_[index(c)];
  const std::span<const double> rows = patch_->rows(patch_->elements_[element]);
  const std::span<double> residuals = std::span<double>(old_residuals_).subspan(element * index(size_ * columns_));
  for (int k = 0; k < size_; ++k) {
    const double value = rows[index(k * patch_->width_ + component.column)];
    const double linear = trend(component, net[index(k)]), residual = value - linear;
    residuals[index(k * columns_ + c)] = residual;
    component.values.include(value);
    component.residuals.include(residual);
    component.trends.include(linear);
    component.target += weights[index(k)] * residual;
  }
  components_[index(c)] = component;
}

void FieldFit::assemble() {
  const int n = unknown_count();
  const bool samples = n > 0 && !(conserves_ && n == 1);  // the integral alone determines a single unknown
  normal_.assign(index(n * n), 0.0);
  right_.assign(index(n * columns_), 0.0);
  weights_.assign(index(n), 0.0);
  known_.resize(index(size_ * columns_));
  sample_.resize(index(columns_));
  Net net;
  for (const TriangleId t : now_) {
    if (!group_->contains(mesh_->face(t))) continue;
    mesh_->gather_points(t, net);
    take_known(t, net);
    if (samples) add_samples(net);
  }
  equation_scale_ = weight_scale_ = 0;
  for (int i = 0; i < n; ++i) {
    equation_scale_ += normal_[index(i * n + i)] / n;
    weight_scale_ = std::max(weight_scale_, std::abs(weights_[index(i)]));
  }
}

void FieldFit::take_known(TriangleId t, const Net& net) {
  const auto ids = mesh_->net(t);
  Weights weights;
  if (conserves_) integral_weights(patch_->degree_, {net.data(), index(size_)}, weights);
  for (int k = 0; k < size_; ++k) {
    const int i = unknown_[index(k)] = unknown_of(ids[index(k)]);
    if (i >= 0) {
      if (conserves_) weights_[index(i)] += weights[index(k)];
      continue;
    }
    for (int c = 0; c < columns_; ++c) {
      Component& component = components_[index(c)];
      const double residual = current(ids[index(k)], mesh_->face(t), component) - trend(component, net[index(k)]);
      known_[index(k * columns_ + c)] = residual;
      if (conserves_) component.target -= weights[index(k)] * residual;
    }
  }
}

void FieldFit::add_samples(const Net& net) {
  const int n = unknown_count(), degree = patch_->degree_;
  const NodeBasis& table = node_basis(degree);
  for (std::size_t q = 0; q < table.nodes.size(); ++q) {
    const TriangleNode& node = table.nodes[q];
    const std::span<const double> basis = table.at(q);
    std::array<double, 2> place, along_2, along_3;
    evaluate_net(degree, 2, {&net[0].x, index(2 * size_)}, node.xi, place, along_2, along_3);
    const double measure = node.weight * (along_2[0] * along_3[1] - along_2[1] * along_3[0]);
    const std::optional<OldPlace> old = find_old({place[0], place[1]});
    if (!old) continue;
    const std::size_t length = index(size_ * columns_);
    evaluate_net(degree, columns_, std::span<const double>(old_residuals_).subspan(old->element * length, length),
                 old->xi, sample_);
    for (int k = 0; k < size_; ++k)
      if (unknown_[index(k)] < 0)
        for (int c = 0; c < columns_; ++c) sample_[index(c)] -= basis[index(k)] * known_[index(k * columns_ + c)];
    for (int k = 0; k < size_; ++k) {
      const int i = unknown_[index(k)];
      if (i < 0) continue;
      for (int c = 0; c < columns_; ++c)
        right_[index(i * columns_ + c)] += measure * basis[index(k)] * sample_[index(c)];
      for (int m = 0; m < size_; ++m)
        if (unknown_[index(m)] >= 0)
          normal_[index(i * n + unknown_[index(m)])] += measure * basis[index(k)] * basis[index(m)];
    }
  }
}

std::optional<FieldFit::OldPlace> FieldFit::find_old(const Point& place) const {
  std::optional<OldPlace> best;
  double depth = -HUGE_VAL;
  Net net;
  for (std::size_t e = 0; e < patch_->elements_.size() && depth < inside; ++e) {
    const Patch::Element& old = patch_->elements_[e];
    if (!group_->contains(old.face)) continue;
    for (int k = 0; k < size_; ++k) net[index(k)] = patch_->old_point(old, k);
    const auto xi = invert_map(patch_->degree_, {net.data(), index(size_)}, place, 1e-13 * patch_->size_);
    if (!xi) continue;
    const double least = std::min({(*xi)[0], (*xi)[1], (*xi)[2]});
    if (least > depth) depth = least, best = {e, *xi};
  }
  return best;
}

}  // namespace pliant

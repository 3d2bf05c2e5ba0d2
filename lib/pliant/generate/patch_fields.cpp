// lib/pliant/generate/patch_fields.cpp: samples the old elements at the nodes of new ones, then restores the integrals.
#include "pliant/generate/patch_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/invert_map.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

constexpr double inside = -1e-12;    // with barycentric coordinates of at least this a place is in the element
constexpr double rounding = 1e-15;   // rounding of an integral, relative to the integral of the absolute values
constexpr int most_corrections = 3;  // corrections of an integral: each removes the rounding that the last one left

Barycentric clamped(const Barycentric& xi) {
  Barycentric out{};
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += out[c] = std::max(0.0, xi[c]);
  for (double& x : out) x /= sum;
  return out;
}

}  // namespace

void PatchFields::capture(const Mesh& mesh, std::span<const TriangleId> old) {
  degree_ = mesh.degree();
  width_ = mesh.width();
  size_ = index(mesh.net_size());
  count_ = index(width_ - 2);
  if (count_ == 0) return;
  tolerance_ = mesh.tolerance();
  patch_.capture(mesh, old);
  integrals_.take(mesh, old);
  take_columns(mesh);
  const std::span<const double> rows = patch_.all_rows();
  points_.resize(old.size() * size_);
  residuals_.assign(old.size() * size_ * count_, 0.0);
  by_low_.clear();
  widest_ = 0;
  std::array<double, net_size(max_degree)> weights;
  for (std::size_t e = 0; e < old.size(); ++e) {
    Box box;
    for (std::size_t k = 0; k < size_; ++k) {
      const double* const row = rows.data() + (e * size_ + k) * index(width_);
      box.extend(points_[e * size_ + k] = {row[0], row[1]});
    }
    integral_weights(degree_, old_net(e), weights);
    for (std::size_t k = 0; k < size_; ++k)
      for (std::size_t c = 0; c < count_; ++c) {
        const double value = rows[(e * size_ + k) * index(width_) + 2 + c];
        Column& column = columns_[c];
        column.integral += weights[k] * value;
        if (!column.is_linear)
          residuals_[(e * size_ + k) * count_ + c] = value - patch_.evaluate(column.linear, points_[e * size_ + k]);
      }
    box.low += {-tolerance_, -tolerance_};
    box.high += {tolerance_, tolerance_};
    widest_ = std::max(widest_, box.high.x - box.low.x);
    by_low_.push_back({box, e, is_valid(mesh, old[e])});
  }
  std::sort(by_low_.begin(), by_low_.end(), [](const OldElement& a, const OldElement& b) {
    return a.box.low.x < b.box.low.x || (a.box.low.x == b.box.low.x && a.index < b.index);
  });
}

void PatchFields::take_columns(const Mesh& mesh) {
  columns_.clear();
  for (int field = 0; field < static_cast<int>(mesh.fields().size()); ++field)
    for (int c = 0; c < mesh.fields()[index(field)].components; ++c) columns_.push_back({field, c, {}, 0, 0, 0, true});
  const Patch::Moments moments = patch_.moments_of(none);
  const std::span<const double> rows = patch_.all_rows();
  for (std::size_t c = 0; c < count_; ++c) {
    Column& column = columns_[c];
    column.linear = patch_.linear_of(static_cast<int>(c) + 2, none, moments);
    column.low = HUGE_VAL, column.high = -HUGE_VAL;
    double largest = 0;
    for (std::size_t i = 0; i < rows.size(); i += index(width_)) {
      const double value = rows[i + 2 + c];
      column.low = std::min(column.low, value);
      column.high = std::max(column.high, value);
      largest = std::max(largest, std::abs(value - patch_.evaluate(column.linear, {rows[i], rows[i + 1]})));
    }
    column.is_linear =
        largest <= patch_.rounding_of(column.linear, std::max(std::abs(column.low), std::abs(column.high)));
  }
}

void PatchFields::sample(const Point& place, std::span<double> residuals) const {
  std::fill(residuals.begin(), residuals.end(), 0.0);
  double depth = -HUGE_VAL;
  std::size_t best = 0;
  Barycentric xi{};
  auto next = std::lower_bound(by_low_.begin(), by_low_.end(), place.x - widest_,
                               [](const OldElement& e, double x) { return e.box.low.x < x; });
  for (; next != by_low_.end() && next->box.low.x <= place.x; ++next) {
    if (!next->box.contains(place) || (depth >= inside && !next->is_valid)) continue;
    const auto found = invert_map(degree_, old_net(next->index), place, tolerance_);
    if (!found) continue;
    const double least = std::min({(*found)[0], (*found)[1], (*found)[2]});
    const bool is_inside = least >= inside;
    if (!is_inside && least <= depth) continue;
    depth = least, best = next->index, xi = *found;
    if (is_inside && next->is_valid) break;
  }
  if (depth == -HUGE_VAL) return;  // Newton found no way into a folded element: the linear function
  const std::size_t length = size_ * count_;
  evaluate_net(degree_, static_cast<int>(count_), std::span<const double>(residuals_).subspan(best * length, length),
               clamped(xi), residuals);
}

void PatchFields::put_residuals(Mesh& mesh, PointId p, FaceId f, std::span<const double> residuals,
                                bool is_limited) const {
  for (std::size_t c = 0; c < count_; ++c) {
    const Column& column = columns_[c];
    const double trend = patch_.evaluate(column.linear, mesh.point(p));
    double value = column.is_linear ? trend : trend + residuals[c];
    if (is_limited && !column.is_linear) value = std::clamp(value, column.low, column.high);
    mesh.put_component(column.field, column.component, p, f, value);
  }
}

/// Sets the values of an element's corners, then those of its edges, then those inside. Values that a neighbour has set
/// stay.
namespace {

/// Where the interpolation node of control point k lies in an element of these coordinates.
Point place_of_node(const NetLayout& layout, int k, std::span<const double> coordinates) {
  Barycentric xi{};
  for (std::size_t c = 0; c < 3; ++c) xi[c] = static_cast<double>(layout.exponents(k)[c]) / layout.degree();
  Point place;
  evaluate_net(layout.degree(), 2, coordinates, xi, {&place.x, 2});
  return place;
}

}  // namespace

void PatchFields::fit_element(Mesh& mesh, TriangleId t, std::span<const PointId> free, bool is_limited) {
  const NetLayout& layout = mesh.layout();
  const auto ids = mesh.net(t);
  const FaceId f = mesh.face(t);
  const auto number_of = [&](PointId p) {
    const auto found = std::lower_bound(free.begin(), free.end(), p);
    return found != free.end() && *found == p ? found - free.begin() : -1;
  };
  const auto wants_value = [&](PointId p) { return number_of(p) >= 0 && !is_set_[index(number_of(p))]; };
  std::array<Point, net_size(max_degree)> net;
  mesh.gather_points(t, net);
  const std::span<const double> coordinates{&net[0].x, 2 * size_};
  std::vector<double> rows(size_ * count_), row(index(width_)), polygon(index(degree_ + 1) * count_);
  const auto row_of = [&](int k) { return std::span(rows).subspan(index(k) * count_, count_); };
  const auto read = [&](int k) {
    mesh.gather_row(ids[index(k)], f, row);
    for (std::size_t c = 0; c < count_; ++c)
      row_of(k)[c] = columns_[c].is_linear ? 0 : row[2 + c] - patch_.evaluate(columns_[c].linear, net[index(k)]);
  };
  const auto write = [&](int k) {
    put_residuals(mesh, ids[index(k)], f, row_of(k), is_limited);
    is_set_[index(number_of(ids[index(k)]))] = 1;
    read(k);  // as limited
  };
  const auto sample_node = [&](int k, std::span<double> out) { sample(place_of_node(layout, k, coordinates), out); };
  for (int c = 0; c < 3; ++c) {
    read(c);
    if (!wants_value(ids[index(c)])) continue;
    sample(net[index(c)], row_of(c));
    write(c);
  }
  for (int e = 0; e < 3 && degree_ > 1; ++e) {
    const bool is_known = !wants_value(ids[index(layout.edge_index(e, 1))]);
    for (int k = 0; k <= degree_; ++k) {
      const int n = layout.edge_index(e, k);
      if (is_known) read(n);
      const std::span<double> node = std::span(polygon).subspan(index(k) * count_, count_);
      if (is_known || k == 0 || k == degree_)
        std::copy_n(row_of(n).begin(), count_, node.begin());
      else
        sample_node(n, node);
    }
    if (is_known) continue;
    interpolate_polygon(degree_, static_cast<int>(count_), polygon);
    for (int k = 1; k < degree_; ++k) {
      const int n = layout.edge_index(e, k);
      std::copy_n(polygon.begin() + static_cast<std::ptrdiff_t>(index(k) * count_), count_, row_of(n).begin());
      write(n);
    }
  }
  if (layout.first_interior() == layout.size()) return;
  for (int k = layout.first_interior(); k < layout.size(); ++k) sample_node(k, row_of(k));
  interpolate_interior(degree_, static_cast<int>(count_), rows);
  for (int k = layout.first_interior(); k < layout.size(); ++k) write(k);
}

void PatchFields::put(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                      const RefitOptions& options) {
  if (count_ == 0) return;
  const bool is_limited = options.projection == Projection::limited;
  is_set_.assign(free.size(), 0);
  for (const TriangleId t : now) fit_element(mesh, t, free, is_limited);
  if (options.projection != Projection::l2) keep_integrals(mesh, now, free, is_limited);
}

/// Shifts the free values towards their bounds by an equal share of the room that each has; without bounds, or where
/// the room does not suffice, by the least change.
void PatchFields::keep_integrals(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                                 bool is_limited) {
  std::array<Point, net_size(max_degree)> net;
  std::array<double, net_size(max_degree)> weights;
  std::vector<double> total(free.size()), row(index(width_));
  const FaceId f = mesh.face(now.front());
  for (int round = 0; round < most_corrections; ++round) {
    std::vector<double> missing(count_), sizes(count_, 0.0);
    for (std::size_t c = 0; c < count_; ++c) missing[c] = columns_[c].integral;
    std::fill(total.begin(), total.end(), 0.0);
    for (const TriangleId t : now) {
      mesh.gather_points(t, net);
      integral_weights(degree_, {net.data(), size_}, weights);
      for (std::size_t k = 0; k < size_; ++k) {
        const PointId p = mesh.net(t)[k];
        const auto found = std::lower_bound(free.begin(), free.end(), p);
        if (found != free.end() && *found == p) total[index(found - free.begin())] += weights[k];
        mesh.gather_row(p, f, row);
        for (std::size_t c = 0; c < count_; ++c) {
          missing[c] -= weights[k] * row[2 + c];
          sizes[c] += std::abs(weights[k] * row[2 + c]);
        }
      }
    }
    bool any = false;
    for (std::size_t c = 0; c < count_; ++c) {
      if (!(std::abs(missing[c]) > rounding * sizes[c])) continue;
      any = true;
      const Column& column = columns_[c];
      const auto value = [&](std::size_t k) -> double {
        const Field& field = mesh.fields()[index(column.field)];
        return field.values[index(mesh.value_index(column.field, free[k], f) + column.component)];
      };
      const auto put_value = [&](std::size_t k, double v) {
        mesh.put_component(column.field, column.component, free[k], f, v);
      };
      const double bound = missing[c] > 0 ? column.high : column.low;
      double room = 0, squares = 0;
      for (std::size_t k = 0; k < free.size(); ++k) {
        room += total[k] * (bound - value(k));
        squares += total[k] * total[k];
      }
      const double share = missing[c] / room;
      if (is_limited && share > 0 && share <= 1) {
        for (std::size_t k = 0; k < free.size(); ++k) put_value(k, value(k) + share * (bound - value(k)));
      } else if (squares > 0) {
        const double step = missing[c] / squares;
        for (std::size_t k = 0; k < free.size(); ++k) put_value(k, value(k) + step * total[k]);
      }
    }
    if (!any) return;
  }
  // Without a free value those on the border take up what is missing, weighted by all elements around them.
  RegionIntegrals left;
  left.take(mesh, now);
  if (integrals_.change_to(left) > 4 * rounding) integrals_.restore(mesh, now, left);
}

}  // namespace pliant

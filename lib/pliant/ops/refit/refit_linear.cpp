// lib/pliant/ops/refit/refit_linear.cpp: the linear function that fits the old values of a patch best.
#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {

Patch::Moments Patch::moments_of(FaceId face) const {
  Moments m;
  const auto each = [&](auto&& visit) {
    for (const Element& e : elements_)
      if (face == none || e.face == face)
        for (int k = 0; k < n_; ++k) visit(old_point(e, k) - origin_);
  };
  each([&m](const Vector& d) {
    m.mean += d;
    ++m.count;
  });
  if (m.count > 0) m.mean = m.mean / m.count;
  double xx = 0, yy = 0, xy = 0;
  each([&](const Vector& d) {
    const Vector r = d - m.mean;
    xx += r.x * r.x;
    xy += r.x * r.y;
    yy += r.y * r.y;
  });
  // Gram-Schmidt, with the wider coordinate first. The squares of what is left of the other are summed directly: as a
  // difference of products they would be rounding alone in a sliver.
  m.along_x = xx >= yy;
  m.ss = std::max(xx, yy);
  m.lean = m.ss > 0 ? xy / m.ss : 0;
  each([&m](const Vector& d) {
    const auto [s, t] = m.split(d);
    m.tt += t * t;
  });
  const double width = 4e-16 * (size_ + std::max(std::abs(origin_.x), std::abs(origin_.y)));
  if (m.tt <= m.count * width * width) m.tt = 0;  // narrower than the coordinates' rounding
  return m;
}

Patch::Linear Patch::linear_of(int column, FaceId face) const { return linear_of(column, face, moments_of(face)); }

Patch::Linear Patch::linear_of(int column, FaceId face, const Moments& m) const {
  // About the mean, the constant can be found apart from the slopes. Values are taken relative to the first one, so
  // that constants come back without rounding.
  double base = 0, sum = 0, along = 0, across = 0;
  bool first = true;
  for (const Element& e : elements_) {
    if (face != none && e.face != face) continue;
    for (int k = 0; k < n_; ++k) {
      double u = rows_[e.first_row + index(k * width_ + column)];
      if (first) base = u, first = false;
      u -= base;
      sum += u;
      const auto [s, t] = m.split(old_point(e, k) - origin_);
      along += u * s;
      across += u * t;
    }
  }
  const double c = m.tt > 0 ? across / m.tt : 0, b = (m.ss > 0 ? along / m.ss : 0) - c * m.lean;
  const Vector slope = m.along_x ? Vector{b, c} : Vector{c, b};
  if (!is_finite(slope)) return {base, 0, 0};
  return {base + sum / m.count - dot(slope, m.mean), slope.x, slope.y};
}

}  // namespace pliant

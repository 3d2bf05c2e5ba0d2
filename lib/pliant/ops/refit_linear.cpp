// The linear function that fits the fields of a patch best: what fits keep to the last bits.
#include "pliant/ops/refit.h"

namespace pliant {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

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
  each([&m](const Vector& d) {
    const Vector r = d - m.mean;
    m.xx += r.x * r.x;
    m.xy += r.x * r.y;
    m.yy += r.y * r.y;
  });
  return m;
}

Patch::Linear Patch::linear_of(int column, FaceId face) const { return linear_of(column, face, moments_of(face)); }

Patch::Linear Patch::linear_of(int column, FaceId face, const Moments& m) const {
  // About the mean the constant parts from the slopes; less a value there is, constants come back without rounding.
  double base = 0, sum = 0;
  Vector right{};
  bool first = true;
  for (const Element& e : elements_) {
    if (face != none && e.face != face) continue;
    for (int k = 0; k < n_; ++k) {
      double u = rows_[e.first_row + at(k * width_ + column)];
      if (first) base = u, first = false;
      u -= base;
      sum += u;
      right += u * (old_point(e, k) - origin_ - m.mean);
    }
  }
  const double det = m.xx * m.yy - m.xy * m.xy;
  const Vector slope{(right.x * m.yy - right.y * m.xy) / det, (right.y * m.xx - right.x * m.xy) / det};
  if (!is_finite(slope)) return {base, 0, 0};
  return {base + sum / m.count - dot(slope, m.mean), slope.x, slope.y};
}

}  // namespace pliant

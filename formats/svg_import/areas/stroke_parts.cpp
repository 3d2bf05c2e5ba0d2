// formats/svg_import/areas/stroke_parts.cpp: the steps of an outline as smooth parts that know their normals.
#include "formats/svg_import/areas/stroke_parts.h"

#include <algorithm>

namespace pliant::svg {
namespace {

constexpr double vanishing_speed = 1e-9;  // a speed below this part of a curve's size counts as a stop
constexpr double slowest = 1e-7;          // a least speed up to this part is sought, and is an event
constexpr double straight = 1e-13;        // a curve that bends less than this part of its size is a line
constexpr int curvature_samples = 64;     // of the curvature, between which its events are found by halving

double size_of(const std::array<Point, 4>& c) {
  return std::max({distance(c[0], c[1]), distance(c[0], c[2]), distance(c[0], c[3])});
}

Vector unit(const Vector& v) { return v / length(v); }

}  // namespace

StrokePart StrokePart::cubic(const std::array<Point, 4>& points) {
  StrokePart part;
  part.c_ = points;
  part.start_ = points[0];
  part.end_ = points[3];
  const Vector chord = points[3] - points[0];
  const double size = size_of(points), along = squared_length(chord);
  // All control points on one line: the curve does not bend, but may stop and turn back.
  const Vector far =
      distance(points[0], points[1]) > distance(points[0], points[2]) ? points[1] - points[0] : points[2] - points[0];
  const Vector longest = squared_length(far) > along ? far : chord;
  part.is_bent_ = false;
  for (const Point& p : points)
    part.is_bent_ = part.is_bent_ || std::abs(cross(p - points[0], longest)) > straight * size * size;
  const auto is_on_chord = [&](const Point& p) {
    const double place = dot(p - points[0], chord);
    return std::abs(cross(p - points[0], chord)) <= straight * size * size && 0 <= place && place <= along;
  };
  const bool runs_on = dot(points[1] - points[0], chord) <= dot(points[2] - points[0], chord);
  part.kind_ = along > 0 && is_on_chord(points[1]) && is_on_chord(points[2]) && runs_on ? Kind::line : Kind::cubic;
  return part;
}

StrokePart StrokePart::arc(const Point& center, const Vector& u, const Vector& v, double from, double sweep,
                           const Point& start, const Point& end) {
  StrokePart part;
  part.kind_ = Kind::arc;
  part.c_ = {center, u, v, {}};
  part.first_ = from;
  part.last_ = from + sweep;
  part.start_ = start;
  part.end_ = end;
  return part;
}

Point StrokePart::at(double t) const {
  if (t == first_) return start_;
  if (t == last_) return end_;
  if (kind_ == Kind::line) return start_ + t * (end_ - start_);
  if (kind_ == Kind::arc) return c_[0] + c_[1] * std::cos(t) + c_[2] * std::sin(t);
  const double s = 1 - t;
  return s * s * s * c_[0] + 3 * s * s * t * c_[1] + 3 * s * t * t * c_[2] + t * t * t * c_[3];
}

Vector StrokePart::derivative(double t) const {
  if (kind_ == Kind::line) return end_ - start_;
  if (kind_ == Kind::arc) return c_[2] * std::cos(t) - c_[1] * std::sin(t);
  const double s = 1 - t;
  return 3 * (s * s * (c_[1] - c_[0]) + 2 * s * t * (c_[2] - c_[1]) + t * t * (c_[3] - c_[2]));
}

Vector StrokePart::second(double t) const {
  if (kind_ == Kind::line) return {};
  if (kind_ == Kind::arc) return -1 * (c_[1] * std::cos(t) + c_[2] * std::sin(t));
  return 6 * ((1 - t) * (c_[0] - 2 * c_[1] + c_[2]) + t * (c_[1] - 2 * c_[2] + c_[3]));
}

Vector StrokePart::tangent(double t) const {
  const double forward = last_ < first_ ? -1 : 1;
  Vector d = forward * derivative(t);
  if (kind_ != Kind::cubic) return unit(d);
  const double size = size_of(c_);
  if (pliant::length(d) > vanishing_speed * size) return unit(d);
  // Near a stop the curve leaves along its second derivative, or the third.
  const double side = t - first_ <= last_ - t ? 1 : -1;
  d = side * second(t);
  if (pliant::length(d) > vanishing_speed * size) return unit(d);
  d = c_[3] - c_[0];
  return pliant::length(d) > 0 ? unit(d) : Vector{1, 0};
}

double StrokePart::speed(double t) const { return pliant::length(derivative(t)); }

double StrokePart::curvature(double t) const {
  if (!is_bent_ || kind_ == Kind::line) return 0;
  const Vector d = derivative(t);
  const double speed = pliant::length(d), turned = cross(d, second(t));
  const double forward = last_ < first_ ? -1 : 1;
  return turned == 0 ? 0 : forward * turned / (speed * speed * speed);
}

double StrokePart::length(double from, double to) const {
  if (kind_ == Kind::line) return std::abs(to - from) * distance(start_, end_);
  static constexpr std::array<std::pair<double, double>, 3> gauss{{{0.2386191860831969, 0.4679139345726910},
                                                                   {0.6612093864662645, 0.3607615730481386},
                                                                   {0.9324695142031521, 0.1713244923791704}}};
  constexpr int pieces = 8;
  double sum = 0;
  const double half = (to - from) / (2 * pieces);
  for (int i = 0; i < pieces; ++i)
    for (const auto& [place, weight] : gauss) {
      const double middle = from + (2 * i + 1) * half;
      sum += weight * (speed(middle - half * place) + speed(middle + half * place));
    }
  return std::abs(half) * sum;
}

StrokePart StrokePart::between(double from, double to) const {
  StrokePart part = *this;
  part.start_ = at(from);
  part.end_ = at(to);
  if (kind_ == Kind::line) return part;
  part.first_ = from;
  part.last_ = to;
  return part;
}

void StrokePart::add_events(double r, std::vector<double>& out) const {
  if (kind_ == Kind::line) return;
  const auto excess = [&](double t, double sign) {  // changes its sign where the curvature is sign / r
    const Vector d = derivative(t);
    const double speed = pliant::length(d);
    return cross(d, second(t)) * r - sign * speed * speed * speed;
  };
  const double size = size_of(c_);
  const double step = (last_ - first_) / curvature_samples;
  for (const double sign : {-1.0, 1.0})
    for (int i = 0; i < curvature_samples && is_bent_; ++i) {
      double low = first_ + i * step, high = i + 1 == curvature_samples ? last_ : first_ + (i + 1) * step;
      const bool is_low_positive = excess(low, sign) > 0;
      if (is_low_positive == (excess(high, sign) > 0)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = low + (high - low) / 2;
        ((excess(middle, sign) > 0) == is_low_positive ? low : high) = middle;
      }
      out.push_back(high);
    }
  if (kind_ != Kind::cubic) return;
  // The derivative changes by at most this from one sample to the next: the second one is linear.
  const double most_change = step * std::max(pliant::length(second(first_)), pliant::length(second(last_)));
  for (int i = 0; i < curvature_samples; ++i) {  // the least speed between samples, by thirds
    double low = first_ + i * step, high = low + step;
    if (speed(low) - most_change > slowest * size) continue;
    for (int k = 0; k < 100; ++k) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (speed(a) < speed(b) ? high : low) = speed(a) < speed(b) ? b : a;
    }
    if (speed(low) <= slowest * size) out.push_back(low);
  }
}

std::vector<StrokePath> stroke_paths(const Outline& outline) {
  std::vector<StrokePath> paths;
  StrokePath path;
  Point at;
  bool is_drawn = false;
  const auto finish = [&](bool is_closed) {
    path.is_closed = is_closed;
    if (is_closed && !(at == path.start)) path.parts.push_back(StrokePart::cubic({at, at, path.start, path.start}));
    if (is_drawn || is_closed) paths.push_back(path);
    path.parts.clear();
    is_drawn = false;
  };
  const auto add = [&](const std::array<Point, 4>& c) {
    if (size_of(c) > 0) path.parts.push_back(StrokePart::cubic(c));
    at = c[3];
  };
  bool is_moved = false;
  std::size_t next = 0;
  for (const Step step : outline.steps) {
    const Point* p = outline.points.data() + next;
    next += static_cast<std::size_t>(point_count(step));
    if (step == Step::move) {
      if (is_moved) finish(false);
      path.start = at = p[0];
      is_moved = true;
      continue;
    }
    if (step == Step::close) {
      if (is_moved || is_drawn) finish(true);
      at = path.start;
      is_moved = false;
      continue;
    }
    is_drawn = is_moved = true;
    if (step == Step::line) {
      add({at, at, p[0], p[0]});
    } else if (step == Step::quadratic) {
      add({at, at + (2.0 / 3) * (p[0] - at), p[1] + (2.0 / 3) * (p[0] - p[1]), p[1]});
    } else if (step == Step::cubic) {
      add({at, p[0], p[1], p[2]});
    } else if (p[3].y != 0 && std::abs(cross(p[1], p[2])) > 0) {
      path.parts.push_back(StrokePart::arc(p[0], p[1], p[2], p[3].x, p[3].y, at, p[4]));
      at = p[4];
    } else {
      add({at, at, p[4], p[4]});
    }
  }
  if (is_moved) finish(false);
  return paths;
}

}  // namespace pliant::svg

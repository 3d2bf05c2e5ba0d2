// lib/pliant/generate/tame_spans.cpp: rounds that split spans which turn too much or come too close to each other.
#include "pliant/generate/tame_spans.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/hull_separation.h"
#include "pliant/generate/wedges.h"
#include "pliant/geometry/spline/turning_angle.h"

namespace pliant {
namespace {

constexpr double most_turning = std::numbers::pi / 3;
constexpr double least_length = 1e-13;  // least length of a span, in sizes of the boundary: what doubles can tell apart
constexpr double margin = 1e-13;        // for the rounding of control points: in sizes of a pair of spans, or radians
constexpr double sharp = 1e-3;          // radians: at smaller angles only very short spans have hulls that are apart
constexpr int most_taming_rounds = 200;

std::vector<Point> reversed(std::span<const Point> polygon) { return {polygon.rbegin(), polygon.rend()}; }

bool is_angle_below(double angle, const Vector& a, const Vector& b) {
  return dot(a, b) > 0 && std::fabs(cross(a, b)) <= angle * length(a) * length(b);
}

/// One look at all spans: which are to be split, where, and why.
class Round {
 public:
  explicit Round(const BoundaryComplex& boundary)
      : spans_(boundary), wedges_(boundary, spans_), wish_(spans_.size(), 0), rival_(wish_.size(), -1) {}

  const BoundarySpans& spans() const { return spans_; }
  /// Where each span is to be split; 0: not at all.
  const std::vector<double>& wishes() const { return wish_; }
  /// What is wrong with a span that is to be split, in words that name curves, parameters and coordinates.
  std::string describe(const BoundaryComplex& boundary, std::size_t i) const {
    const std::string place =
        describe_span(boundary, spans_[i]) + ", near " + describe_point(spans_.polygon(i).front());
    if (rival_[i] < 0) return place + ", turns too sharply";
    return place + ", comes too close to " + describe_span(boundary, spans_[static_cast<std::size_t>(rival_[i])]);
  }

  void find_turning() {
    for (std::size_t i = 0; i < spans_.size(); ++i)
      if (spans_[i].from == spans_[i].to || turning_angle(spans_.polygon(i)) > most_turning)
        wish_[i] = wedges_.middle_of(i);
  }

  void find_pairs() {
    std::vector<Box> boxes(spans_.size());
    for (std::size_t i = 0; i < spans_.size(); ++i) boxes[i] = spans_.box(i);
    for (const auto& [first, second] : overlapping_pairs(boxes)) {
      const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
      // Where one of a pair is split anyway, the pair is looked at again in the next round.
      if (wish_[i] > 0 || wish_[j] > 0) continue;
      compare(i, j);
    }
  }

 private:
  /// Splits two spans on the two sides of a narrow wedge so that their ends are at the same distances from the corner.
  /// Then their chords are in the order of the curves, however much these bend. False where the spans do not lead away
  /// from a common corner.
  bool level_apart(std::size_t i, std::size_t j) {
    const int corner = wedges_.corner_between(i, j);
    if (corner < 0) return false;
    const auto a = wedges_.ends(i, corner), b = wedges_.ends(j, corner);
    if (!a || !b || (*a)[1].radius <= (*b)[0].radius || (*b)[1].radius <= (*a)[0].radius) return false;
    const auto split_at = [&](std::size_t k, const std::array<Wedges::End, 2>& own, const Wedges::End& other,
                              std::size_t rival) {
      if (other.radius <= own[0].radius || other.radius >= own[1].radius) return;
      if (wedges_.are_level(own[0], other) || wedges_.are_level(own[1], other)) return;
      wish(k, wedges_.place_at(k, corner, other.radius), rival);
    };
    for (const Wedges::End& end : *b) split_at(i, *a, end, j);
    for (const Wedges::End& end : *a) split_at(j, *b, end, i);
    return true;
  }

  void compare(std::size_t i, std::size_t j) {
    const BoundarySpan &a = spans_[i], &b = spans_[j];
    const bool joined_at_start = a.from == b.from || a.from == b.to;
    const bool joined_at_end = a.to == b.from || a.to == b.to;
    if (joined_at_start && joined_at_end) {
      wish(i, 0.5, j);
      wish(j, 0.5, i);
      return;
    }
    if (!joined_at_start && !joined_at_end) {
      Box both;
      for (const std::size_t k : {i, j})
        for (const Point& p : spans_.polygon(k)) both.extend(p);
      if (!hulls_apart(spans_.polygon(i), spans_.polygon(j), margin * both.size()) && !level_apart(i, j))
        split_thicker(i, j);
      return;
    }
    const int node = joined_at_start ? a.from : a.to;
    const std::vector<Point> from_a = outward(i, node), from_b = outward(j, node);
    if (is_narrow(tangent_at_end(from_a, true), tangent_at_end(from_b, true)))
      level_ends(i, j, node, from_a, from_b);
    else if (!cones_apart(from_a, from_b, margin))
      split_thicker(i, j);
  }

  void wish(std::size_t i, double s, std::size_t rival) {
    wish_[i] = s;
    rival_[i] = static_cast<int>(rival);
  }

  /// The polygon of span i relative to one of its ends, which comes first.
  std::vector<Point> outward(std::size_t i, int node) const {
    const auto polygon = spans_.polygon(i);
    std::vector<Point> result =
        spans_[i].from == node ? std::vector<Point>(polygon.begin(), polygon.end()) : reversed(polygon);
    const Point origin = result.front();
    for (Point& p : result) p -= origin;
    return result;
  }

  /// Splits that one of two spans which is further from its chord, since splitting a straight one would not help. Two
  /// straight ones are apart as they are.
  void split_thicker(std::size_t i, std::size_t j) {
    const double height_i = hull_height(spans_.polygon(i)), height_j = hull_height(spans_.polygon(j));
    const Box box_i = spans_.box(i), box_j = spans_.box(j);
    const double rounding = 1e-15 * (box_i.size() + box_j.size()) + 0x1p-51 * std::max(box_i.reach(), box_j.reach());
    if (std::max(height_i, height_j) <= rounding) return;
    const auto [thicker, rival] = height_i >= height_j ? std::pair(i, j) : std::pair(j, i);
    wish(thicker, wedges_.middle_of(thicker), rival);
  }

  void level_ends(std::size_t i, std::size_t j, int node, std::span<const Point> a, std::span<const Point> b) {
    const double length_a = length(a.back()), length_b = length(b.back());
    const double shorter = std::min(length_a, length_b), longer = std::max(length_a, length_b);
    if (wedges_.are_level({length_a, a.back()}, {length_b, b.back()})) return;
    // Both are cut at the same distance; only the longer one where that leaves no sliver beyond the cut.
    const double radius = longer < 2 * shorter ? shorter / 2 : shorter;
    for (const auto& [k, length, rival] : {std::tuple(i, length_a, j), std::tuple(j, length_b, i)})
      if (length > (1 + 1e-9) * radius) wish(k, wedges_.place_at(k, node, radius), rival);
  }

  BoundarySpans spans_;
  Wedges wedges_;
  std::vector<double> wish_;
  std::vector<int> rival_;  // the span from which each is to be kept apart; -1: it turns too much
};

}  // namespace

std::string describe_span(const BoundaryComplex& boundary, const BoundarySpan& span) {
  return describe_curve(boundary, span.curve) + ", parameters " + describe_number(span.t0) + " to " +
         describe_number(span.t1);
}

Vector tangent_at_end(std::span<const Point> polygon, bool at_start) {
  const Point origin = at_start ? polygon.front() : polygon.back();
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const Point& p = at_start ? polygon[k] : polygon[polygon.size() - 1 - k];
    if (!(p == origin)) return p - origin;
  }
  return {};
}

bool is_narrow(const Vector& a, const Vector& b) { return is_angle_below(sharp, a, b); }

bool is_cusp(const Vector& a, const Vector& b) { return is_angle_below(1e-9, a, b); }

double least_span(const BoundaryComplex& boundary) {
  const Box box = bounding_box(boundary);
  return std::max(least_length * box.size(), 0x1p-46 * box.reach());  // far from the origin doubles tell less apart
}

bool split_span(BoundaryComplex& boundary, const BoundarySpan& span, double least, double s) {
  const double t = span.t0 + s * (span.t1 - span.t0);
  if (!(span.t0 < t && t < span.t1)) return false;
  BSpline& spline = boundary.curves[static_cast<std::size_t>(span.curve)].spline;
  const Point middle = spline.evaluate(t);
  if (distance(spline.evaluate(span.t0), middle) < least || distance(middle, spline.evaluate(span.t1)) < least)
    return false;
  spline.insert_knot(t);
  return true;
}

TameOutcome tame_spans(BoundaryComplex& boundary) {
  TameOutcome outcome;
  const double least = least_span(boundary);
  for (int i = 0; i < most_taming_rounds; ++i) {
    Round round(boundary);
    round.find_turning();
    round.find_pairs();
    std::string wrong;
    bool any = false;
    for (std::size_t k = 0; k < round.spans().size(); ++k) {
      const double s = round.wishes()[k];
      if (s == 0) continue;
      any = true;
      if (i + 1 == most_taming_rounds && wrong.empty()) wrong = round.describe(boundary, k);
      ++outcome.splits;
      if (split_span(boundary, round.spans()[k], least, s)) continue;
      outcome.failure = round.describe(boundary, k) + ": a span would be shorter than 1e-13 of the boundary's size";
      return outcome;
    }
    if (!any) return outcome;
    outcome.failure = std::move(wrong);
  }
  outcome.failure += ", after " + std::to_string(most_taming_rounds) + " rounds of splits";
  return outcome;
}

}  // namespace pliant

// lib/pliant/quality/too_curved.cpp: measures against bounds, with a quick proof for elements that are surely fine.
#include "pliant/quality/too_curved.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/spline/turning_angle.h"
#include "pliant/quality/element/element_forms.h"
#include "pliant/quality/element/element_quality.h"

namespace pliant {
namespace {

constexpr double margin = 1e-9;  // what is_surely_fine proves holds with this relative margin for rounding
constexpr double worst_valid = 0.999 * tangled_excess;  // the excess of a certified element is at most this

/// The largest turning of the edges that are not fixed.
double turning_of(int degree, std::span<const Point> net, unsigned fixed) {
  if (fixed == 0) return element_turning(degree, net);
  const NetLayout& layout = NetLayout::of(degree);
  std::array<Point, max_degree + 1> polygon;
  double largest = 0;
  for (int e = 0; e < 3; ++e) {
    if ((fixed >> e & 1) != 0) continue;
    for (int k = 0; k <= degree; ++k) polygon[index(k)] = net[index(layout.edge_index(e, k))];
    largest = std::max(largest, turning_angle(std::span(polygon).first(index(degree + 1))));
  }
  return largest;
}

}  // namespace

CurvatureTest::CurvatureTest(int degree, const CurvatureBounds& bounds)
    : degree_(degree),
      bounds_(bounds),
      // A curve turns by no more than its control polygon (Bernstein polynomials diminish variation).
      least_cosine_(degree > 1 ? std::cos(std::min(bounds.max_turning / (degree - 1), std::numbers::pi)) : -1),
      most_change_(greatest_change(bounds)),
      // Each leg is off the chord by an angle whose sine is at most the offset over half the chord.
      most_offset_((1 - margin) / 2 * std::sin(std::min(bounds.max_turning, std::numbers::pi) / 2)) {}

// A quadratic element differs from its straight triangle by the offsets d of its edges' middle points from those of the
// chords. With T twice the triangle's area, L its longest side and r = (8 L |d| + 16 |d|^2) / T, all coefficients of
// det J are within r T of T, and those of the other form (element_forms.h) within sqrt(3) r of its constant value,
// relatively, since that is at least sqrt(3) T. So r decides all measures but the turning.
double CurvatureTest::greatest_change(const CurvatureBounds& bounds) {
  const double peak = (bounds.max_peak - 1) / (bounds.max_peak + 1);
  const double scaled = (1 - bounds.min_scaled_jacobian) / (1 + bounds.min_scaled_jacobian);
  const double shape = (1 - bounds.min_shape_ratio) / (1 + std::numbers::sqrt3 * bounds.min_shape_ratio);
  const double spread = std::sqrt(std::max(bounds.max_distortion - 1, 0.0));  // D - 1 <= (r / (1 - r))^2
  return std::min({peak, scaled, shape, spread / (1 + spread)}) * (1 - margin);
}

/// Proves quickly that a quadratic element is fine where it differs little from a straight triangle; false proves
/// nothing.
bool CurvatureTest::is_nearly_straight(std::span<const Point> net) const {
  if (degree_ != 2) return false;
  const Point &a = net[0], &b = net[1], &c = net[2];
  const Vector ab = b - a, bc = c - b, ca = a - c;
  const double lengths[3] = {squared_length(ab), squared_length(bc), squared_length(ca)};
  const Vector offsets[3] = {(net[3] - a) - 0.5 * ab, (net[4] - b) - 0.5 * bc, (net[5] - c) - 0.5 * ca};
  double offset = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const double squared = squared_length(offsets[e]);
    if (!(squared <= most_offset_ * most_offset_ * lengths[e])) return false;
    offset = std::max(offset, squared);
  }
  const double longest = std::max({lengths[0], lengths[1], lengths[2]}), twice_area = cross(ca, ab);
  // Beyond these lengths products over- or underflow.
  if (!(longest < 1e140 && longest > 1e-140 && twice_area > 1e-6 * longest)) return false;
  return 8 * std::sqrt(longest * offset) + 16 * offset + margin * longest <= most_change_ * twice_area;
}

double CurvatureTest::excess(std::span<const Point> net, unsigned fixed) const {
  ElementForms forms;
  element_forms(degree_, net, forms);
  if (!forms.is_finite) return HUGE_VAL;
  const double shape = curved_shape(forms);
  if (!(shape > 0)) return tangled_excess * (1 - std::max(shape, -1.0));
  const double logical = std::fabs(triangle_shape(net[0], net[1], net[2]));
  const double worst =
      std::max({(distortion(forms) - 1) / (bounds_.max_distortion - 1), jacobian_peak(forms) / bounds_.max_peak,
                bounds_.min_shape_ratio * logical / shape, turning_of(degree_, net, fixed) / bounds_.max_turning});
  const auto [least, most] = std::minmax_element(forms.jacobian.begin(), forms.jacobian.begin() + forms.size());
  // The coefficients bound the scaled Jacobian. If another measure is worse even so, closer bounds are not needed.
  if (*least * worst >= bounds_.min_scaled_jacobian * *most) return std::min(worst, worst_valid);
  const double scaled = scaled_jacobian(forms, jacobian_range(forms, usual_range_width));
  if (!(scaled > 0)) return worst_valid;
  return std::min(std::max(worst, bounds_.min_scaled_jacobian / scaled), worst_valid);
}

bool CurvatureTest::is_surely_fine(std::span<const Point> net, unsigned fixed) const {
  ElementForms forms;
  element_forms(degree_, net, forms);
  if (!forms.is_finite || forms.is_point) return false;
  const auto coefficients = std::span<const double>(forms.jacobian).first(index(forms.size()));
  double sum = 0, least = coefficients[0], most = least;
  for (const double c : coefficients) {
    sum += c;
    least = std::min(least, c);
    most = std::max(most, c);
  }
  const double mean = sum / forms.size(), sure = 1 - margin;
  if (!(least > 4 * forms.error && most <= sure * bounds_.max_peak * mean)) return false;
  if (!(least * sure >= bounds_.min_scaled_jacobian * most)) return false;
  // The variance of values between two bounds is at most this product (Bhatia, Davis).
  if (!((most - mean) * (mean - least) <= sure * (bounds_.max_distortion - 1) * mean * mean)) return false;
  const double wanted = bounds_.min_shape_ratio * std::fabs(triangle_shape(net[0], net[1], net[2])) *
                        std::numbers::inv_sqrt3 * (1 + margin);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    if (!(coefficients[n] - forms.error >= wanted * (forms.squares[n] + forms.error))) return false;
  const NetLayout& layout = NetLayout::of(degree_);
  for (int e = 0; e < 3; ++e)
    for (int k = 1; k < degree_ && (fixed >> e & 1) == 0; ++k) {
      const auto leg = [&](int i) {
        return net[index(layout.edge_index(e, i + 1))] - net[index(layout.edge_index(e, i))];
      };
      if (!is_turn_within(leg(k - 1), leg(k), least_cosine_)) return false;
    }
  return true;
}

double curvature_excess(int degree, std::span<const Point> net, const CurvatureBounds& bounds) {
  return CurvatureTest(degree, bounds).excess(net);
}

}  // namespace pliant

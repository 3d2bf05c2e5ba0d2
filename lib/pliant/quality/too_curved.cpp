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

constexpr double margin = 1e-9;       // what is_surely_fine proves holds with this relative margin for rounding
constexpr double range_width = 1e-3;  // relative width of the bounds of det J: the same as in scaled_jacobian
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
      least_cosine_(degree > 1 ? std::cos(std::min(bounds.max_turning / (degree - 1), std::numbers::pi)) : -1) {}

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
  const double scaled = scaled_jacobian(forms, jacobian_range(forms, range_width));
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

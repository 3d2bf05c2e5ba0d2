// formats/picture/svg/path.cpp: numbers and Bézier curves as SVG's path data, y upwards.
#include "formats/picture/svg/path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

constexpr int max_path_halvings = 16;
constexpr double path_rounding = 0x1p-46;  // of a distance of control points, as a part of the greatest coordinate

std::vector<double> coordinates(const std::vector<Point>& polygon) {
  std::vector<double> rows;
  for (const Point& p : polygon) rows.insert(rows.end(), {p.x, p.y});
  return rows;
}

/// The cubic that has the ends and the end derivatives of the curve with this control polygon.
std::vector<double> hermite_cubic(const std::vector<double>& polygon) {
  const std::size_t n = polygon.size();
  const std::size_t degree = n / 2 - 1;
  const double pull = double(degree) / 3;
  std::vector<double> cubic;
  for (std::size_t c = 0; c < 2; ++c) cubic.push_back(polygon[c]);
  for (std::size_t c = 0; c < 2; ++c) cubic.push_back(polygon[c] + pull * (polygon[2 + c] - polygon[c]));
  for (std::size_t c = 0; c < 2; ++c)
    cubic.push_back(polygon[n - 2 + c] + pull * (polygon[n - 4 + c] - polygon[n - 2 + c]));
  for (std::size_t c = 0; c < 2; ++c) cubic.push_back(polygon[n - 2 + c]);
  return cubic;
}

/// Upper bound of the distance of two curves at equal parameters: the greatest distance of their control points in the
/// same degree.
double distance_bound(const std::vector<double>& polygon, std::vector<double> lower) {
  while (lower.size() < polygon.size()) {
    std::vector<double> raised(lower.size() + 2);
    elevate_polygon(static_cast<int>(lower.size() / 2) - 1, 2, lower, raised);
    lower = std::move(raised);
  }
  double most = 0;
  for (std::size_t i = 0; i < polygon.size(); i += 2)
    most = std::max(most, std::hypot(polygon[i] - lower[i], polygon[i + 1] - lower[i + 1]));
  return most;
}

}  // namespace

SvgPath::SvgPath(std::string& out, double size, double tolerance, double resolution)
    : out_(out), tolerance_(tolerance), decimals_(-1) {
  // Outside of this range decimal fractions would be long, and renderers fail anyway.
  if (size > 1e-6 && size < 1e7)
    decimals_ = std::max(0, static_cast<int>(std::ceil(-std::log10(resolution)) - std::floor(std::log10(size))));
}

/// Is the curve its chord, at even speed, up to the rounding of numbers?
bool SvgPath::is_straight(const std::vector<Point>& polygon) const {
  if (decimals_ < 0) return false;
  const double half = 0.5 * std::pow(10, -decimals_), p = static_cast<double>(polygon.size() - 1);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const double s = static_cast<double>(k) / p;
    if (distance(polygon[k], (1 - s) * polygon.front() + s * polygon.back()) > half) return false;
  }
  return true;
}

SvgPath& SvgPath::number(double value) {
  std::array<char, 400> text;
  if (decimals_ < 0) {
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0).ptr;
    out_.append(text.data(), end);
    return *this;
  }
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals_);
  const char* end = written.ptr;
  if (decimals_ > 0) {
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
  }
  const std::string_view digits(text.data(), static_cast<std::size_t>(end - text.data()));
  out_ += digits == "-0" ? std::string_view("0") : digits;
  return *this;
}

SvgPath& SvgPath::point(const Point& p) { return number(p.x).text(" ").number(-p.y); }

SvgPath& SvgPath::move_to(const Point& p) { return text("M").point(p); }

SvgPath& SvgPath::curve_to(const std::vector<Point>& polygon) {
  const std::size_t degree = polygon.size() - 1;
  if (is_straight(polygon)) return text("L").point(polygon.back());
  if (degree > 3) {
    cubics(coordinates(polygon), 0);
    return *this;
  }
  text(degree == 1 ? "L" : degree == 2 ? "Q" : "C").point(polygon[1]);
  for (std::size_t k = 2; k <= degree; ++k) text(" ").point(polygon[k]);
  return *this;
}

void SvgPath::cubics(const std::vector<double>& polygon, int depth) {
  const std::vector<double> cubic = hermite_cubic(polygon);
  double reach = 0;
  for (const double x : polygon) reach = std::max(reach, std::abs(x));
  if (depth >= max_path_halvings || distance_bound(polygon, cubic) <= std::max(tolerance_, path_rounding * reach)) {
    text("C").point({cubic[2], cubic[3]}).text(" ").point({cubic[4], cubic[5]}).text(" ").point({cubic[6], cubic[7]});
    return;
  }
  std::vector<double> left(polygon.size()), right(polygon.size());
  split_polygon(static_cast<int>(polygon.size() / 2) - 1, 2, polygon, 0.5, left, right);
  cubics(left, depth + 1);
  cubics(right, depth + 1);
}

}  // namespace pliant

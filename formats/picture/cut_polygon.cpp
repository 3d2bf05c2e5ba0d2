// formats/picture/cut_polygon.cpp: a polygon cut into triangles without further vertices, ear by ear.
#include "formats/picture/cut_polygon.h"

#include "pliant/geometry/predicates.h"

namespace pliant {
namespace {

/// Area over squared sides: 0 where the triangle is flat, least where it is turned over.
double shape(const Point& a, const Point& b, const Point& c) {
  const Vector u = b - a, v = c - b, w = a - c;
  const double sides = dot(u, u) + dot(v, v) + dot(w, w);
  return sides > 0 ? cross(u, v) / sides : 0;
}

bool is_left(const Point& a, const Point& b, const Point& c) { return orient2d(a, b, c) > 0; }

class EarCutter {
 public:
  explicit EarCutter(const std::vector<Point>& corners) : corners_(corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) rest_.push_back(static_cast<int>(k));
  }

  std::vector<std::array<int, 3>> cut() {
    std::vector<std::array<int, 3>> triangles;
    while (rest_.size() >= 3) {
      const std::size_t best = best_corner();
      triangles.push_back({number(best + rest_.size() - 1), number(best), number(best + 1)});
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
  }

 private:
  /// The ear of the best shape; where there is no ear, as in polygons that cross themselves, the corner of the best.
  std::size_t best_corner() const {
    std::size_t ear = rest_.size(), corner = 0;
    double best_ear = 0, best = -1;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const double s = shape(at(k + rest_.size() - 1), at(k), at(k + 1));
      if (s > best) best = s, corner = k;
      if (s > best_ear && is_ear(k)) best_ear = s, ear = k;
    }
    return ear < rest_.size() ? ear : corner;
  }
  int number(std::size_t k) const { return rest_[k % rest_.size()]; }
  const Point& at(std::size_t k) const { return corners_[static_cast<std::size_t>(number(k))]; }
  /// No other corner may be in the triangle or on its new side, or what is left would be pinched or flat.
  bool is_ear(std::size_t k) const {
    const std::size_t n = rest_.size();
    const Point &a = at(k + n - 1), &b = at(k), &c = at(k + 1);
    if (!is_left(a, b, c)) return false;
    for (std::size_t i = 2; i + 1 < n; ++i) {
      const Point& p = at(k + i);
      if (!is_left(b, a, p) && !is_left(c, b, p) && !is_left(a, c, p)) return false;
    }
    return true;
  }

  const std::vector<Point>& corners_;
  std::vector<int> rest_;
};

}  // namespace

std::vector<std::array<int, 3>> cut_polygon(const std::vector<Point>& corners) { return EarCutter(corners).cut(); }

}  // namespace pliant

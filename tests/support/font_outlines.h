// tests/support/font_outlines.h: the outlines of a TrueType font as boundary complexes.
#pragma once
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_complex.h"

namespace pliant::samples {

/// One quadratic piece of a contour. Coordinates are integers and halves (font units), so sums of products are exact.
struct Conic {
  Point from, control, to;
};
using Contour = std::vector<Conic>;

/// Half the integral of x dy - y dx along a contour; exact for coordinates of a font.
inline double enclosed_area(const Contour& contour) {
  double sixfold = 0;
  for (const Conic& c : contour)
    sixfold += 2 * cross(c.from, c.control) + 2 * cross(c.control, c.to) + cross(c.from, c.to);
  return sixfold / 6;
}

/// The angle, seen from p, by which a piece turns around p. The piece is cut until p lies outside the boxes of its
/// parts.
inline double seen_angle(const Conic& c, const Point& p, int depth = 0) {
  Box box;
  for (const Point& q : {c.from, c.control, c.to}) box.extend(q);
  const bool beside = p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y;
  if (beside || depth == 40) return std::atan2(cross(c.from - p, c.to - p), dot(c.from - p, c.to - p));
  const Point left = (c.from + c.control) / 2, right = (c.control + c.to) / 2, middle = (left + right) / 2;
  return seen_angle({c.from, left, middle}, p, depth + 1) + seen_angle({middle, right, c.to}, p, depth + 1);
}

/// How often a contour runs around p, which is not on it.
inline int winding_number(const Contour& contour, const Point& p) {
  double angle = 0;
  for (const Conic& c : contour) angle += seen_angle(c, p);
  return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

enum class Join { smooth, corner, cusp };
/// How a piece continues into the next one; exact, because the coordinates are short.
inline Join join(const Conic& before, const Conic& after) {
  const Vector in = before.to - before.control, out = after.control - after.from;
  if (cross(in, out) != 0) return Join::corner;
  return dot(in, out) > 0 ? Join::smooth : Join::cusp;
}

/// Successive pieces as one quadratic B-spline. Where two legs are in line it has a simple knot, which is placed such
/// that the spline is C1; it has double knots at all other joins, and where a closed one begins.
inline BSpline spline_through(const std::vector<Conic>& pieces, bool closed) {
  std::vector<double> knots{0};
  std::vector<std::size_t> piece_after{0};  // the piece that follows each knot
  double step = 1;
  for (std::size_t i = 1; i <= pieces.size(); ++i) {
    const bool is_smooth = i < pieces.size() && join(pieces[i - 1], pieces[i]) == Join::smooth;
    const double next = knots.back() + step;
    for (int k = 0; k < (is_smooth ? 1 : 2); ++k) {
      knots.push_back(next);
      piece_after.push_back(i);
    }
    step = is_smooth
               ? step * length(pieces[i].control - pieces[i].from) / length(pieces[i - 1].to - pieces[i - 1].control)
               : 1;
  }
  // On a closed spline the knots are one period: the first break has its second knot at the end.
  const std::size_t end = knots.size() - 1, n = pieces.size();
  if (!closed) {
    knots.insert(knots.begin(), 2, 0.0);
    knots.push_back(knots.back());
  }
  std::vector<Point> points;
  if (!closed) points = {pieces.front().from, pieces.front().control};
  for (std::size_t i = 0; i + (closed ? 0 : 1) < end; ++i) {
    const auto piece = [&](std::size_t k) { return k <= end ? piece_after[k] : n + piece_after[k - end]; };
    const std::size_t one = piece(i + 1), other = piece(i + 2);
    if (!closed && one == n)
      points.push_back(pieces.back().to);
    else
      points.push_back(one == other ? pieces[one % n].from : pieces[one % n].control);
  }
  return BSpline(2, closed, std::move(knots), std::move(points));
}

/// Adds a contour as one closed curve, or, if it has cusps, as curves from cusp to cusp. Cusps become vertices.
inline void add_contour(BoundaryComplex& boundary, Contour contour, const std::string& name, int left, int right) {
  const std::size_t n = contour.size();
  const auto is_cusp = [&](std::size_t i) { return join(contour[(i + n - 1) % n], contour[i]) == Join::cusp; };
  std::size_t first = 0;
  while (first < n && !is_cusp(first)) ++first;
  Curve curve;
  curve.name = name;
  curve.left = left;
  curve.right = right;
  if (first == n) {
    curve.spline = spline_through(contour, true);
    boundary.curves.push_back(std::move(curve));
    return;
  }
  std::rotate(contour.begin(), contour.begin() + static_cast<std::ptrdiff_t>(first), contour.end());
  const int first_vertex = static_cast<int>(boundary.vertices.size());
  std::vector<Conic> pieces;
  for (std::size_t i = 0; i < n; ++i) {
    if (pieces.empty()) {
      curve.start = static_cast<int>(boundary.vertices.size());
      boundary.vertices.push_back(contour[i].from);
    }
    pieces.push_back(contour[i]);
    if (i + 1 < n && !is_cusp(i + 1)) continue;
    curve.end = i + 1 < n ? static_cast<int>(boundary.vertices.size()) : first_vertex;
    curve.spline = spline_through(pieces, false);
    boundary.curves.push_back(curve);
    pieces.clear();
  }
}

/// A TrueType font, opened with FreeType.
class Font {
 public:
  explicit Font(const std::string& path) {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Face(library_, path.c_str(), 0, &face_) != 0) {
      FT_Done_FreeType(library_);
      throw std::runtime_error("FreeType cannot read " + path);
    }
  }
  ~Font() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  int glyph_count() const { return static_cast<int>(face_->num_glyphs); }

  /// The contours of a glyph, reversed so that outer ones run counter-clockwise. Pieces without length are left out,
  /// and so are contours of fewer than three points, which only mark places.
  std::vector<Contour> contours(int glyph) const {
    if (FT_Load_Glyph(face_, static_cast<FT_UInt>(glyph), FT_LOAD_NO_SCALE | FT_LOAD_IGNORE_TRANSFORM) != 0)
      throw std::runtime_error("FreeType cannot load glyph " + std::to_string(glyph));
    // Points are read one by one, because FT_Outline_Decompose would round implied points to integers.
    const FT_Outline& outline = face_->glyph->outline;
    std::vector<Contour> result;
    int first = 0;
    for (int k = 0; k < outline.n_contours; ++k) {
      const int end = outline.contours[k] + 1;
      if (end - first >= 3) result.push_back(contour(outline, first, end));
      if (!result.empty() && result.back().empty()) result.pop_back();
      first = end;
    }
    return result;
  }

 private:
  static Contour contour(const FT_Outline& outline, int first, int end) {
    const int count = end - first;
    const auto index = [&](int i) { return end - 1 - i % count; };  // backwards
    const auto at = [&](int i) {
      const FT_Vector& v = outline.points[index(i)];
      return Point{static_cast<double>(v.x), static_cast<double>(v.y)};
    };
    const auto is_on = [&](int i) { return FT_CURVE_TAG(outline.tags[index(i)]) == FT_CURVE_TAG_ON; };
    Contour result;
    const auto add = [&result](const Point& from, const Point& control, const Point& to) {
      if (from == to && from == control) return;
      // With a control point on an end the piece is a line whose derivative vanishes there, so the point is moved.
      const bool is_line = control == from || control == to;
      result.push_back({from, is_line ? (from + to) / 2 : control, to});
    };
    for (int i = count; i < 2 * count; ++i) {
      if (!is_on(i)) {
        const Point from = is_on(i - 1) ? at(i - 1) : (at(i - 1) + at(i)) / 2;
        add(from, at(i), is_on(i + 1) ? at(i + 1) : (at(i) + at(i + 1)) / 2);
      } else if (is_on(i + 1)) {
        add(at(i), (at(i) + at(i + 1)) / 2, at(i + 1));
      }
    }
    return result;
  }

  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// A boundary with the face "ink" on the left of every contour, which is right for fonts that turn all contours
/// properly.
inline BoundaryComplex boundary_as_drawn(const std::vector<Contour>& contours) {
  BoundaryComplex boundary;
  boundary.faces.push_back({"ink", {}});
  for (std::size_t i = 0; i < contours.size(); ++i)
    add_contour(boundary, contours[i], "contour " + std::to_string(i), 0, outside);
  return boundary;
}

/// A boundary with the face "ink" by the nonzero rule, for contours that neither cross nor touch. Contours with ink on
/// both sides bound nothing and are left out. `area` becomes the area of the face, computed from the contours.
inline BoundaryComplex boundary_by_nonzero(const std::vector<Contour>& contours, double& area) {
  BoundaryComplex boundary;
  boundary.faces.push_back({"ink", {}});
  area = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const double enclosed = enclosed_area(contours[i]);
    int right = enclosed < 0 ? -1 : 0;  // the winding number on the right of the contour
    for (std::size_t j = 0; j < contours.size(); ++j)
      if (j != i) right += winding_number(contours[j], contours[i].front().from);
    const bool ink_on_right = right != 0, ink_on_left = right + 1 != 0;
    if (ink_on_left == ink_on_right) continue;
    area += ink_on_left ? enclosed : -enclosed;
    add_contour(boundary, contours[i], "contour " + std::to_string(i), ink_on_left ? 0 : outside,
                ink_on_right ? 0 : outside);
  }
  return boundary;
}

}  // namespace pliant::samples

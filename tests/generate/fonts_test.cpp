// tests/generate/fonts_test.cpp: every glyph of Debian's fonts-dejavu-core, whose outlines are quadratic B-splines.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>

#include "generate/meshed_boundary.h"
#include "pliant/improve/refine.h"
#include "support/font_outlines.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

#ifdef NDEBUG
constexpr int stride = 1;
#else
constexpr int stride = 16;  // with assertions and sanitizers a glyph takes about 16 times as long
#endif
constexpr double radian = 180 / std::numbers::pi;

const char* const folder = "/usr/share/fonts/truetype/dejavu/";

constexpr double close = 1e-6;  // nearer is a contact: in font units, of which a glyph has some thousand

/// Distance of p from the piece, found by narrowing the interval around the nearest of 257 points.
double distance_from(const Conic& c, const Point& p) {
  const auto at = [&](double t) {
    const double s = 1 - t;
    return distance(p, s * s * c.from + 2 * s * t * c.control + t * t * c.to);
  };
  double best = 0;
  for (int i = 1; i <= 256; ++i)
    if (at(i / 256.0) < at(best)) best = i / 256.0;
  double low = std::max(0.0, best - 1 / 256.0), high = std::min(1.0, best + 1 / 256.0);
  for (int i = 0; i < 80; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    (at(left) < at(right) ? high : low) = at(left) < at(right) ? right : left;
  }
  return at(low);
}

/// Do two pieces meet here, other than where neighbours join?
bool is_contact(const std::vector<Contour>& contours, const Point& p) {
  std::vector<Conic> here;
  for (const Contour& contour : contours)
    for (const Conic& c : contour)
      if (distance_from(c, p) < close) here.push_back(c);
  if (here.size() != 2) return here.size() > 2;
  const auto is_join_elsewhere = [&](const Point& a, const Point& b) { return !(a == b) || distance(a, p) > close; };
  return is_join_elsewhere(here[0].to, here[1].from) && is_join_elsewhere(here[1].to, here[0].from);
}

/// The place that ends a fault's text: "..., at (0.25, 1)".
Point place_in(const std::string& text) {
  const std::size_t open = text.rfind('('), comma = text.find(',', open);
  REQUIRE(comma != std::string::npos);
  return {std::strtod(text.c_str() + open + 1, nullptr), std::strtod(text.c_str() + comma + 1, nullptr)};
}

/// Places where the contours cross or touch. Sides of faces are not checked: some contours of these fonts run the wrong
/// way round, which the nonzero rule mends.
std::vector<Fault> contacts(const std::vector<Contour>& contours) {
  return check_boundary_geometry(boundary_as_drawn(contours));
}

/// Corners of less than 60 degrees, of the ink or of the paper between.
std::vector<Point> sharp_corners(const std::vector<Contour>& contours) {
  std::vector<Point> corners;
  for (const Contour& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Conic& before = contour[(i + contour.size() - 1) % contour.size()];
      const Vector back = before.control - before.to, on = contour[i].control - contour[i].from;
      if (std::atan2(std::fabs(cross(on, back)), dot(on, back)) * radian < 60) corners.push_back(contour[i].from);
    }
  return corners;
}

double least_angle(const std::array<Point, 3>& corners) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector u = corners[(i + 1) % 3] - corners[i], v = corners[(i + 2) % 3] - corners[i];
    least = std::min(least, std::atan2(cross(u, v), dot(u, v)) * radian);
  }
  return least;
}

/// Does the shortest side lie across a narrow wedge? Then its ends are seen from the tip of the wedge under less than
/// 0.175 radians, at distances in a ratio of at most 2.1.
bool is_across_wedge(const std::array<Point, 3>& corners, const Point& tip) {
  std::size_t shortest = 0;
  const auto side = [&](std::size_t i) { return distance(corners[i], corners[(i + 1) % 3]); };
  for (std::size_t i = 1; i < 3; ++i)
    if (side(i) < side(shortest)) shortest = i;
  const Vector a = corners[shortest] - tip, b = corners[(shortest + 1) % 3] - tip;
  const auto [near, far] = std::minmax({length(a), length(b)});
  return far <= 2.1 * near && std::atan2(std::fabs(cross(a, b)), dot(a, b)) < 0.175;
}

/// The least angle of the straight triangles that have no sharp corner within twice their extent, and that are not
/// across a narrow wedge with its tip at one.
double least_angle_away(const Mesh& mesh, const std::vector<Point>& sharp) {
  double least = 180;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const std::array corners{mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)),
                             mesh.point(mesh.corner(t, 2))};
    const double angle = least_angle(corners);
    if (angle >= least) continue;
    double extent = 0, away = HUGE_VAL;
    bool is_across = false;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, distance(corners[i], corners[(i + 1) % 3]));
    for (const Point& p : sharp) {
      for (const Point& corner : corners) away = std::min(away, distance(corner, p));
      is_across = is_across || is_across_wedge(corners, p);
    }
    if (away > 2 * extent && !is_across) least = angle;
  }
  return least;
}

}  // namespace

TEST_CASE(
    "every glyph is meshed, certified, with the area of its outline, or its contours meet; refined it has no angle "
    "below 20 degrees away from small angles of the outline",
    "[generate][fonts]") {
  const auto name = GENERATE(as<std::string>{}, "DejaVuSans", "DejaVuSans-Bold", "DejaVuSansMono",
                             "DejaVuSansMono-Bold", "DejaVuSerif", "DejaVuSerif-Bold");
  CAPTURE(name);
  const Font font(folder + name + ".ttf");
  std::set<std::vector<double>> seen;  // many glyphs are drawn alike
  int meshes = 0, refusals = 0;
  for (int glyph = 0; glyph < font.glyph_count(); glyph += stride) {
    const std::vector<Contour> contours = font.contours(glyph);
    std::vector<double> key;
    for (const Contour& contour : contours)
      for (const Conic& c : contour) key.insert(key.end(), {c.from.x, c.from.y, c.control.x, c.control.y});
    if (key.empty() || !seen.insert(key).second) continue;
    CAPTURE(glyph);
    if (const std::vector<Fault> faults = contacts(contours); !faults.empty()) {
      ++refusals;
      CAPTURE(faults.front().text);
      CHECK(is_contact(contours, place_in(faults.front().text)));
      continue;
    }
    ++meshes;
    double area = 0;
    Mesh mesh = meshed(boundary_by_nonzero(contours, area));
    CHECK(meshed_areas(mesh).front() == Approx(area).epsilon(1e-12));
    const int first = mesh.triangle_count();
    refine(mesh, {});
    CHECK(find_invalid(mesh).empty());
    CHECK(meshed_areas(mesh).front() == Approx(area).epsilon(1e-12));
    CHECK(least_angle_away(mesh, sharp_corners(contours)) >= 20);
    // The first mesh has all features of the outline, so no part of it needs to be refined without end.
    CHECK(mesh.triangle_count() <= 16 * first);
  }
  CHECK(meshes > 1000 / stride);
  CHECK(refusals <= meshes / 20);
}

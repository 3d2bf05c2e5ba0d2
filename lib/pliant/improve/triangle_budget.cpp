// lib/pliant/improve/triangle_budget.cpp: three lower bounds, as sums over faces, over places and over curves.
#include "pliant/improve/triangle_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/improve/refining/refine_attack.h"

namespace pliant {
namespace {

constexpr double places = 100'000;  // the size function is evaluated at about so many places
constexpr int most_rows = 100;      // a triangle has at most so many rows of places
constexpr double most_edges = 3;    // a triangle has at most so many edges on curves
constexpr double safety = 0.5;      // factor of the bound where the size varies: coarse places may miss large sizes

std::string in_digits(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// Counts the triangles that one triangle of the mesh must become by size: it is cut into small parts, and each of them
/// is filled with triangles as large as the largest size around it allows.
class SizeCount {
 public:
  SizeCount(const Mesh& mesh, const QualityGoals& goals)
      : mesh_(mesh),
        goals_(goals),
        rows_(std::clamp(static_cast<int>(std::sqrt(places / (1.0 + mesh.triangle_count()))), 1, most_rows)) {}

  double of(TriangleId t) {
    const Point &a = mesh_.point(mesh_.corner(t, 0)), &b = mesh_.point(mesh_.corner(t, 1)),
                &c = mesh_.point(mesh_.corner(t, 2));
    const double part = std::fabs(cross(b - a, c - a)) / 2 / (static_cast<double>(rows_) * rows_);
    const auto size_at = [&](double i, double j) {
      return goals_.length_at(a + (i / rows_) * (b - a) + (j / rows_) * (c - a), mesh_.time);
    };
    double sum = 0;
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; i + j < rows_; ++j) {
        sum += count(part, {size_at(i, j), size_at(i + 1, j), size_at(i, j + 1), size_at(i + 1 / 3.0, j + 1 / 3.0)});
        if (i + j + 1 < rows_)
          sum += count(
              part, {size_at(i + 1, j), size_at(i, j + 1), size_at(i + 1, j + 1), size_at(i + 2 / 3.0, j + 2 / 3.0)});
      }
    return sum;
  }
  bool varies() const { return varies_; }

 private:
  double count(double area, const std::array<double, 4>& sizes) {
    const auto [least, greatest] = std::minmax_element(sizes.begin(), sizes.end());
    if (first_ == 0) first_ = *least;
    varies_ = varies_ || *least != first_ || *greatest != first_;
    const double longest = size_slack * *greatest;
    return area / (std::numbers::sqrt3 / 4 * longest * longest);
  }

  const Mesh& mesh_;
  const QualityGoals& goals_;
  int rows_;
  double first_ = 0;
  bool varies_ = false;
};

LeastCount by_area(const Mesh& mesh, const QualityGoals& goals) {
  std::vector<double> areas(mesh.boundary().faces.size(), 0);
  std::array<Point, net_size(max_degree)> net;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    areas[index(mesh.face(t))] += element_area(mesh.degree(), {net.data(), index(mesh.net_size())});
  }
  LeastCount all;
  double most = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const double bound = goals.area_bound(static_cast<FaceId>(f)), count = areas[f] / bound;
    all.triangles += count;
    if (count <= most) continue;
    most = count;
    all.why = "an area of at most " + in_digits(bound) + " in face '" + mesh.boundary().faces[f].name + "'";
  }
  return all;
}

/// Over these triangles: any other that is alive counts as one.
LeastCount by_size(const Mesh& mesh, const QualityGoals& goals, const std::vector<TriangleId>& triangles) {
  SizeCount size(mesh, goals);
  LeastCount all;
  all.triangles = static_cast<double>(mesh.triangle_count()) - static_cast<double>(triangles.size());
  double most = 0;
  TriangleId densest = none;
  for (const TriangleId t : triangles) {
    const double count = size.of(t);
    all.triangles += count;
    if (count > most) most = count, densest = t;
  }
  if (densest == none) return all;
  if (size.varies()) all.triangles *= safety;
  const Point middle = (1.0 / 3) * (mesh.point(mesh.corner(densest, 0)) + mesh.point(mesh.corner(densest, 1)) +
                                    mesh.point(mesh.corner(densest, 2)));
  all.why = "edges of " + in_digits(goals.length_at(middle, mesh.time)) + " near " + describe_point(middle);
  return all;
}

/// The angle between an edge's tangents at its two ends, in radians: the edge turns at least by that.
double least_turning(const Mesh& mesh, HalfEdgeId h) {
  std::array<Point, max_degree + 1> polygon;
  mesh.gather_edge_points(h, polygon);
  const int p = mesh.degree();
  int first = 1, last = p - 1;
  while (first < p && polygon[index(first)] == polygon[0]) ++first;
  while (last > 0 && polygon[index(last)] == polygon[index(p)]) --last;
  const Vector from = polygon[index(first)] - polygon[0], to = polygon[index(p)] - polygon[index(last)];
  return std::fabs(std::atan2(cross(from, to), dot(from, to)));
}

LeastCount by_turning(const Mesh& mesh, const QualityGoals& goals) {
  std::vector<double> turning(mesh.boundary().curves.size(), 0);
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_alive(triangle_of(h)) && mesh.is_constrained(h) && mesh.twin(h) < h)
      turning[index(mesh.constraint_curve(mesh.constraint(h)))] += least_turning(mesh, h);
  LeastCount all;
  double most = 0;
  for (std::size_t c = 0; c < turning.size(); ++c) {
    const double count = turning[c] / goals.max_turning / most_edges;
    all.triangles += count;
    if (count <= most) continue;
    most = count;
    all.why = "edges that turn by at most " + in_digits(goals.max_turning * 180 / std::numbers::pi) +
              " degrees along " + describe_curve(mesh.boundary(), static_cast<CurveId>(c));
  }
  return all;
}

std::vector<TriangleId> all_triangles(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t)) all.push_back(t);
  return all;
}

/// Sizes are evaluated in these triangles, areas only where asked for.
LeastCount least_triangles(const Mesh& mesh, const QualityGoals& goals, bool with_areas,
                           const std::vector<TriangleId>& triangles) {
  LeastCount most;
  const auto consider = [&most](LeastCount count) {
    if (count.triangles > most.triangles) most = std::move(count);
  };
  if (with_areas && goals.bounds_area()) consider(by_area(mesh, goals));
  if (goals.size) consider(by_size(mesh, goals, triangles));
  if (goals.max_turning < HUGE_VAL && mesh.degree() > 1) consider(by_turning(mesh, goals));
  return most;
}

/// No less than what by_area counts, without a look at the elements that are not `bad`: each of them counts as one at
/// most.
double most_by_area(const Mesh& mesh, const QualityGoals& goals, const std::vector<TriangleId>& bad) {
  double most = mesh.triangle_count();
  std::array<Point, net_size(max_degree)> net;
  for (const TriangleId t : bad) {
    mesh.gather_points(t, net);
    const double area = element_area(mesh.degree(), {net.data(), index(mesh.net_size())});
    most += std::max(0.0, area / goals.area_bound(mesh.face(t)));
  }
  return most;
}

}  // namespace

LeastCount least_triangles(const Mesh& mesh, const QualityGoals& goals) {
  return least_triangles(mesh, goals, true, all_triangles(mesh));
}

void require_within_budget(const Mesh& mesh, const QualityGoals& goals, long max_triangles,
                           const std::vector<TriangleId>& bad) {
  if (bad.empty()) return;           // nothing is inserted
  constexpr double rounding = 1e-6;  // relative, of a sum over all elements
  const bool with_areas = !(most_by_area(mesh, goals, bad) < (1 - rounding) * static_cast<double>(max_triangles));
  const LeastCount least = least_triangles(mesh, goals, with_areas, bad);
  if (!(least.triangles > static_cast<double>(max_triangles))) return;
  throw TooManyTriangles("at least " + in_digits(least.triangles) + " triangles are asked for, by " + least.why +
                         "; at most " + std::to_string(max_triangles) +
                         " are allowed: ask for less, or allow more (--max-triangles)");
}

}  // namespace pliant

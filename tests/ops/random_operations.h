// tests/ops/random_operations.h: a disk that carries fields, and random operations on it.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/flip_edge.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/remove_point.h"
#include "pliant/ops/smooth_edge.h"
#include "support/sample_meshes.h"

namespace pliant {

/// A disk with two fields. Field 0 is x + 2 y - 3; field 1 has two components of noise, and is by face if `by_face`.
inline Mesh carried_disk(int degree, bool by_face = false, int spans = 8) {
  MeshData data = samples::disk(degree, spans);
  samples::add_field(data, "linear", 1, [](const Point& p) { return std::vector<double>{p.x + 2 * p.y - 3}; });
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> noise(-1, 1);
  samples::add_field(data, "noise", 2, [&](const Point&) { return std::vector<double>{noise(random), noise(random)}; });
  if (by_face) {
    Field& field = data.fields.back();
    field.by_face = true;
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(data.points.size()); ++p) field.places.push_back({p, 0});
  }
  return Mesh(std::move(data));
}

inline double area_of(const Mesh& mesh) {
  double area = 0;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    area += element_area(mesh.degree(), net);
  }
  return area;
}

inline double integral_of(const Mesh& mesh, int field, int component) {
  double sum = 0;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  std::vector<double> weights(net.size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    integral_weights(mesh.degree(), net, weights);
    for (std::size_t k = 0; k < net.size(); ++k) {
      const auto first = mesh.value_index(field, mesh.net(t)[k], mesh.face(t));
      sum += weights[k] *
             mesh.fields()[static_cast<std::size_t>(field)].values[static_cast<std::size_t>(first + component)];
    }
  }
  return sum;
}

/// The largest deviation of field 0 from the linear function that it should be.
inline double linear_error(const Mesh& mesh) {
  double worst = 0;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    if (!mesh.is_point_alive(p)) continue;
    const Point& x = mesh.point(p);
    worst = std::max(worst, std::abs(mesh.fields()[0].values[static_cast<std::size_t>(p)] - (x.x + 2 * x.y - 3)));
  }
  return worst;
}

inline std::vector<double> row_at(const Mesh& mesh, TriangleId t, const Barycentric& xi) {
  std::vector<double> rows(static_cast<std::size_t>(mesh.net_size() * mesh.width()));
  std::vector<double> row(static_cast<std::size_t>(mesh.width()));
  mesh.gather(t, rows);
  evaluate_net(mesh.degree(), mesh.width(), rows, xi, row);
  return row;
}
inline Point point_at(const Mesh& mesh, TriangleId t, const Barycentric& xi) {
  const auto row = row_at(mesh, t, xi);
  return {row[0], row[1]};
}

/// The largest difference between the rows (positions, then fields) of two meshes of the same region, at random points
/// of the first.
inline double difference_of_functions(const Mesh& a, const Mesh& b, int samples) {
  std::mt19937_64 random(99);
  std::uniform_real_distribution<double> uniform(0.01, 1);
  Locator locator(b);
  double worst = 0;
  for (int k = 0; k < samples; ++k) {
    const auto t = static_cast<TriangleId>(random() % static_cast<unsigned>(a.triangle_slots()));
    Barycentric xi{uniform(random), uniform(random), uniform(random)};
    const double sum = xi[0] + xi[1] + xi[2];
    for (double& x : xi) x /= sum;
    const auto row = row_at(a, t, xi);
    const auto found = locator.find({row[0], row[1]});
    if (!found) return HUGE_VAL;
    const auto other = row_at(b, found->triangle, found->xi);
    for (std::size_t c = 0; c < row.size(); ++c) worst = std::max(worst, std::abs(row[c] - other[c]));
  }
  return worst;
}

inline bool same_document(const MeshData& a, const MeshData& b) {
  if (a.points != b.points || a.triangles != b.triangles || a.triangle_faces != b.triangle_faces) return false;
  if (a.fields.size() != b.fields.size() || a.constrained_edges.size() != b.constrained_edges.size()) return false;
  for (std::size_t k = 0; k < a.fields.size(); ++k)
    if (a.fields[k].values != b.fields[k].values || a.fields[k].places != b.fields[k].places) return false;
  for (std::size_t k = 0; k < a.constrained_edges.size(); ++k)
    if (a.constrained_edges[k].points != b.constrained_edges[k].points ||
        a.constrained_edges[k].span != b.constrained_edges[k].span)
      return false;
  for (std::size_t c = 0; c < a.boundary.curves.size(); ++c)
    if (a.boundary.curves[c].spline.points() != b.boundary.curves[c].spline.points() ||
        a.boundary.curves[c].spline.knots() != b.boundary.curves[c].spline.knots())
      return false;
  return true;
}

/// Random insertions, splits, flips, removals and smoothings, all of which keep the shapes of the curves.
class RandomOperations {
 public:
  RandomOperations(Mesh& mesh, std::uint64_t seed, int most_triangles = 80)
      : mesh_(mesh), random_(seed), most_triangles_(most_triangles) {}
  void run(int count) {
    for (int k = 0; k < count; ++k) done += step();
  }
  int done = 0;

 private:
  bool step() {
    TriangleId t;
    do t = static_cast<TriangleId>(random_() % static_cast<unsigned>(mesh_.triangle_slots()));
    while (!mesh_.is_alive(t));
    const HalfEdgeId h = half_edge(t, static_cast<int>(random_() % 3));
    std::uniform_real_distribution<double> uniform(0.2, 0.8);
    const bool grow = mesh_.triangle_count() < most_triangles_;
    switch (random_() % 8) {
      case 0:
        return grow && insert_point(mesh_, t, {0.3, 0.45, 0.25}).outcome == Outcome::done;
      case 1:
        return grow && split_edge(mesh_, h, uniform(random_)).outcome == Outcome::done;
      case 2:
      case 3:
        return flip_edge(mesh_, h) == Outcome::done;
      case 4:
      case 5:
        // A vertex on a curve is removed only if the curve stays as it is, which is so after a split.
        if (mesh_.is_constrained(h))
          return remove_curve_vertex(mesh_, mesh_.origin(h), {1e-14 * mesh_.size()}).outcome == Outcome::done;
        return remove_inner_vertex(mesh_, mesh_.origin(h)) == Outcome::done;
      case 6:
        return smooth_edge(mesh_, h, SmoothGoal::improve) == Outcome::done;
      default:
        if (mesh_.degree() > 2) return smooth_interior(mesh_, t, SmoothGoal::improve) == Outcome::done;
        return flip_edge(mesh_, h) == Outcome::done;
    }
  }
  Mesh& mesh_;
  std::mt19937_64 random_;
  int most_triangles_;
};

}  // namespace pliant

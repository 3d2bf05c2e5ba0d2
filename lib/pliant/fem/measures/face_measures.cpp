// lib/pliant/fem/measures/face_measures.cpp: sums over the elements of a face.
#include "pliant/fem/measures/face_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pliant/fem/element_map.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/bernstein_range.h"

namespace pliant {
namespace {

/// A sum that keeps what rounding would drop (Neumaier), so that many elements lose no more digits than one.
class Sum {
 public:
  void add(double value) {
    const double sum = sum_ + value;
    lost_ += std::abs(sum_) >= std::abs(value) ? (sum_ - sum) + value : (value - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

template <class Use>
void for_each_element(const Mesh& mesh, FaceId face, const Use& use) {
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t) && (face == every_face || mesh.face(t) == face)) use(t);
}

}  // namespace

AreaAndCentre measure_area(const Mesh& mesh, FaceId face) {
  const int p = mesh.degree();
  const ElementTable& table = element_table(p, 3 * p - 2);  // x det J
  ElementMap map(p);
  std::optional<Point> near;  // moments about a point of the face lose no digits where the face is far from the origin
  Sum area, moment_x, moment_y;
  for_each_element(mesh, face, [&](TriangleId t) {
    map.set(mesh, mesh.points(), t, table);
    if (!near) near = map.net()[0];
    for (int q = 0; q < map.points(); ++q) {
      const Vector arm = map.place(q) - *near;
      area.add(map.measure(q));
      moment_x.add(map.measure(q) * arm.x);
      moment_y.add(map.measure(q) * arm.y);
    }
  });
  const double unit = mesh.boundary().unit;
  if (!near) return {0, {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()}};
  const Vector moment{moment_x.value(), moment_y.value()};
  return {unit * unit * area.value(), unit * (*near + moment / area.value())};
}

double integrate(MeshFunction& function, const Mesh& mesh, FaceId face) {
  const int p = mesh.degree();
  const ElementTable& table = element_table(p, function.is_field() ? 3 * p - 2 : std::min(4 * p + 4, 40));
  ElementMap map(p);
  Sum sum;
  for_each_element(mesh, face, [&](TriangleId t) {
    map.set(mesh, mesh.points(), t, table);
    function.set(t);
    for (int q = 0; q < map.points(); ++q)
      sum.add(map.measure(q) * function.at(table.xi[index(q)], table.values_at(q)));
  });
  return mesh.boundary().unit * mesh.boundary().unit * sum.value();
}

std::optional<Range> bounds(MeshFunction& field, const Mesh& mesh, FaceId face) {
  assert(field.is_field());
  constexpr double width = 1e-9;
  std::optional<Range> hull, range;
  for_each_element(mesh, face, [&](TriangleId t) {
    field.set(t);
    const auto [low, high] = std::ranges::minmax(field.control_values());
    hull = hull ? Range{std::min(hull->least, low), std::max(hull->greatest, high)} : Range{low, high};
  });
  if (!hull) return {};
  const double allowed = width * (hull->greatest - hull->least);
  for_each_element(mesh, face, [&](TriangleId t) {
    field.set(t);
    const auto values = field.control_values();
    if (!range) range = Range{values[0], values[0]};
    const auto [low, high] = std::ranges::minmax(values);  // Bernstein coefficients enclose the values
    if (low < range->least)
      range->least = std::min(range->least, enclose_minimum(mesh.degree(), values, 0, allowed).lower);
    if (high > range->greatest)
      range->greatest = std::max(range->greatest, enclose_maximum(mesh.degree(), values, 0, allowed).upper);
  });
  return range;
}

}  // namespace pliant

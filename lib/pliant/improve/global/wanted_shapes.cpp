// lib/pliant/improve/global/wanted_shapes.cpp: logical triangles, made thicker where they are flat; equilateral ones.
#include "pliant/improve/global/wanted_shapes.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

constexpr double least_area = 0.1;  // least area of a wanted triangle, in mean areas of the element and its neighbours
constexpr double thinnest =
    0.05;  // least ratio of the two stretches that turn an equilateral triangle into a wanted one
const double half_root = std::sqrt(3.0) / 2;

double area_of(const FreePoints& points, TriangleId t) {
  FreePoints::Net net;
  return element_area(points.mesh().degree(), points.gather(t, net));
}

/// The mean area of an element, those beside it, and those beside these. Areas of folds cancel in it.
double wanted_area(const FreePoints& points, TriangleId t) {
  const Mesh& mesh = points.mesh();
  double sum = area_of(points, t), positive = std::max(sum, 0.0), count = 1;
  const auto add = [&](TriangleId u) {
    const double area = area_of(points, u);
    sum += area, positive += std::max(area, 0.0), ++count;
  };
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId g = mesh.twin(half_edge(t, e));
    if (g == none) continue;
    add(triangle_of(g));
    for (const HalfEdgeId h : {next(g), previous(g)})
      if (mesh.twin(h) != none) add(triangle_of(mesh.twin(h)));
  }
  return std::max(sum, least_area * positive) / count;
}

/// The shape of the logical triangle of an element, or of a thicker one where that is inverted or too flat.
WantedShape straight(const FreePoints& points, TriangleId t) {
  using Complex = std::complex<double>;
  const Mesh& mesh = points.mesh();
  const Point a = points.place(mesh.corner(t, 0));
  const Vector u = points.place(mesh.corner(t, 1)) - a, v = points.place(mesh.corner(t, 2)) - a;
  // The map from the equilateral triangle is z -> keep z + mirror conj(z); it stretches by |keep| +- |mirror|.
  const Complex first(u.x, u.y), second(v.x, v.y), side(0.5, half_root);
  const Complex mirror = (second - first * side) / (std::conj(side) - side), keep = first - mirror;
  const double longest = std::abs(keep) + std::abs(mirror);
  if (std::abs(keep) - std::abs(mirror) > thinnest * longest) return WantedShape::of(u, v);
  const auto scaled = [](const Complex& z, double size) { return std::abs(z) > 0 ? z / std::abs(z) * size : size; };
  const Complex thick = scaled(keep, (1 + thinnest) / 2), flat = scaled(mirror, (1 - thinnest) / 2);
  const Complex p = thick + flat, q = thick * side + flat * std::conj(side);
  const Vector along{p.real(), p.imag()}, across{q.real(), q.imag()};
  const double area = wanted_area(points, t), size = area > 0 ? std::sqrt(2 * area / cross(along, across)) : longest;
  return WantedShape::of(size * along, size * across);
}

}  // namespace

std::vector<WantedShape> wanted_shapes(const FreePoints& points, std::span<const TriangleId> elements,
                                       bool equilateral) {
  std::vector<WantedShape> shapes;
  shapes.reserve(elements.size());
  for (const TriangleId t : elements) {
    const double area = equilateral ? wanted_area(points, t) : 0;
    if (!(area > 0)) {
      shapes.push_back(straight(points, t));
      continue;
    }
    const double side = std::sqrt(2 * area / half_root);
    shapes.push_back(WantedShape::of({side, 0}, {side / 2, side * half_root}));
  }
  return shapes;
}

}  // namespace pliant

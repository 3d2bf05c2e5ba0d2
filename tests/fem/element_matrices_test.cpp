// tests/fem/element_matrices_test.cpp: matrices of one element against exact sums and laws, at any degree.
#include "pliant/fem/element_matrices.h"

#include <catch2/catch.hpp>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/quadrature.h"
#include "pliant/geometry/validity/jacobian.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

struct Matrices {
  std::vector<double> mass, stiffness, convection, along_x, along_y;
};

/// Everything for one element, with constant coefficients.
Matrices matrices_of(const Mesh& mesh, TriangleId t, int pressure, const SymmetricTensor& k, const Vector& v) {
  ElementMap map(mesh.degree());
  map.set(mesh, mesh.points(), t, Integrand::constant);
  const std::size_t n = index(mesh.net_size()), m = index(map.points());
  Matrices made;
  made.mass.resize(n * n);
  made.stiffness.resize(n * n);
  made.convection.resize(n * n);
  made.along_x.resize(index(net_size(pressure)) * n);
  made.along_y.resize(made.along_x.size());
  std::vector<double> pairs(n * (n + 1) / 2);
  element_mass(map, std::vector<double>(m, 1.0), pairs);
  unpack_pairs(mesh.net_size(), pairs, made.mass);
  element_stiffness(map, std::vector<SymmetricTensor>(m, k), pairs);
  unpack_pairs(mesh.net_size(), pairs, made.stiffness);
  element_convection(map, std::vector<Vector>(m, v), made.convection);
  element_divergence(map, pressure, made.along_x, made.along_y);
  return made;
}

}  // namespace

TEST_CASE("the mass matrix is exact: products of Bernstein polynomials", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4, 5, 8);
  CAPTURE(p);
  const Mesh mesh(mapped_square(p, 2, bend));
  const int d = jacobian_degree(p);
  const std::size_t n = index(mesh.net_size());
  std::vector<Point> net(n);
  std::vector<double> det(index(net_size(d))), square(index(net_size(2 * p))), all(index(net_size(2 * p + d)));
  for (const TriangleId t : {0, 3, 7}) {
    const Matrices made = matrices_of(mesh, t, 1, {}, {});
    mesh.gather_points(t, net);
    jacobian_net(p, net, det);
    double total = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        std::vector<double> a(n, 0.0), b(n, 0.0);
        a[i] = b[j] = 1;
        multiply_triangle(p, a, p, b, square);
        multiply_triangle(2 * p, square, d, det, all);
        const double exact = integrate_triangle(2 * p + d, all);
        CHECK(made.mass[i * n + j] == Approx(exact).epsilon(1e-12).margin(1e-17));
        total += made.mass[i * n + j];
      }
    CHECK(total == Approx(element_area(p, net)).epsilon(1e-13));
  }
}

TEST_CASE("constants have no gradient, and linear functions that of their coefficients", "[fem][oracle]") {
  const int p = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(p);
  const Mesh mesh(mapped_square(p, 2, bend));
  const std::size_t n = index(mesh.net_size());
  const SymmetricTensor k{2, 0.3, 1};
  const Vector v{0.7, -1.2};
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Matrices made = matrices_of(mesh, t, p, k, v);
    std::vector<Point> net(n);
    mesh.gather_points(t, net);
    const double area = element_area(p, net);
    double energy = 0, carried = 0, load = 0;
    const auto f = [](const Point& at) { return 3 * at.x - 2 * at.y; };  // its control values are its values there
    for (std::size_t i = 0; i < n; ++i) {
      double row = 0, along = 0, divergence = 0, of_x = 0;
      for (std::size_t j = 0; j < n; ++j) {
        row += made.stiffness[i * n + j];
        along += made.convection[i * n + j];
        divergence += made.along_x[i * n + j];
        of_x += made.along_x[i * n + j] * net[j].x + made.along_y[i * n + j] * net[j].y;
        energy += f(net[i]) * made.stiffness[i * n + j] * f(net[j]);
        carried += made.convection[i * n + j] * f(net[j]);
      }
      CHECK(std::abs(row) < 1e-12);
      CHECK(std::abs(along) < 1e-13);
      CHECK(std::abs(divergence) < 1e-13);
      load += of_x;
    }
    CHECK(energy == Approx(area * (9 * k.xx - 12 * k.xy + 4 * k.yy)).epsilon(1e-10));
    CHECK(carried == Approx(area * (3 * v.x - 2 * v.y)).epsilon(1e-11));
    CHECK(load == Approx(2 * area).epsilon(1e-11));  // the divergence of (x, y) is 2
  }
}

TEST_CASE("the stiffness of curved elements is as good as rules of high degree", "[fem][oracle]") {
  const int p = GENERATE(2, 3, 4);
  CAPTURE(p);
  const Mesh mesh(mapped_square(p, 3, bend));
  const std::size_t n = index(mesh.net_size());
  std::vector<double> pairs(n * (n + 1) / 2), fine(pairs.size());
  const auto points = mesh.points();
  ElementMap map(p);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    map.set(mesh, points, t, Integrand::constant);
    element_stiffness(map, std::vector<SymmetricTensor>(index(map.points())), pairs);
    map.set(mesh, points, t, element_table(p, 40));
    element_stiffness(map, std::vector<SymmetricTensor>(index(map.points())), fine);
    for (std::size_t k = 0; k < pairs.size(); ++k) CHECK(pairs[k] == Approx(fine[k]).margin(2e-5));
  }
}

TEST_CASE("affine elements use few points, and give what many give", "[fem]") {
  const int p = GENERATE(1, 2, 3, 4);
  const Mesh mesh(mapped_square(p, 2, [](double x, double y) { return Point{2 * x + y + 1e3, 3 * y - x}; }));
  const auto points = mesh.points();
  const std::size_t n = index(mesh.net_size());
  std::vector<double> pairs(n * (n + 1) / 2), fine(pairs.size());
  ElementMap map(p);
  map.set(mesh, points, 5, Integrand::constant);
  CHECK(map.is_affine());
  CHECK(map.points() <= element_table(p, 2 * p).points);
  element_stiffness(map, std::vector<SymmetricTensor>(index(map.points())), pairs);
  map.set(mesh, points, 5, element_table(p, 20));
  element_stiffness(map, std::vector<SymmetricTensor>(index(map.points())), fine);
  for (std::size_t k = 0; k < pairs.size(); ++k) CHECK(pairs[k] == Approx(fine[k]).margin(1e-10));
}

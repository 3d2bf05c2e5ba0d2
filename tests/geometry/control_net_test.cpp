// tests/geometry/control_net_test.cpp: values, derivatives and sub-nets of a control net against Bernstein's form.
#include "pliant/geometry/control_net.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::vector<double> random_rows(int rows, int width, int seed) {
  Random random(seed);
  std::vector<double> values(index(rows * width));
  for (double& x : values) x = random.real(-1, 1);
  return values;
}

/// The value of a net by the definition, sum B_m c_m.
std::vector<double> by_basis(int degree, int width, const std::vector<double>& net, const Barycentric& xi) {
  std::vector<double> basis(index(net_size(degree)));
  bernstein_basis(degree, xi, basis);
  std::vector<double> value(index(width), 0.0);
  for (std::size_t n = 0; n < basis.size(); ++n)
    for (std::size_t x = 0; x < index(width); ++x) value[x] += basis[n] * net[n * index(width) + x];
  return value;
}

std::vector<double> value_at(int degree, int width, std::span<const double> net, const Barycentric& xi) {
  std::vector<double> value(index(width));
  evaluate_net(degree, width, net, xi, value);
  return value;
}

Barycentric combined(const Barycentric& xi, const Barycentric& a, const Barycentric& b, const Barycentric& c) {
  Barycentric result;
  for (std::size_t m = 0; m < 3; ++m) result[m] = xi[0] * a[m] + xi[1] * b[m] + xi[2] * c[m];
  return result;
}

void check_close(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  REQUIRE(a.size() == b.size());
  for (std::size_t n = 0; n < a.size(); ++n) CHECK(std::fabs(a[n] - b[n]) <= tolerance);
}

constexpr Barycentric corners[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("de Casteljau gives the sum of Bernstein polynomials", "[geometry][property]") {
  const int degree = GENERATE(range(0, max_degree + 1));
  const int width = GENERATE(1, 2, 5, 20);
  CAPTURE(degree, width);
  const auto net = random_rows(net_size(degree), width, degree);
  for (const Barycentric& xi : lattice(4))
    check_close(value_at(degree, width, net, xi), by_basis(degree, width, net, xi), 1e-13);
}

TEST_CASE("a net's corners are its values there, bit for bit", "[geometry]") {
  for (int degree = 1; degree <= max_degree; ++degree) {
    const auto net = random_rows(net_size(degree), 3, degree);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = value_at(degree, 3, net, corners[c]);
      for (std::size_t x = 0; x < 3; ++x) CHECK(value[x] == net[3 * c + x]);
    }
  }
}

TEST_CASE("partial derivatives are those of the differentiated Bernstein form", "[geometry][property]") {
  const int degree = GENERATE(range(0, max_degree + 1));
  CAPTURE(degree);
  const auto net = random_rows(net_size(degree), 1, degree);
  std::vector<double> d2(index(degree > 0 ? net_size(degree - 1) : 1), 0.0);
  std::vector<double> d3(d2.size(), 0.0);
  if (degree > 0) differentiate_triangle(degree, net, d2, d3);
  const int lower = degree > 0 ? degree - 1 : 0;
  for (const Barycentric& xi : lattice(5)) {
    double value = 0, along_2 = 0, along_3 = 0;
    evaluate_net(degree, 1, net, xi, {&value, 1}, {&along_2, 1}, {&along_3, 1});
    CHECK(value == value_at(degree, 1, net, xi)[0]);
    CHECK(along_2 == Approx(by_basis(lower, 1, d2, xi)[0]).margin(1e-12));
    CHECK(along_3 == Approx(by_basis(lower, 1, d3, xi)[0]).margin(1e-12));
  }
}

TEST_CASE("a sub-net is the same polynomial on a smaller triangle", "[geometry][property]") {
  const int degree = GENERATE(range(0, max_degree + 1));
  const int seed = GENERATE(range(0, 10));
  CAPTURE(degree, seed);
  Random random(seed);
  const Barycentric a = random.barycentric();
  const Barycentric b = random.barycentric();
  const Barycentric c = random.barycentric();
  const auto net = random_rows(net_size(degree), 4, seed);
  std::vector<double> piece(net.size());
  sub_net(degree, 4, net, a, b, c, piece);
  for (const Barycentric& xi : lattice(4))
    check_close(value_at(degree, 4, piece, xi), value_at(degree, 4, net, combined(xi, a, b, c)), 1e-12);
}

TEST_CASE("a sub-net on the net's own corners is the net, permuted, bit for bit", "[geometry]") {
  const int degree = GENERATE(range(0, max_degree + 1));
  const NetLayout& layout = NetLayout::of(degree);
  const auto net = random_rows(net_size(degree), 2, degree);
  const int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  for (const auto& q : permutations) {
    std::vector<double> piece(net.size());
    sub_net(degree, 2, net, corners[q[0]], corners[q[1]], corners[q[2]], piece);
    for (int n = 0; n < layout.size(); ++n) {
      std::array<int, 3> from{};
      for (std::size_t m = 0; m < 3; ++m) from[index(q[m])] = layout.exponents(n)[m];
      for (int x = 0; x < 2; ++x) CHECK(piece[index(2 * n + x)] == net[index(2 * layout.index(from[0], from[1]) + x)]);
    }
  }
}

TEST_CASE("inserting a point keeps the three outer edges bit for bit", "[geometry]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const NetLayout& layout = NetLayout::of(degree);
  const auto net = random_rows(net_size(degree), 3, degree);
  for (int e = 0; e < 3; ++e) {
    std::vector<double> piece(net.size());
    sub_net(degree, 3, net, corners[e], corners[(e + 1) % 3], {0.3, 0.2, 0.5}, piece);
    for (int k = 0; k <= degree; ++k)
      for (int x = 0; x < 3; ++x)
        CHECK(piece[index(3 * layout.edge_index(0, k) + x)] == net[index(3 * layout.edge_index(e, k) + x)]);
  }
}

TEST_CASE("splitting at a point of an edge splits the edge's polygon, to the same bits", "[geometry]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const double s = GENERATE(0.5, 0.3, 0.9375);
  const NetLayout& layout = NetLayout::of(degree);
  const auto net = random_rows(net_size(degree), 2, degree);
  std::vector<double> edge;
  for (int k = 0; k <= degree; ++k)
    for (int x = 0; x < 2; ++x) edge.push_back(net[index(2 * layout.edge_index(0, k) + x)]);
  std::vector<double> left(edge.size()), right(edge.size()), first(net.size()), second(net.size());
  split_polygon(degree, 2, edge, s, left, right);
  const Barycentric middle{1 - s, s, 0};
  sub_net(degree, 2, net, corners[0], middle, corners[2], first);
  sub_net(degree, 2, net, middle, corners[1], corners[2], second);
  for (int k = 0; k <= degree; ++k) {
    for (int x = 0; x < 2; ++x) {
      CHECK(first[index(2 * layout.edge_index(0, k) + x)] == left[index(2 * k + x)]);
      CHECK(second[index(2 * layout.edge_index(0, k) + x)] == right[index(2 * k + x)]);
    }
  }
}

TEST_CASE("the pieces of a split polygon trace the curve and meet", "[geometry][property]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const double s = GENERATE(0.25, 0.61);
  const auto polygon = random_rows(degree + 1, 3, degree);
  std::vector<double> left(polygon.size()), right(polygon.size()), expected(3), value(3);
  split_polygon(degree, 3, polygon, s, left, right);
  for (std::size_t x = 0; x < 3; ++x) {
    CHECK(left[x] == polygon[x]);
    CHECK(right[index(degree * 3) + x] == polygon[index(degree * 3) + x]);
    CHECK(left[index(degree * 3) + x] == right[x]);
  }
  for (double t = 0; t <= 1; t += 0.125) {
    evaluate_polygon(degree, 3, polygon, s * t, expected);
    evaluate_polygon(degree, 3, left, t, value);
    check_close(value, expected, 1e-13);
    evaluate_polygon(degree, 3, polygon, s + (1 - s) * t, expected);
    evaluate_polygon(degree, 3, right, t, value);
    check_close(value, expected, 1e-13);
  }
}

TEST_CASE("degree elevation changes no value and no corner", "[geometry][property]") {
  const int degree = GENERATE(range(0, max_degree));
  CAPTURE(degree);
  const auto net = random_rows(net_size(degree), 2, degree);
  std::vector<double> higher(index(2 * net_size(degree + 1)));
  elevate_net(degree, 2, net, higher);
  for (const Barycentric& xi : lattice(6))
    check_close(value_at(degree + 1, 2, higher, xi), value_at(degree, 2, net, xi), 1e-13);
  if (degree > 0)
    for (std::size_t x = 0; x < 6; ++x) CHECK(higher[x] == net[x]);

  const auto polygon = random_rows(degree + 1, 2, degree);
  std::vector<double> longer(index(2 * (degree + 2))), expected(2), value(2);
  elevate_polygon(degree, 2, polygon, longer);
  for (double s = 0; s <= 1; s += 0.125) {
    evaluate_polygon(degree, 2, polygon, s, expected);
    evaluate_polygon(degree + 1, 2, longer, s, value);
    check_close(value, expected, 1e-13);
  }
}

TEST_CASE("interpolation gives back the polynomial whose values it was given", "[geometry][property]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  CAPTURE(degree);
  const auto polygon = random_rows(degree + 1, 3, degree);
  std::vector<double> values(polygon.size());
  for (int k = 0; k <= degree; ++k)
    evaluate_polygon(degree, 3, polygon, static_cast<double>(k) / degree, std::span(values).subspan(index(3 * k), 3));
  interpolate_polygon(degree, 3, values);
  check_close(values, polygon, 1e-14 * std::pow(4.0, degree));
  for (std::size_t x = 0; x < 3; ++x) {
    CHECK(values[x] == polygon[x]);
    CHECK(values[index(3 * degree) + x] == polygon[index(3 * degree) + x]);
  }

  const NetLayout& layout = NetLayout::of(degree);
  const auto net = random_rows(layout.size(), 2, degree);
  auto mixed = net;
  for (int n = layout.first_interior(); n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    const double p = degree;
    const Barycentric node{i / p, j / p, k / p};
    evaluate_net(degree, 2, net, node, std::span(mixed).subspan(index(2 * n), 2));
  }
  interpolate_interior(degree, 2, mixed);
  check_close(mixed, net, 1e-13 * std::pow(4.0, degree));
  for (int n = 0; n < 2 * layout.first_interior(); ++n) CHECK(mixed[index(n)] == net[index(n)]);
}

TEST_CASE("interpolating a straight element far from the origin keeps it straight to rounding", "[geometry]") {
  const int degree = GENERATE(range(2, max_degree + 1));
  const auto straight = straight_net(degree, {1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 1});
  std::vector<double> rows;
  for (const Point& p : straight) rows.insert(rows.end(), {p.x, p.y});
  auto result = rows;
  interpolate_interior(degree, 2, result);
  check_close(result, rows, 1e-8);
}

// lib/pliant/ops/refit/integral_weights.cpp: the weights of control values in the exact integral over an element.
#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {
namespace {

/// ∫ B^p_k B^d_m over the unit right triangle, k by m, for d = 2 (p - 1).
std::vector<double> make_table(int p) {
  const int d = jacobian_degree(p);
  const NetLayout &fields = NetLayout::of(p), &jacobians = NetLayout::of(d), &products = NetLayout::of(p + d);
  std::vector<double> table;
  for (int k = 0; k < fields.size(); ++k)
    for (int m = 0; m < jacobians.size(); ++m) {
      const auto& a = fields.exponents(k);
      const auto& b = jacobians.exponents(m);
      const double c = fields.multinomial(k) * jacobians.multinomial(m) /
                       products.multinomial(products.index(a[0] + b[0], a[1] + b[1]));
      table.push_back(c / ((p + d + 1) * (p + d + 2)));
    }
  return table;
}

const std::vector<double>& table_of(int p) {
  static std::array<std::once_flag, max_degree + 1> once;
  static std::array<std::vector<double>, max_degree + 1> tables;
  const auto k = static_cast<std::size_t>(p);
  std::call_once(once[k], [&] { tables[k] = make_table(p); });
  return tables[k];
}

using Jacobian = std::array<double, net_size(2 * (max_degree - 1))>;

std::size_t jacobian_of(int degree, std::span<const Point> net, Jacobian& jacobian) {
  const auto d = static_cast<std::size_t>(net_size(jacobian_degree(degree)));
  jacobian_net(degree, net, {jacobian.data(), d});
  return d;
}

/// The integral weight of control point k.
double integral_weight(int degree, std::span<const Point> net, std::size_t k) {
  Jacobian jacobian;
  const std::size_t d = jacobian_of(degree, net, jacobian);
  const double* const row = table_of(degree).data() + k * d;
  double sum = 0;
  for (std::size_t m = 0; m < d; ++m) sum += row[m] * jacobian[m];
  return sum;
}

}  // namespace

void integral_weights(int degree, std::span<const Point> net, std::span<double> weights) {
  Jacobian jacobian;
  const std::size_t d = jacobian_of(degree, net, jacobian);
  const double* entry = table_of(degree).data();
  for (std::size_t k = 0; k < static_cast<std::size_t>(net_size(degree)); ++k) {
    double sum = 0;
    for (std::size_t m = 0; m < d; ++m) sum += *entry++ * jacobian[m];
    weights[k] = sum;
  }
}

double weight_in_mesh(const Mesh& mesh, PointId p, TriangleId inside, int local, bool by_face) {
  std::array<Point, net_size(max_degree)> net;
  const std::span<const Point> points{net.data(), static_cast<std::size_t>(mesh.net_size())};
  double sum = 0;
  const auto add = [&](TriangleId t) {
    if (by_face && mesh.face(t) != mesh.face(inside)) return;
    mesh.gather_points(t, net);
    const auto ids = mesh.net(t);
    sum += integral_weight(mesh.degree(), points,
                           static_cast<std::size_t>(std::find(ids.begin(), ids.end(), p) - ids.begin()));
  };
  if (local < 3) {
    thread_local Star star;
    find_star(mesh, p, star);
    for (const HalfEdgeId h : star.outgoing) add(triangle_of(h));
  } else if (local >= mesh.layout().first_interior()) {
    add(inside);
  } else {
    add(inside);
    const HalfEdgeId twin = mesh.twin(half_edge(inside, (local - 3) / (mesh.degree() - 1)));
    if (twin != none) add(triangle_of(twin));
  }
  return sum;
}

}  // namespace pliant

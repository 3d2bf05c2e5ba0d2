// formats/msh/msh_basis.cpp: the values that a file gives to an element, as values at the nodes of the mesh's degree.
#include "formats/msh/msh_basis.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// Rounding of coefficients that Gmsh writes makes less of a difference, up to order 10, and no other basis is so
/// close.
constexpr double same_basis = 1e-6;

double power(double x, int exponent) { return exponent == 0 ? 1 : x * power(x, exponent - 1); }

}  // namespace

MshBasis::Map MshBasis::lagrange(int order) const {
  Map map;
  if (order > degree_) {
    map.refusal = "it has degree " + std::to_string(order) + ", the mesh degree " + std::to_string(degree_);
    return map;
  }
  const NetLayout& layout = NetLayout::of(degree_);
  const std::vector<int> places = msh_net_order(order);
  const std::size_t count = places.size(), rows = index(layout.size());
  if (order == degree_) {
    map.source.resize(count);
    for (std::size_t n = 0; n < count; ++n) map.source[index(places[n])] = static_cast<int>(n);
    return map;
  }
  map.matrix.assign(rows * count, 0);
  std::vector<double> net(count), polygon(index(order) + 1);
  const NetLayout& low = NetLayout::of(order);
  for (std::size_t n = 0; n < count; ++n) {
    std::fill(net.begin(), net.end(), 0.0);
    net[index(places[n])] = 1;
    for (int e = 0; e < 3 && order > 1; ++e) {
      for (int k = 0; k <= order; ++k) polygon[index(k)] = net[index(low.edge_index(e, k))];
      interpolate_polygon(order, 1, polygon);
      for (int k = 0; k <= order; ++k) net[index(low.edge_index(e, k))] = polygon[index(k)];
    }
    if (order > 2) interpolate_interior(order, 1, net);
    for (int k = 0; k < layout.size(); ++k) {
      const auto& [i, j, l] = layout.exponents(k);
      const Barycentric xi{double(i) / degree_, double(j) / degree_, double(l) / degree_};
      double& factor = map.matrix[index(k) * count + n];
      if (order == 0)
        factor = 1;
      else
        evaluate_net(order, 1, net, xi, {&factor, 1});
    }
  }
  return map;
}

MshBasis::Map MshBasis::by_scheme() const {
  Map map;
  const std::size_t monomials = scheme_->exponents.size() / 2, count = scheme_->count;
  if (monomials == 0) {
    map.refusal = "its interpolation scheme says nothing of triangles";
    return map;
  }
  std::vector<std::array<int, 2>> exponents;
  for (std::size_t m = 0; m < monomials; ++m) {
    const double a = scheme_->exponents[2 * m], b = scheme_->exponents[2 * m + 1];
    // Comparisons before conversions: the numbers may be anything.
    if (!(a >= 0 && b >= 0 && a + b <= degree_ && a == std::floor(a) && b == std::floor(b))) {
      map.refusal = "its interpolation scheme has other functions than polynomials of the mesh's degree " +
                    std::to_string(degree_);
      return map;
    }
    exponents.push_back({static_cast<int>(a), static_cast<int>(b)});
  }
  const NetLayout& layout = NetLayout::of(degree_);
  map.matrix.resize(index(layout.size()) * count);
  for (int k = 0; k < layout.size(); ++k) {
    const auto& ijk = layout.exponents(k);
    const double u = double(ijk[1]) / degree_, v = double(ijk[2]) / degree_;
    for (std::size_t n = 0; n < count; ++n) {
      double sum = 0;
      for (std::size_t m = 0; m < monomials; ++m)
        sum += scheme_->coefficients[n * monomials + m] * power(u, exponents[m][0]) * power(v, exponents[m][1]);
      map.matrix[index(k) * count + n] = sum;
      if (!std::isfinite(sum)) map.refusal = "its interpolation scheme overflows";
    }
  }
  // Gmsh writes the Lagrange basis of elements as a scheme: then values are taken over bit for bit.
  Map plain = count == index(layout.size()) ? lagrange(degree_) : Map{};
  if (plain.source.empty()) return map;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t n = 0; n < count; ++n)
      if (std::fabs(map.matrix[k * count + n] - (index(plain.source[k]) == n ? 1 : 0)) > same_basis) return map;
  return plain;
}

std::string MshBasis::prepare(std::size_t count) {
  if (map_ != nullptr && count == count_) return map_->refusal;
  count_ = count;
  if (scheme_ != nullptr) {
    if (!scheme_map_) scheme_map_ = by_scheme();
    map_ = &*scheme_map_;
    if (map_->refusal.empty() && count != scheme_->count) {
      map_ = nullptr;
      return "an element has " + std::to_string(count) + " values, and its interpolation scheme " +
             std::to_string(scheme_->count);
    }
    return map_->refusal;
  }
  for (int order = 0; order <= max_degree; ++order)
    if (index(net_size(order)) == count) {
      std::optional<Map>& map = lagrange_[index(order)];
      if (!map) map = lagrange(order);
      map_ = &*map;
      return map_->refusal;
    }
  map_ = nullptr;
  return "an element has " + std::to_string(count) + " values, which no triangle of order 1 to 10 has";
}

void MshBasis::apply(const double* values, std::size_t width, double* out) const {
  const std::size_t rows = index(net_size(degree_));
  if (!map_->source.empty()) {
    for (std::size_t k = 0; k < rows; ++k) std::copy_n(values + index(map_->source[k]) * width, width, out + k * width);
    return;
  }
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t c = 0; c < width; ++c) {
      double sum = 0;
      for (std::size_t n = 0; n < count_; ++n) sum += map_->matrix[k * count_ + n] * values[n * width + c];
      out[k * width + c] = sum;
    }
}

}  // namespace pliant

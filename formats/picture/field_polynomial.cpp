// formats/picture/field_polynomial.cpp: a field on each element as one polynomial, for bounds and curves of equal
// values.
#include "formats/picture/field_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

constexpr double range_tolerance = 1e-7;  // of the difference of the greatest and the least value
constexpr int most_pieces = 2000;         // of an element, in the search for its greatest value

/// Raises the greatest value known by that of one polynomial on the triangle, found by quartering what may be above it.
class Summit {
 public:
  explicit Summit(double greatest) : greatest_(greatest) {}
  double greatest() const { return greatest_; }
  void climb(int degree, const std::vector<double>& net, double tolerance) {
    pieces_ = 0;
    search(degree, net, tolerance, 0);
  }

 private:
  void search(int degree, const std::vector<double>& net, double tolerance, int depth) {
    for (std::size_t c = 0; c < 3; ++c) greatest_ = std::max(greatest_, net[c]);
    const double bound = *std::max_element(net.begin(), net.end());
    if (bound <= greatest_ + tolerance || depth == 24 || ++pieces_ > most_pieces) return;
    const Barycentric a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, ab{0.5, 0.5, 0}, bc{0, 0.5, 0.5}, ca{0.5, 0, 0.5};
    std::vector<double> part(net.size());
    for (const auto& [u, v, w] :
         {std::array{ab, bc, ca}, std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}}) {
      sub_net(degree, 1, net, u, v, w, part);
      search(degree, part, tolerance, depth + 1);
    }
  }
  double greatest_;
  int pieces_ = 0;
};

}  // namespace

FieldPolynomial::FieldPolynomial(const MeshData& mesh, const ElementValues& values)
    : mesh_(mesh), values_(values), squared_(!values.component()) {
  width_ = static_cast<std::size_t>(values.field().components);
  first_ = squared_ ? 0 : static_cast<std::size_t>(*values.component());
  components_ = squared_ ? width_ : 1;
  double most = 0;
  for (std::size_t k = 0; k < values.field().values.size(); ++k)
    if (k % width_ >= first_ && k % width_ < first_ + components_)
      most = std::max(most, std::abs(values.field().values[k]));
  int exponent = 0;
  std::frexp(most, &exponent);
  // Clamped so that the scale and its inverse are normal numbers.
  scale_ = std::ldexp(1.0, std::clamp(exponent, -1021, 1021));
}

double FieldPolynomial::from_field(double value) const {
  const double scaled = value / scale_;
  if (!squared_) return scaled;
  return value < 0 ? std::numeric_limits<double>::quiet_NaN() : scaled * scaled;
}

double FieldPolynomial::to_field(double value) const {
  return (squared_ ? std::sqrt(std::max(0.0, value)) : value) * scale_;
}

void FieldPolynomial::load(TriangleId t) {
  values_.control_values(t, rows_);
  for (double& value : rows_) value /= scale_;
}

double FieldPolynomial::row(std::size_t point, std::size_t component) const {
  return rows_[point * width_ + first_ + component];
}

const std::vector<double>& FieldPolynomial::on_element(TriangleId t) {
  load(t);
  const auto size = static_cast<std::size_t>(net_size(mesh_.degree));
  std::vector<double> one(size), square(static_cast<std::size_t>(net_size(degree())));
  result_.assign(square.size(), 0);
  for (std::size_t c = 0; c < components_; ++c) {
    for (std::size_t k = 0; k < size; ++k) one[k] = row(k, c);
    if (squared_) multiply_triangle(mesh_.degree, one, mesh_.degree, one, square);
    for (std::size_t k = 0; k < result_.size(); ++k) result_[k] += squared_ ? square[k] : one[k];
  }
  return result_;
}

std::vector<double> FieldPolynomial::on_edge(TriangleId t, int e) {
  load(t);
  const NetLayout& layout = NetLayout::of(mesh_.degree);
  const auto degree_of_mesh = static_cast<std::size_t>(mesh_.degree);
  std::vector<double> one(degree_of_mesh + 1), square(static_cast<std::size_t>(degree()) + 1);
  std::vector<double> result(square.size(), 0);
  const std::size_t net = static_cast<std::size_t>(t) * static_cast<std::size_t>(layout.size());
  const auto corner = [&](int c) { return mesh_.triangles[net + static_cast<std::size_t>(c % 3)]; };
  const bool forward = corner(e) < corner(e + 1);
  for (std::size_t c = 0; c < components_; ++c) {
    for (std::size_t k = 0; k < one.size(); ++k)
      one[k] =
          row(static_cast<std::size_t>(layout.edge_index(e, static_cast<int>(forward ? k : degree_of_mesh - k))), c);
    if (squared_) multiply_segment(mesh_.degree, one, mesh_.degree, one, square);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += squared_ ? square[k] : one[k];
  }
  return result;
}

ValueRange exact_range(const MeshData& mesh, const ElementValues& values, std::span<const TriangleId> without) {
  const ValueRange sampled = values.range(without);
  if (!values.is_field() || sampled.is_empty()) return sampled;
  FieldPolynomial polynomial(mesh, values);
  double high = polynomial.from_field(sampled.low), low = high;
  const auto each = [&](const auto& use) {
    for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
      if (!std::binary_search(without.begin(), without.end(), t)) use(polynomial.on_element(t));
  };
  // The values at vertices first: few elements are above all of them.
  each([&](const std::vector<double>& net) {
    for (std::size_t c = 0; c < 3; ++c) low = std::min(low, net[c]), high = std::max(high, net[c]);
  });
  high = std::max(high, polynomial.from_field(sampled.high));
  const double tolerance = range_tolerance * (high - low);
  Summit top(high), bottom(-low);
  each([&](std::vector<double> net) {
    top.climb(polynomial.degree(), net, tolerance);
    for (double& value : net) value = -value;
    bottom.climb(polynomial.degree(), net, tolerance);
  });
  ValueRange range;
  range.extend(polynomial.to_field(-bottom.greatest()));
  range.extend(polynomial.to_field(top.greatest()));
  return range;
}

}  // namespace pliant

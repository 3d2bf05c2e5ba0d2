// lib/pliant/geometry/net_layout.h: the order of the control points of a Bézier triangle.
#pragma once
#include <array>
#include <vector>

namespace pliant {

inline constexpr int max_degree = 10;      ///< the greatest degree of a mesh
inline constexpr int max_net_degree = 40;  ///< the greatest degree of a polynomial on the triangle (det J, products)

/// How many control points a Bézier triangle has.
constexpr int net_size(int degree) { return (degree + 1) * (degree + 2) / 2; }
/// How many of them are inside: not on an edge, and no corner.   Requires    degree >= 1
constexpr int interior_size(int degree) { return (degree - 1) * (degree - 2) / 2; }

/// The order of the entries of a net of a given degree: corners 1 2 3, then the points of edges 12, 23, 31, each from
/// its first to its second corner, then the interior by descending i, then descending j (for degree 2: 200, 020, 002,
/// 110, 011, 101). Documents, meshes and scalar polynomials all have this order.
///
/// Edge e (0, 1, 2) runs from corner e to corner (e + 1) % 3.
class NetLayout {
 public:
  /// The layout of one degree, built once. Requires 0 <= degree <= max_net_degree. Thread-safe.
  static const NetLayout& of(int degree);

  int degree() const { return degree_; }
  int size() const { return pliant::net_size(degree_); }
  /// Exponents (i, j, k), i + j + k = degree, of the entry at `index`.
  const std::array<int, 3>& exponents(int index) const { return exponents_[static_cast<std::size_t>(index)]; }
  /// Index of the entry with exponents (i, j, degree - i - j).
  int index(int i, int j) const { return index_[static_cast<std::size_t>(i * (degree_ + 1) + j)]; }
  /// Index of the k-th control point (0..degree) of edge e, from its first corner to its second.
  int edge_index(int e, int k) const {
    if (k == 0) return e;
    if (k == degree_) return (e + 1) % 3;
    return 3 + e * (degree_ - 1) + k - 1;
  }
  /// Index of the first interior entry; all entries from there to the end are interior.   Requires    degree >= 1
  int first_interior() const { return 3 * degree_; }
  /// p! / (i! j! k!) of the entry: B_ijk = multinomial * xi1^i xi2^j xi3^k.
  double multinomial(int index) const { return multinomial_[static_cast<std::size_t>(index)]; }

 private:
  explicit NetLayout(int degree);
  int degree_;
  std::vector<std::array<int, 3>> exponents_;
  std::vector<int> index_;
  std::vector<double> multinomial_;
};

/// The entries of a net in the order of Gmsh's and VTK's nodes, each as its index in NetLayout: corners, the points of
/// edges 12, 23 and 31, and then the inner ones as a net of degree - 3 in this same order.   Requires    degree >= 1
std::vector<int> nested_net_order(int degree);

}  // namespace pliant

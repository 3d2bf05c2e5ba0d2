// lib/pliant/geometry/validity/jacobian_terms.h: det J as a sum of cross products.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant {

inline constexpr int max_partials = net_size(max_degree - 1);
inline constexpr int max_jacobian_size = net_size(2 * (max_degree - 1));

/// One term of the sum: weight * cross(along_2[i], along_3[j]) is added to coefficient `target` of det J. The partials
/// along_2 and along_3 are plain differences of control points, in the order of NetLayout::of(degree - 1).
struct JacobianTerm {
  int i, j, target;
  double weight;           ///< p^2 (multinomial of i) (multinomial of j) / (multinomial of target), rounded
  double integer_product;  ///< (multinomial of i) (multinomial of j), exact
};

/// All terms of det J for elements of one degree; they do not depend on the control points.
struct JacobianTerms {
  int degree = 0;                              ///< the degree of the element
  std::vector<std::array<int, 3>> partials;    ///< for each partial: the control points m + e1, m + e2, m + e3
  std::vector<JacobianTerm> terms;             ///< sorted by target
  int most_terms = 0;                          ///< how many terms the target with the most terms has
  static const JacobianTerms& of(int degree);  ///< 1 <= degree <= max_degree; thread-safe
};

/// The differences of control points: along_2[m] = net[m + e2] - net[m + e1], along_3[m] = net[m + e3] - net[m + e1].
void partial_differences(const JacobianTerms& terms, std::span<const Point> net, std::span<Vector> along_2,
                         std::span<Vector> along_3);

}  // namespace pliant

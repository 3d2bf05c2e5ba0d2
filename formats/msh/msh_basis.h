// formats/msh/msh_basis.h: the values that a file gives to an element, as values at the nodes of the mesh's degree.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/msh/msh_file.h"

namespace pliant {

/// From the values of an element to the values at the lattice nodes of a triangle of the mesh's degree, in the order of
/// NetLayout.
class MshBasis {
 public:
  /// `scheme` says what the values mean; without one, n values are those at the nodes of the order that has n nodes.
  MshBasis(int degree, const MshScheme* scheme) : degree_(degree), scheme_(scheme) {}

  /// Why `count` values do not give a polynomial of the mesh's degree; an empty text if they do, and `apply` may be
  /// called with as many.
  std::string prepare(std::size_t count);
  /// Shapes      values: `count` rows of `width` numbers; out: net_size(degree) rows
  void apply(const double* values, std::size_t width, double* out) const;

 private:
  struct Map {
    std::string refusal;
    std::vector<int> source;     ///< the row of `values` for each node, where nodes only change their places
    std::vector<double> matrix;  ///< otherwise: net_size(degree) rows of `count` factors
  };
  Map lagrange(int order) const;
  Map by_scheme() const;

  int degree_;
  const MshScheme* scheme_;
  std::array<std::optional<Map>, 11> lagrange_;  ///< by order
  std::optional<Map> scheme_map_;
  const Map* map_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace pliant

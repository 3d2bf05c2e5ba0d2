// lib/pliant/fem/solve/coarse_space.cpp: hat functions in the Bernstein basis, by degree elevation of linear functions.
#include "pliant/fem/solve/coarse_space.h"

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

CoarseSpace hat_functions(int degree, std::span<const int> nets, int unknowns) {
  const NetLayout& layout = NetLayout::of(degree);
  const std::size_t size = index(layout.size()), triangles = nets.size() / size;
  // The hats in the order of their vertices' numbers, so that neighbours stay near.
  std::vector<int> hats(index(unknowns), -1);
  for (std::size_t t = 0; t < triangles; ++t)
    for (std::size_t c = 0; c < 3; ++c)
      if (const int v = nets[t * size + c]; v >= 0) hats[index(v)] = 0;
  CoarseSpace result;
  for (int& hat : hats)
    if (hat == 0) hat = result.size++;
  // Any triangle of a control point gives the same weights: those of corners that it does not share are 0.
  std::vector<std::size_t> places(index(unknowns), nets.size());
  for (std::size_t k = 0; k < nets.size(); ++k)
    if (nets[k] >= 0) places[index(nets[k])] = k;
  for (const std::size_t place : places) {
    if (place < nets.size()) {
      const auto& exponents = layout.exponents(static_cast<int>(place % size));
      for (std::size_t c = 0; c < 3; ++c)
        if (const int v = nets[place / size * size + c]; v >= 0 && exponents[c] > 0) {
          result.columns.push_back(hats[index(v)]);
          result.weights.push_back(static_cast<double>(exponents[c]) / degree);
        }
    }
    result.starts.push_back(static_cast<int>(result.columns.size()));
  }
  return result;
}

}  // namespace pliant

// lib/pliant/geometry/lattice.h: the order of a net's rows inside de Casteljau (private to this layer).
#pragma once
#include <vector>

namespace pliant {

/// The place of entry (i, j, k) when entries are counted line by line, r = j + k, from the first corner. It does not
/// depend on the degree, so a step of de Casteljau reads only entries at or after the one it writes, and runs in place.
constexpr int lattice_index(int r, int k) { return r * (r + 1) / 2 + k; }

/// The lattice index of each entry of NetLayout::of(degree). Thread-safe.
const std::vector<int>& lattice_order(int degree);

}  // namespace pliant

// lib/pliant/geometry/dense/solve_dense.h: small square systems, solved without allocation in the long run.
#pragma once
#include <span>

namespace pliant {

/// Solves matrix * x = right by elimination with full pivoting; x takes the place of `right`, the matrix is used up.
/// What the matrix does not determine, to rounding, is 0.
///
/// Shapes      matrix: n x n, right: n x columns, both row after row
/// Complexity  O(n^3)
void solve_dense(int n, std::span<double> matrix, int columns, std::span<double> right);

}  // namespace pliant

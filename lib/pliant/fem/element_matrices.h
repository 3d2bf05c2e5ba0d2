// lib/pliant/fem/element_matrices.h: mass, stiffness, convection, divergence and load of one element.
#pragma once
#include <array>
#include <span>

#include "pliant/fem/element_map.h"

namespace pliant {

/// A symmetric 2 x 2 matrix.
struct SymmetricTensor {
  double xx = 1, xy = 0, yy = 1;
};

/// Shapes      n = net_size(degree) basis functions B of the element; pairs: the lower triangle row after row; full:
///             n x n, row after row. Everything is overwritten, not added to.
/// Units       integrals over the physical element

/// pairs (i, j): the integral of c B_i B_j. `factors` has c at each point of the rule.
void element_mass(const ElementMap& map, std::span<const double> factors, std::span<double> pairs);
/// pairs (i, j): the integral of grad B_i . k grad B_j. `tensors` has k at each point of the rule.
void element_stiffness(const ElementMap& map, std::span<const SymmetricTensor> tensors, std::span<double> pairs);
/// full (i, j): the integral of B_i (v . grad B_j). `velocities` has v at each point of the rule.
void element_convection(const ElementMap& map, std::span<const Vector> velocities, std::span<double> full);
/// Two matrices: the integrals of Q_i dB_j/dx and of Q_i dB_j/dy. Q are the basis functions of degree `pressure`.
/// Shapes      along_x, along_y: net_size(pressure) x n, row after row
void element_divergence(const ElementMap& map, int pressure, std::span<double> along_x, std::span<double> along_y);
/// i: the integral of f B_i. `factors` has f at each point of the rule.
void element_load(const ElementMap& map, std::span<const double> factors, std::span<double> load);

/// A symmetric matrix given as pairs, as a full one.
void unpack_pairs(int size, std::span<const double> pairs, std::span<double> full);
/// y = A x for a symmetric matrix given as pairs.
void multiply_pairs(std::span<const double> pairs, std::span<const double> x, std::span<double> y);

}  // namespace pliant

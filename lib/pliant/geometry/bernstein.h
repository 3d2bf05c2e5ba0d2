// lib/pliant/geometry/bernstein.h: scalar polynomials in Bernstein form, on [0, 1] and on the triangle.
#pragma once
#include <span>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

// On the triangle coefficients stand in the order of NetLayout.
namespace pliant {

/// B^p_k(s), k = 0..p; and B^p_ijk(xi) in the order of NetLayout.
void bernstein_basis(int degree, double s, std::span<double> values);
void bernstein_basis(int degree, const Barycentric& xi, std::span<double> values);

/// Product, of degree p + q.
void multiply_segment(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product);
void multiply_triangle(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product);

/// Integral over [0, 1] (the mean coefficient) and over the unit right triangle (half of it).
double integrate_segment(int degree, std::span<const double> a);
double integrate_triangle(int degree, std::span<const double> a);

/// Derivative, of degree p - 1; on the triangle along (xi2, xi3) with xi1 = 1 - xi2 - xi3.
void differentiate_segment(int degree, std::span<const double> a, std::span<double> derivative);
void differentiate_triangle(int degree, std::span<const double> a, std::span<double> along_2,
                            std::span<double> along_3);

/// The Gram matrix of the Bernstein basis over the unit right triangle: entry (m, n) = ∫ B_m B_n, row-major.
/// Built once for each degree; thread-safe.
std::span<const double> mass_matrix(int degree);

}  // namespace pliant

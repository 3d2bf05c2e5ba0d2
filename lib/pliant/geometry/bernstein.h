// lib/pliant/geometry/bernstein.h: scalar polynomials in Bernstein form, on [0, 1] and on the triangle.
#pragma once
#include <span>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

// The coefficients of a polynomial on the triangle are in the order of NetLayout.
namespace pliant {

/// The values of all basis functions of one degree p: B^p_k(s) for k = 0..p, and B^p_ijk(xi) in the order of NetLayout.
void bernstein_basis(int degree, double s, std::span<double> values);
void bernstein_basis(int degree, const Barycentric& xi, std::span<double> values);

/// The coefficients of the product of a (degree p) and b (degree q), which has degree p + q.
/// Requires    `product` shares no memory with a or b
void multiply_segment(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product);
void multiply_triangle(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product);

/// The integral over [0, 1], which is the mean coefficient, and over the unit right triangle, which is half the mean.
double integrate_segment(int degree, std::span<const double> a);
double integrate_triangle(int degree, std::span<const double> a);

/// The coefficients of the derivative, which has degree p - 1. On the triangle there are two: with respect to xi2 and
/// to xi3, where xi1 = 1 - xi2 - xi3.
void differentiate_segment(int degree, std::span<const double> a, std::span<double> derivative);
void differentiate_triangle(int degree, std::span<const double> a, std::span<double> along_2,
                            std::span<double> along_3);

/// The Gram matrix of the Bernstein basis over the unit right triangle: entry (m, n) = ∫ B_m B_n, row-major.
/// Built once for each degree; thread-safe.
std::span<const double> mass_matrix(int degree);

}  // namespace pliant

// lib/pliant/fem/solve/dense_panel.cpp: a product of small dense blocks that keeps what it sums in registers.
#include "pliant/fem/solve/dense_panel.h"

#include <algorithm>
#include <cstddef>

namespace pliant {
namespace {

constexpr int tile_rows = 4, tile_columns = 4;

template <int count>
void subtract_tile(int rows, int depth, const double* a, std::ptrdiff_t stride_a, const double* w,
                   std::ptrdiff_t stride_w, double* c, std::ptrdiff_t stride_c) {
  int i = 0;
  for (; i + tile_rows <= rows; i += tile_rows) {
    double sums[count][tile_rows] = {};
    const double* column = a + i;
    const double* row = w;
    for (int k = 0; k < depth; ++k, column += stride_a, row += stride_w)
      for (int j = 0; j < count; ++j)
        for (int r = 0; r < tile_rows; ++r) sums[j][r] += column[r] * row[j];
    for (int j = 0; j < count; ++j)
      for (int r = 0; r < tile_rows; ++r) c[j * stride_c + i + r] -= sums[j][r];
  }
  for (; i < rows; ++i)
    for (int j = 0; j < count; ++j) {
      double sum = 0;
      for (int k = 0; k < depth; ++k) sum += a[k * stride_a + i] * w[k * stride_w + j];
      c[j * stride_c + i] -= sum;
    }
}

}  // namespace

void subtract_product(int rows, int columns, int depth, const double* a, int stride_a, const double* w, double* c,
                      int stride_c) {
  int j = 0;
  for (; j + tile_columns <= columns; j += tile_columns)
    subtract_tile<tile_columns>(rows, depth, a, stride_a, w + j, columns, c + std::ptrdiff_t{j} * stride_c, stride_c);
  double* const rest = c + std::ptrdiff_t{j} * stride_c;
  switch (columns - j) {
    case 1:
      return subtract_tile<1>(rows, depth, a, stride_a, w + j, columns, rest, stride_c);
    case 2:
      return subtract_tile<2>(rows, depth, a, stride_a, w + j, columns, rest, stride_c);
    case 3:
      return subtract_tile<3>(rows, depth, a, stride_a, w + j, columns, rest, stride_c);
    default:
      return;
  }
}

}  // namespace pliant

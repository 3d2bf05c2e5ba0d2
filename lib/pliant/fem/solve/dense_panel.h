// lib/pliant/fem/solve/dense_panel.h: the dense arithmetic in the columns of a supernode.
#pragma once

namespace pliant {

/// C -= A W, with C rows x columns and A rows x depth stored by columns (`stride_c`, `stride_a` from one to the next),
/// and W depth x columns stored by rows. Each entry is summed in the order of A's columns, however the loops are cut.
void subtract_product(int rows, int columns, int depth, const double* a, int stride_a, const double* w, double* c,
                      int stride_c);

}  // namespace pliant

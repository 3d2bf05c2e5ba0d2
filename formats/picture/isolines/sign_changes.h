// formats/picture/isolines/sign_changes.h: where a polynomial on a segment changes its sign.
#pragma once
#include <span>
#include <vector>

namespace pliant {

/// The parameters in [0, 1], in ascending order, at which the polynomial with these Bernstein coefficients passes from
/// below zero to zero and above, or back. Zeros without a change of sign are left out.
///
/// The signs at the ends are given (`above`: at least zero) since neighbours must agree on them; the number of
/// parameters is odd exactly if the signs differ, also where rounding makes the coefficients say otherwise.
std::vector<double> sign_changes(std::span<const double> coefficients, bool above_at_0, bool above_at_1);

}  // namespace pliant

// lib/pliant/geometry/validity/exact_validity.h: the certificate in exact arithmetic (private to this layer).
#pragma once
#include <span>

#include "pliant/geometry/validity/validity.h"

namespace pliant {

/// A verdict, and, where it is `degenerate`, how near to zero: |min det J| <= gap * max |coefficient of det J|.
struct Certificate {
  Validity validity = Validity::degenerate;
  double gap = 0;
};

/// The gap at which the search for p > 2 ends; with a corner forgiven, where all is as small as high powers of the
/// distance to it, a smaller one.
inline constexpr double degenerate_gap = 0x1p-112;
inline constexpr double degenerate_gap_at_cusp = 0x1p-400;

/// What certify (corner = -1) and certify_cusp promise, in exact integers: the control points are scaled by powers of
/// two to integers of any length, so nothing is rounded, overflows or underflows. For p <= 2 the sign of the minimum
/// itself, the gap always 0. For p > 2 by bisection, the piece with the lowest coefficient next: the gap is 0 where the
/// minimum is seen to be 0 exactly; otherwise degenerate_gap, or more where 2048 bisections did not suffice.
///
/// That gap has a bound. The coefficients c of a piece differ from the linear interpolant of its corners by at most
/// (d^2 / 6) M, M the greatest second difference of c along an edge (by lines parallel to an edge). At depth l every
/// edge is at most 2^-floor((l - 1) / 2) of a side or median of the element, so M is at most 4^(1 - floor((l - 1) / 2))
/// of the greatest coefficient. An open piece has corners that are not negative, so its coefficients are above -(d^2 /
/// 6) M and one of its corners is below (d^2 / 6) M. Of 2048 bisected pieces one at least is at depth 11, and what is
/// left is no lower than any of them: the gap is at most (8 / 3) (p - 1)^2 / 2^10.
///
/// Coefficients longer than some 570 bits, of control points whose exponents differ by hundreds, are rounded down to
/// some 512 before they are bisected: "valid" and "invalid" stay proofs, and the gap of a minimum of 0 is then
/// not 0.
///
/// With a corner forgiven, the gap bounds min det J from below only (at that corner det J may be 0), and the bound on
/// the gap does not hold (pieces there are divided otherwise).
Certificate certify_exactly(int degree, std::span<const Point> net, int corner);

}  // namespace pliant

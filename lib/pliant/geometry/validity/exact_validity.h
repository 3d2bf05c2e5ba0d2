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

/// The gap at which the search for p > 2 ends. If a corner is forgiven the gap is smaller, because near that corner all
/// values are as small as high powers of the distance to it.
inline constexpr double degenerate_gap = 0x1p-112;
inline constexpr double degenerate_gap_at_cusp = 0x1p-400;

/// The certificate that certify (corner = -1) and certify_cusp promise, in exact integers: powers of two scale the
/// control points to integers of any length, so nothing is rounded, overflows or underflows. For p <= 2 the verdict is
/// the sign of the minimum itself, and the gap is always 0. For p > 2 the piece with the lowest coefficient is bisected
/// next. The gap is then 0 if the minimum is seen to be exactly 0; otherwise it is degenerate_gap, or more if 2048
/// bisections did not suffice.
///
/// That larger gap has a bound. Let d be the degree of det J. The coefficients c of a piece differ from the linear
/// interpolant of its corners by at most (d^2 / 6) M, where M is the greatest second difference of c along a line
/// parallel to an edge. At depth l every edge is at most 2^-floor((l - 1) / 2) of a side or median of the element, so M
/// is at most 4^(1 - floor((l - 1) / 2)) of the greatest coefficient. An open piece has corners that are not negative,
/// so its coefficients are above -(d^2 / 6) M and one of its corners is below (d^2 / 6) M. Among 2048 bisected pieces
/// at least one is at depth 11, and no piece that is left is lower than any of these. So the gap is at most
/// (8 / 3) (p - 1)^2 / 2^10.
///
/// Coefficients longer than some 570 bits, which come from control points whose exponents differ by hundreds, are
/// rounded down to some 512 bits before they are bisected. "valid" and "invalid" stay proofs, but the gap of a minimum
/// of 0 is then not 0.
///
/// If a corner is forgiven, the gap bounds min det J from below only (at that corner det J may be 0), and the bound on
/// the gap does not hold (pieces there are divided differently).
Certificate certify_exactly(int degree, std::span<const Point> net, int corner);

}  // namespace pliant

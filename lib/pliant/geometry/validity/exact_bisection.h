// lib/pliant/geometry/validity/exact_bisection.h: is a polynomial of long integers positive? (private to this layer).
#pragma once
#include "pliant/geometry/validity/exact_validity.h"
#include "pliant/geometry/validity/limb_net.h"

namespace pliant {

/// The certificate of certify_exactly, from the coefficients of det J (or any positive multiple of it). The piece with
/// the lowest coefficient is bisected next. `bits` is the length of the greatest |coefficient|, which is not 0;
/// `corner` is the corner that is forgiven, or -1.
Certificate certify_by_bisection(LimbNet net, int bits, int corner);

}  // namespace pliant

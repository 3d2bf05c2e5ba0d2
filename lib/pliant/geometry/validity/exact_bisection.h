// lib/pliant/geometry/validity/exact_bisection.h: is a polynomial of long integers positive? (private to this layer).
#pragma once
#include "pliant/geometry/validity/exact_validity.h"
#include "pliant/geometry/validity/limb_net.h"

namespace pliant {

/// What certify_exactly says of an element, from the coefficients of its det J (any positive multiple), by bisection
/// of the piece with the lowest coefficient. `bits` is the length of the greatest |coefficient|, not 0; `corner` is the
/// one that is forgiven, or -1.
Certificate certify_by_bisection(LimbNet net, int bits, int corner);

}  // namespace pliant

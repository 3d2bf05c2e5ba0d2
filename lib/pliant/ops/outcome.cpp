// lib/pliant/ops/outcome.cpp: the reasons of refusals in words.
#include "pliant/ops/outcome.h"

namespace pliant {

const char* describe(Refusal refusal) {
  switch (refusal) {
    case Refusal::done:
      return "done";
    case Refusal::outer_boundary:
      return "outer boundary";
    case Refusal::constrained:
      return "constrained";
    case Refusal::corner:
      return "corner";
    case Refusal::not_convex:
      return "not convex";
    case Refusal::edge_exists:
      return "edge exists";
    case Refusal::bent_side:
      return "a bent edge beside it is in the way";
    case Refusal::would_bend:
      return "would bend too much";
    case Refusal::covers_corner:
      return "covers a corner of the boundary";
    case Refusal::would_invert:
      return "would invert";
    case Refusal::not_removable:
      return "not removable";
    case Refusal::exceeds_tolerance:
      return "exceeds the tolerance";
    case Refusal::too_curved:
      return "would turn too much";
    case Refusal::loses_integral:
      return "would lose a part of a field's integral";
    case Refusal::not_in_domain:
      return "outside";
  }
  return "unknown";
}

}  // namespace pliant

// lib/pliant/ops/outcome.cpp: the reasons of refusals in words.
#include "pliant/ops/outcome.h"

namespace pliant {

const char* describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::done:
      return "done";
    case Outcome::outer_boundary:
      return "outer boundary";
    case Outcome::constrained:
      return "constrained";
    case Outcome::corner:
      return "corner";
    case Outcome::not_convex:
      return "not convex";
    case Outcome::edge_exists:
      return "edge exists";
    case Outcome::bent_side:
      return "a bent edge beside it is in the way";
    case Outcome::would_bend:
      return "would bend too much";
    case Outcome::covers_corner:
      return "covers a corner of the boundary";
    case Outcome::would_invert:
      return "would invert";
    case Outcome::not_removable:
      return "not removable";
    case Outcome::exceeds_tolerance:
      return "exceeds the tolerance";
    case Outcome::too_curved:
      return "would leave an edge that is too curved";
    case Outcome::loses_integral:
      return "would lose a part of a field's integral";
    case Outcome::not_in_domain:
      return "outside";
  }
  return "unknown";
}

}  // namespace pliant

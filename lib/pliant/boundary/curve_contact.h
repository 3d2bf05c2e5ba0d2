// lib/pliant/boundary/curve_contact.h: do Bézier curves cross or touch away from their common ends?
#pragma once
#include <array>
#include <optional>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// A Bézier curve with the names of its ends: two curves have a common end exactly if they have a common node.
struct ContactCurve {
  std::span<const Point> polygon;
  int from, to;
};

struct Contact {
  enum class Kind {
    meets,      ///< the curves cross, touch, or are closer than 1e-11 of their size
    turns_back  ///< tangents at a common end (node) point the same way: a cusp, or curves that coincide
  };
  Kind kind;
  double s, t;  ///< parameters in [0, 1] on the first and on the second curve
  Point place;
  int node = -1;  ///< of turns_back
};

/// The first contact found of two curves, by subdivision with separating lines. Curves that meet in a common node with
/// tangent angle 0 are compared down to 1e-7 of the shorter one's length, or 1e-9 where the margin allows; if nothing
/// else is found, that is `turns_back`.
std::optional<Contact> find_contact(const ContactCurve& a, const ContactCurve& b);

/// The same of one curve with itself; a parameter where the derivative vanishes counts as turns_back with node -1.
std::optional<Contact> find_self_contact(const ContactCurve& a);

}  // namespace pliant

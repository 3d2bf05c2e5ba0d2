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
  int node = -1;  ///< the common node if they turn back there
};

/// The first contact of two curves that is found, by subdivision with separating lines. Curves that leave a common node
/// in the same direction are compared down to a distance from it of 1e-7 of the shorter one, or 1e-9 where rounding
/// allows; if they do not meet there, their contact is `turns_back`.
std::optional<Contact> find_contact(const ContactCurve& a, const ContactCurve& b);

/// The same for one curve with itself. A parameter where the derivative vanishes counts as `turns_back` with node -1.
std::optional<Contact> find_self_contact(const ContactCurve& a);

}  // namespace pliant

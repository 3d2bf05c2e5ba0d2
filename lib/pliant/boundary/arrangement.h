// lib/pliant/boundary/arrangement.h: disjoint faces from curves that cross, touch or overlap.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"

namespace pliant {

/// Which winding numbers are inside.
enum class FillRule { nonzero, evenodd };

/// What is painted: the points around which the curves wind as the rule says.
struct FilledFace {
  std::string name;
  std::vector<BSpline>
      curves;  ///< closed ones; open ones that chain to loops, each ending bit for bit where one starts
  FillRule rule = FillRule::nonzero;
  ExtraMembers extra;
};

/// All are relative to the size of the input, the diagonal of the box of its control points.
struct ArrangeOptions {
  double tolerance = 1e-11;  ///< what is closer touches, or coincides
  double coarsest = 1e-6;    ///< what the tolerance may become where it gives no boundary
  double tip = 4e-9;         ///< what turns by more than 60 degrees within this length becomes a corner
  double sliver = 1e-9;      ///< two pieces between the same two vertices, nowhere farther apart, become one
};

/// The outcome, with counts.
struct Arrangement {
  BoundaryComplex boundary;
  std::vector<int> sources;     ///< which input face each face is: those that nothing is left of are gone
  long intersections = 0;       ///< places where curves cross, touch, branch or run together
  long pieces = 0;              ///< between them, each counted once
  long regions = 0;             ///< bounded regions of the plane between the pieces
  long slivers = 0;             ///< pieces merged with another that was not within the tolerance
  double sliver_area = 0;       ///< the area between them, at most
  double tolerance = 0;         ///< that it took: the one that was asked for, or a coarser one
  std::vector<Fault> faults{};  ///< why the boundary must not be used; empty if all is well
};

/// The disjoint regions that a painter sees: a point belongs to the last of the faces that has it inside.
///
/// Curves are cut where they cross, touch or part; pieces that run together become one; those with the same face on
/// both sides go. What is not cut stays one B-spline, its knots kept; a curve that is kept whole is kept bit for bit.
/// Pieces move by the snap at their ends (a few tolerances), and are otherwise exact parts of the input's curves.
/// Ensures     check_boundary and check_boundary_geometry find nothing, or `faults` says what and where
/// Requires    curves without BSpline::fault
/// Refuses     (in `faults`) loops that do not close, sizes beyond 1e-100 to 1e100, and what no tolerance makes a
/// boundary
///             that can be meshed: curves that stop in a cusp of their own, faces without a name of their own
/// Complexity  near O((n + k) log n) for n spans and k intersections, where boxes of spans overlap little
Arrangement arrange(std::span<const FilledFace> faces, const ArrangeOptions& options = {});

/// The same for a boundary complex whose curves cross: a face's winding numbers are those of the curves that have it on
/// their left, and, run backwards, on their right; nonzero is inside; later faces lie over earlier ones. Names and
/// other members of faces and curves stay; a document without intersections stays as it is, but for curves with the
/// same face on both sides, which go, and cusps, which are not listed. Requires    check_boundary(boundary) to be empty
Arrangement resolve(const BoundaryComplex& boundary, const ArrangeOptions& options = {});

}  // namespace pliant

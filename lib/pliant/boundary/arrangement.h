// lib/pliant/boundary/arrangement.h: disjoint faces from curves that cross, touch or overlap.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"

namespace pliant {

/// Which winding numbers count as inside.
enum class FillRule { nonzero, evenodd };

/// A face as it is painted: all points whose winding number, with respect to the curves, the rule counts as inside.
struct FilledFace {
  std::string name;
  /// Closed curves, and open ones that chain to loops: each ends, bit for bit, where one of them starts.
  std::vector<BSpline> curves;
  FillRule rule = FillRule::nonzero;
  ExtraMembers extra{};
  std::vector<int> clips{};  ///< only what lies in all of these clip areas is painted
};

/// An area that cuts off what is painted outside of it: the union of its parts, as far as it lies in all of `clips`.
struct ClipArea {
  std::vector<FilledFace> parts;
  std::vector<int> clips{};  ///< areas that come before this one, as those of the parts do
};

/// A curve that is drawn over faces and cuts them, but has none of its own.
struct DrawnLine {
  std::string name;
  BSpline curve;             ///< open or closed; it may cross itself and run over others
  int above = 0;             ///< how many of the faces are painted before it; those painted later hide it
  std::vector<int> clips{};  ///< as of FilledFace
};

/// All that is painted.
struct PaintedLayers {
  std::vector<FilledFace> faces;
  std::vector<ClipArea> clips{};
  std::vector<DrawnLine> lines{};
};

/// Lengths relative to the size of the input, which is the diagonal of the box of its control points.
struct ArrangeOptions {
  double tolerance = 1e-11;  ///< curves that are closer than this touch, or coincide
  double coarsest = 1e-6;    ///< the greatest tolerance to try when smaller ones give no valid boundary
  double tip = 4e-9;         ///< a curve that turns by more than 60 degrees within this length gets a corner there
  double sliver = 1e-9;      ///< pieces between the same two vertices, nowhere farther apart than this, become one
};

/// The outcome, with counts.
struct Arrangement {
  BoundaryComplex boundary;
  std::vector<int> sources;     ///< the input face that each face is a part of; input faces may have vanished
  long intersections = 0;       ///< places where curves cross, touch, branch or run together
  long pieces = 0;              ///< pieces of curves between these places; pieces that run together count once
  long regions = 0;             ///< bounded regions of the plane between the pieces
  long slivers = 0;             ///< pieces merged with another one that was not within the tolerance
  double sliver_area = 0;       ///< a bound of the area between those
  long bare_lines = 0;          ///< pieces of drawn lines that were left out because no face is beside them
  double tolerance = 0;         ///< the tolerance that was used: the one in the options, or a coarser one
  std::vector<Fault> faults{};  ///< why the boundary must not be used; empty if all is well
};

/// The disjoint faces that are seen when the given ones are painted one over the other: a point belongs to the last
/// face that has it inside.
///
/// Curves are cut where they cross, touch or part. Pieces that run together become one, and pieces with the same face
/// on both sides are dropped. A stretch of a curve that is not cut stays one B-spline with its knots, and a curve that
/// is not cut at all stays bit for bit. Ends of pieces are moved to their vertices (by a few tolerances); otherwise
/// pieces are exact parts of the given curves.
///
/// Requires    no curve has a BSpline::fault
/// Ensures     check_boundary and check_boundary_geometry find nothing, or `faults` says what is wrong and where
/// Refuses     (in `faults`) loops that do not close, sizes beyond 1e-100 to 1e100, and input that no tolerance makes a
///             boundary that can be meshed: curves with a cusp inside, faces without a name of their own
/// Complexity  near O((n + k) log n) for n spans and k intersections, where boxes of spans overlap little
Arrangement arrange(std::span<const FilledFace> faces, const ArrangeOptions& options = {});

/// The same with areas that clip faces, and with lines. A line becomes curves with the same face on both sides, or runs
/// along the border of one; where it crosses a border, another line or itself, both are cut. What lies outside of all
/// faces, below later ones or outside of its clip areas is left out. A closed line divides no face: what it encloses
/// stays a part of the face around it.
Arrangement arrange_layers(const PaintedLayers& layers, const ArrangeOptions& options = {});

/// The same for a boundary complex whose curves cross. The winding numbers of a face are those of the curves that have
/// it on their left, and of the curves that have it on their right, run backwards. A point with a winding number other
/// than 0 is inside, and later faces are over earlier ones. Names and other members of faces and curves stay. A
/// document without intersections stays as it is, except that curves with the same face on both sides are dropped, and
/// that cusps are not listed.
///
/// Requires    check_boundary(boundary) finds nothing
Arrangement resolve(const BoundaryComplex& boundary, const ArrangeOptions& options = {});

}  // namespace pliant

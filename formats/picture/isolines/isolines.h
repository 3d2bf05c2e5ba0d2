// formats/picture/isolines/isolines.h: curves on which a field has one value, across the elements of a mesh.
#pragma once
#include <functional>
#include <vector>

#include "formats/picture/field_polynomial.h"
#include "formats/picture/mesh_edges.h"

namespace pliant {

/// A chain of Bézier curves of degree 1 and 3; each begins, bit for bit, where the one before ends.
struct Isoline {
  bool closed = false;  ///< the last curve ends where the first begins
  std::vector<std::vector<Point>> curves;
};

struct IsolineSet {
  std::vector<Isoline> lines;
  /// Places where the field is flat along a whole line at this value (a ridge), so that the curve is not certain: there
  /// it is drawn straight across a 64th of the element.
  std::size_t uncertain = 0;
};

/// The isoline of the polynomial at a value: the border of where it is at least that, with that to its left. Where the
/// field is a constant there is none; where it is the value throughout a region, its border.
///
/// In an element, the curve is followed through pieces in which the polynomial is proved to be monotone along one
/// direction, or to differ from the value everywhere, so no part of it is missed and parts are joined as they belong.
/// Ends on an edge are the zeros of the field on the edge, computed once for both sides.
///
/// `in_element` tells whether an element is looked at; lines end where they would go on in another. All are, without
/// it.
///
/// Units       `tolerance` is a length: how far the curves may be from the isoline (arc.h says how it is checked)
/// Requires    M1 and M2; elements need not be valid
IsolineSet trace_isoline(const MeshData& mesh, const MeshEdges& edges, FieldPolynomial& polynomial, double value,
                         double tolerance, const std::function<bool(TriangleId)>& in_element = {});

}  // namespace pliant

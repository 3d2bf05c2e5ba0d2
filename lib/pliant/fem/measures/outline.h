// lib/pliant/fem/measures/outline.h: lengths, integrals, fluxes and shapes along the outlines of faces and along
// curves.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/measures/face_measures.h"

namespace pliant {

/// An edge, and how it is passed.
struct OutlineEdge {
  HalfEdgeId half_edge;      ///< on the side from which fields are seen
  bool is_backward = false;  ///< passed from its target to its origin
  double crossing = 1;       ///< flux counts positive from the left to the right of the passage; -1: the other way
};
using Outline = std::vector<OutlineEdge>;

/// The edges around a face, with the face on their left; of every_face those that have nothing on their right. Flux
/// counts what leaves.
Outline outline_of_face(const Mesh& mesh, FaceId face);
/// The edges of some curves, along the curves. Fields are seen from the left, if a face is there. Flux counts what
/// enters the mesh, and through curves between two faces what passes from the left to the right.
Outline outline_of_curves(const Mesh& mesh, std::span<const CurveId> curves);

/// Lengths, and all that follows, are in the document's units. Integrals take two Gauss rules of 21 points on each
/// edge: they are exact to rounding for fluxes of fields, and elsewhere but for edges that nearly stop somewhere.
double measure_length(const Mesh& mesh, const Outline& outline);
/// The mean place of a line of even density.
Point centre_of_line(const Mesh& mesh, const Outline& outline);
/// Throws      InputError where an expression is not finite
double integrate(MeshFunction& function, const Mesh& mesh, const Outline& outline);
double integrate_flux(MeshFunction& along_x, MeshFunction& along_y, const Mesh& mesh, const Outline& outline);
/// The bounds of a field along an outline, to 1e-12 of their difference, or rounding.   Requires    a field
std::optional<Range> bounds(MeshFunction& field, const Mesh& mesh, const Outline& outline);

/// Does the passage leave every vertex as often as it comes there?
bool is_closed(const Mesh& mesh, const Outline& outline);
/// What a closed outline has on its left: negative if it runs clockwise. Exact to rounding.
AreaAndCentre measure_enclosed(const Mesh& mesh, const Outline& outline);

/// The least and the greatest distance of an outline from a place, and where the greatest one is.
struct Reach {
  double least, greatest;
  Point farthest;
};
/// Distances are right to 1e-12 of the greatest one.
/// Requires    a place in the document's units, an outline with edges
Reach measure_reach(const Mesh& mesh, const Outline& outline, const Point& place);

}  // namespace pliant

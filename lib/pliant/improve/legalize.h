// lib/pliant/improve/legalize.h: is an edge locally Delaunay, and flips that make edges so.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

enum class EdgeState {
  delaunay,      ///< locally Delaunay, constrained, or on the outer boundary
  not_delaunay,  ///< its flip is wanted and its four logical triangles are positive
  turned_over,   ///< one of its logical triangles is not positive, and a flip makes both so
  inverted       ///< one of the old or new logical triangles is not positive: not tested
};
constexpr bool wants_flip(EdgeState state) {
  return state == EdgeState::not_delaunay || state == EdgeState::turned_over;
}
/// The state of an edge in the logical mesh, by exact predicates.
EdgeState edge_state(const Mesh& mesh, HalfEdgeId h);
/// The state of an inner edge from a to b that has c on its left and d on its right.
EdgeState edge_state(const Point& a, const Point& b, const Point& c, const Point& d);

/// Makes the bent ones of these inner edges straight, where the elements stay valid; one that its neighbours' bends
/// keep from it is tried again after them. Empties the list; true if it changed any. Bent: a control point is off its
/// straight place by more than a tenth of the edge's length, or three tenths of a height over it.
bool straighten_bent(Mesh& mesh, std::vector<HalfEdgeId>& edges, const RefitOptions& refit);

/// Is an edge that is on no curve bent, in the sense of straighten_bent?
bool is_bent_inside(const Mesh& mesh, HalfEdgeId h);

/// An edge that wanted its flip, named by its vertices: half-edges are others after the next flip.
struct RefusedEdge {
  PointId origin, target;
  Outcome reason;  ///< done: not tried, since as many edges were flipped as asked
};
struct LegalizeCounts {
  long flips = 0;
  std::vector<std::pair<Outcome, long>> refusals;
  bool lists_edges = false;
  std::vector<RefusedEdge> refused_edges;  ///< if they are listed; what happened to one last is last
  void refuse(Outcome reason);
};
/// Flips the edges on the stack, and what their flips disturb, until all are locally Delaunay or refused. Empties the
/// stack. Terminates: a Delaunay flip lowers the lifted volume strictly and leaves positive triangles, a flip of what
/// is turned over lowers the number of triangles that are not positive. `touched`, if given, receives the triangles of
/// every flip. With `straightens`, bent edges are made straight after every flip, and before one that was refused is
/// tried once more: elements far from their logical triangles are what keeps a new mesh from being Delaunay.
void legalize(Mesh& mesh, std::vector<HalfEdgeId>& stack, const RefitOptions& refit, LegalizeCounts& counts,
              long max_flips = -1, std::vector<TriangleId>* touched = nullptr, bool straightens = false);

}  // namespace pliant

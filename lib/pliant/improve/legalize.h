// lib/pliant/improve/legalize.h: tells whether an edge is locally Delaunay, and flips edges until they are.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

enum class EdgeState {
  delaunay,      ///< locally Delaunay, constrained, or on the outer boundary
  not_delaunay,  ///< a flip is wanted, and both old and both new logical triangles are positive
  turned_over,   ///< one of its two logical triangles is not positive, and a flip makes both positive
  inverted       ///< some old or new logical triangle is not positive and no flip mends that; left alone
};
constexpr bool wants_flip(EdgeState state) {
  return state == EdgeState::not_delaunay || state == EdgeState::turned_over;
}
/// The state of an edge in the logical mesh, by exact predicates.
EdgeState edge_state(const Mesh& mesh, HalfEdgeId h);
/// The state of an inner edge from a to b that has c on its left and d on its right.
EdgeState edge_state(const Point& a, const Point& b, const Point& c, const Point& d);

/// Makes those of these edges straight that are bent and on no curve, where the elements stay valid. An edge that the
/// bends of its neighbours keep from being straight is tried again after them. Empties the list; returns true if any
/// edge changed.
///
/// An edge is *bent* if a control point is off its straight place by more than a tenth of the edge's length, or by more
/// than three tenths of the height of a triangle over the edge.
bool straighten_bent(Mesh& mesh, std::vector<HalfEdgeId>& edges, const RefitOptions& refit);

/// True if an edge is on no curve and bent, in the sense of straighten_bent.
bool is_bent_inside(const Mesh& mesh, HalfEdgeId h);

/// An edge that wanted a flip and did not get it. Its vertices name it, since its half-edge may belong to another edge
/// after the next flip.
struct RefusedEdge {
  PointId origin, target;
  Outcome reason;  ///< `done`: the flip was not tried, since as many edges were flipped as allowed
};
struct LegalizeCounts {
  long flips = 0;
  std::vector<std::pair<Outcome, long>> refusals;
  bool lists_edges = false;
  std::vector<RefusedEdge> refused_edges;  ///< filled if lists_edges; of entries for one edge the last tells its state
  void refuse(Outcome reason);
};
/// Flips the edges on the stack, and the edges that these flips disturb, until all are locally Delaunay or refused.
/// Empties the stack. It terminates: a Delaunay flip lowers the lifted volume strictly and leaves positive triangles; a
/// flip of a triangle that is turned over lowers the number of triangles that are not positive.
///
/// `touched`, if given, receives the triangles of every flip. With `straightens`, bent edges are made straight after
/// every flip, and a flip that was refused is tried once more after the bent edges around it are straightened: elements
/// far from their logical triangles are what keeps a new mesh from being Delaunay. `max_flips`: negative for no limit.
void legalize(Mesh& mesh, std::vector<HalfEdgeId>& stack, const RefitOptions& refit, LegalizeCounts& counts,
              long max_flips = -1, std::vector<TriangleId>* touched = nullptr, bool straightens = false);

}  // namespace pliant

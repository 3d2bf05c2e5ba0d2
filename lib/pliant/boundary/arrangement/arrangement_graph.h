// lib/pliant/boundary/arrangement/arrangement_graph.h: the planar graph of arcs, its regions and their winding numbers.
#pragma once
#include <functional>

#include "pliant/boundary/arrangement/arrangement_arcs.h"

namespace pliant {

/// An arc that lies on no other, with what it separates.
struct GraphEdge {
  int arc;
  Winding jump;  ///< of all arcs that run together here, in the direction of `arc`
  int left = outside, right = outside;
};

struct ArrangementGraph {
  std::vector<GraphEdge> edges;  ///< ascending by arc
  std::vector<int> edge_of;      ///< of each arc; -1: none, or merged with another
  long crowded_nodes = 0;        ///< with more than two edges
  long regions = 0;
  long slivers = 0;
  double sliver_area = 0;   ///< at most, of all of them
  std::vector<int> broken;  ///< nodes about which the graph is not planar or not consistent; empty if all is well
};

/// Merges arcs that run together, sorts them around their nodes, traces the regions, and asks `owner` for the face that
/// each belongs to, by its winding numbers.   Complexity O((arcs + pairs of overlapping boxes) log n)
ArrangementGraph build_graph(const ArcNetwork& network, std::span<const SidedCurve> curves,
                             const ArcTolerances& tolerances, const std::function<int(const Winding&)>& owner);

}  // namespace pliant

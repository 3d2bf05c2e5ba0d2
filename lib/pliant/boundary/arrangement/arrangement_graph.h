// lib/pliant/boundary/arrangement/arrangement_graph.h: the planar graph of arcs, its regions and their winding numbers.
#pragma once
#include <functional>

#include "pliant/boundary/arrangement/arrangement_arcs.h"

namespace pliant {

/// An arc that stands for all arcs that run together with it, and what it separates.
struct GraphEdge {
  int arc;
  Winding jump;                         ///< the sum over all arcs that run together here, in the direction of `arc`
  int left = outside, right = outside;  ///< faces
  std::vector<int> lines{};             ///< the drawn lines that run here
  bool is_drawn = false;                ///< is one of them seen?

  bool is_kept() const { return left != right || is_drawn; }
};

/// What the regions of the plane mean.
struct RegionMeaning {
  std::function<int(const Winding&)> owner;  ///< the face to which points with these winding numbers belong
  /// Is the line seen where these are the winding numbers on one of its sides, and this their owner?
  std::function<bool(int line, const Winding&, int owner)> shows;
};

struct ArrangementGraph {
  std::vector<GraphEdge> edges;  ///< ascending by arc
  std::vector<int> edge_of;      ///< the edge of each arc; -1 if it has none or is merged with another arc
  long crowded_nodes = 0;        ///< nodes with more than two edges
  long regions = 0;              ///< bounded regions
  long slivers = 0;              ///< edges that were merged although they were not within the tolerance
  long bare_lines = 0;           ///< edges that are seen lines without a face on either side
  double sliver_area = 0;        ///< a bound of the area between those
  std::vector<int> broken;       ///< nodes where the graph is not planar or not consistent; empty if all is well
};

/// Merges arcs that run together, sorts them around their nodes, traces the regions, and asks to which face the winding
/// numbers of each region belong.   Complexity O((arcs + pairs of overlapping boxes) log n)
ArrangementGraph build_graph(const ArcNetwork& network, std::span<const SidedCurve> curves,
                             const ArcTolerances& tolerances, const RegionMeaning& meaning);

}  // namespace pliant

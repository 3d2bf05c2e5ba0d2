// lib/pliant/boundary/arrangement/arrangement_merge.h: arcs that run together become one edge.
#pragma once
#include <span>

#include "pliant/boundary/arrangement/arrangement_graph.h"

namespace pliant {

/// Sets the edges of the graph and what they separate. Arcs with the same ends that run together make one edge. Chains
/// of edges that run beside each other, between nodes that do not have exactly two edges, make one chain. Edges that
/// separate nothing are dropped. The slivers between what was merged are counted.
void merge_arcs(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArcTolerances& tolerances,
                ArrangementGraph& graph);

}  // namespace pliant

// lib/pliant/boundary/arrangement/arrangement_merge.h: arcs that run together become one edge.
#pragma once
#include <span>

#include "pliant/boundary/arrangement/arrangement_graph.h"

namespace pliant {

/// Sets the edges of the graph: one for all arcs with the same ends that run together, and for all chains of arcs that
/// run beside each other between nodes where more than two edges end; with what they separate in all. Edges that
/// separate nothing are dropped. Counts the slivers between what was merged.
void merge_arcs(const ArcNetwork& network, std::span<const SidedCurve> curves, const ArcTolerances& tolerances,
                ArrangementGraph& graph);

}  // namespace pliant

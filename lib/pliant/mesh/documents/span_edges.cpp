// lib/pliant/mesh/documents/span_edges.cpp: the constrained edges of a mesh in the order of its document.
#include "pliant/mesh/documents/span_edges.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Sorts by curve and span. Each span has one edge, so every edge knows its place; should a mesh have it otherwise, it
/// is sorted by comparing.
void sort_spans(std::vector<SpanEdge>& edges, const std::vector<std::vector<double>>& breaks) {
  std::vector<std::size_t> first(breaks.size() + 1, 0);  // by curve: the place of its span 0
  for (std::size_t c = 0; c < breaks.size(); ++c)
    first[c + 1] = first[c] + (breaks[c].empty() ? 0 : breaks[c].size() - 1);
  std::vector<SpanEdge> sorted(first.back());
  bool is_each_alone = edges.size() == sorted.size();
  for (std::size_t k = 0; k < edges.size() && is_each_alone; ++k) {
    SpanEdge& place = sorted[first[index(edges[k].curve)] + index(edges[k].number)];
    is_each_alone = place.curve == none;
    place = edges[k];
  }
  if (is_each_alone)
    edges = std::move(sorted);
  else
    std::sort(edges.begin(), edges.end(), [](const SpanEdge& a, const SpanEdge& b) {
      return std::pair{a.curve, a.number} < std::pair{b.curve, b.number};
    });
}

}  // namespace

std::vector<SpanEdge> span_edges(const Mesh& mesh) {
  std::vector<SpanEdge> edges;
  std::vector<std::vector<double>> breaks(mesh.boundary().curves.size());
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_constrained(h) || !mesh.is_alive(triangle_of(h))) continue;
    const bool is_forward = mesh.runs_forward(h);
    if (!is_forward && mesh.twin(h) != none) continue;  // its twin is listed
    const ConstraintId c = mesh.constraint(h);
    const CurveId curve = mesh.constraint_curve(c);
    std::vector<double>& starts = breaks[index(curve)];
    if (starts.empty()) starts = mesh.spline(curve).breaks();
    const auto start = std::lower_bound(starts.begin(), starts.end(), mesh.constraint_start(c));
    assert(start != starts.end());
    edges.push_back({curve, static_cast<int>(start - starts.begin()), *start, h, is_forward});
  }
  sort_spans(edges, breaks);
  return edges;
}

}  // namespace pliant

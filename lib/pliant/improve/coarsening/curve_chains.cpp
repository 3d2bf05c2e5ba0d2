// lib/pliant/improve/coarsening/curve_chains.cpp: collects the spans of each curve and sorts them.
#include "pliant/improve/coarsening/curve_chains.h"

#include <algorithm>
#include <utility>

namespace pliant {

std::vector<CurveChain> curve_chains(const Mesh& mesh) {
  struct Span {
    double start;
    PointId first, last;
  };
  std::vector<std::vector<Span>> spans(mesh.boundary().curves.size());
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h) || mesh.twin(h) > h) continue;  // each edge once
    const ConstraintId c = mesh.constraint(h);
    const bool forward = mesh.runs_forward(h);
    spans[static_cast<std::size_t>(mesh.constraint_curve(c))].push_back({mesh.constraint_start(c),
                                                                         forward ? mesh.origin(h) : mesh.target(h),
                                                                         forward ? mesh.target(h) : mesh.origin(h)});
  }
  std::vector<CurveChain> chains(spans.size());
  for (std::size_t k = 0; k < spans.size(); ++k) {
    if (spans[k].empty()) continue;
    std::sort(spans[k].begin(), spans[k].end(), [](const Span& a, const Span& b) { return a.start < b.start; });
    CurveChain& chain = chains[k];
    const BSpline& spline = mesh.boundary().curves[k].spline;
    chain.closed = spline.closed();
    for (const Span& span : spans[k]) {
      chain.breaks.push_back(span.start);
      chain.vertices.push_back(span.first);
    }
    if (chain.closed) continue;
    chain.breaks.push_back(spline.last_parameter());
    chain.vertices.push_back(spans[k].back().last);
  }
  return chains;
}

}  // namespace pliant

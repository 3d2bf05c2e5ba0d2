// lib/pliant/ops/smooth_edge.cpp: new places for the inner control points of an edge or element (paper §5.2.4).
#include "pliant/ops/smooth_edge.h"

#include <array>

#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

/// Of each thread one, for its memory.
TrialPatch& captured(const Mesh& mesh, std::span<const TriangleId> elements) {
  thread_local TrialPatch trial;
  trial.capture(mesh, elements);
  return trial;
}

Refusal place(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points, SmoothGoal goal,
              const RefitOptions& options) {
  if (points.empty()) return Refusal::not_removable;
  TrialPatch& trial = captured(mesh, elements);
  if (!trial.place(points, goal)) return Refusal::would_invert;
  return trial.apply(mesh, options, all_valid(mesh, elements));
}

Refusal refusal_of(const Mesh& mesh, HalfEdgeId h) {
  if (mesh.is_constrained(h)) return Refusal::constrained;
  return mesh.twin(h) == none ? Refusal::outer_boundary : Refusal::done;
}

}  // namespace

Refusal smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options) {
  if (const Refusal refusal = refusal_of(mesh, h); refusal != Refusal::done) return refusal;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh.twin(h))};
  const EdgePoints edge = side_of(mesh, h).points;
  return place(mesh, pair, {edge.ids.data() + 1, static_cast<std::size_t>(mesh.degree() - 1)}, goal, options);
}

Refusal smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options) {
  const std::array<TriangleId, 1> one{t};
  const InnerPoints inner = inner_points(mesh, t);
  return place(mesh, one, {inner.data(), static_cast<std::size_t>(interior_size(mesh.degree()))}, goal, options);
}

Refusal straighten_edge(Mesh& mesh, HalfEdgeId h, double keep, const RefitOptions& options) {
  if (const Refusal refusal = refusal_of(mesh, h); refusal != Refusal::done) return refusal;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh.twin(h))};
  TrialPatch& trial = captured(mesh, pair);
  trial.straighten(mesh, h, keep);
  return trial.apply(mesh, options, true);
}

Refusal blend_interior(Mesh& mesh, TriangleId t, const RefitOptions& options) {
  if (mesh.degree() <= 2) return Refusal::not_removable;
  const std::array<TriangleId, 1> one{t};
  TrialPatch& trial = captured(mesh, one);
  trial.blend(mesh, t);
  return trial.apply(mesh, options, true);
}

}  // namespace pliant

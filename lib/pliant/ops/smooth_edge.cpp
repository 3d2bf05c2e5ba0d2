// lib/pliant/ops/smooth_edge.cpp: moves tried on a TrialPatch, then applied to the mesh (paper §5.2.4).
#include "pliant/ops/smooth_edge.h"

#include <array>

#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

/// A patch that holds copies of the elements. There is one per thread, so that its memory is reused.
TrialPatch& captured(const Mesh& mesh, std::span<const TriangleId> elements) {
  thread_local TrialPatch trial;
  trial.capture(mesh, elements);
  return trial;
}

Outcome place(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points, SmoothGoal goal,
              const RefitOptions& options) {
  if (points.empty()) return Outcome::not_removable;
  TrialPatch& trial = captured(mesh, elements);
  if (!trial.place(points, goal)) return Outcome::would_invert;
  return trial.apply(mesh, options, all_valid(mesh, elements));
}

/// Why the points inside an edge may not move; `done` if they may.
Outcome refusal_of(const Mesh& mesh, HalfEdgeId h) {
  if (mesh.is_constrained(h)) return Outcome::constrained;
  return mesh.twin(h) == none ? Outcome::outer_boundary : Outcome::done;
}

}  // namespace

Outcome smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options) {
  if (const Outcome outcome = refusal_of(mesh, h); outcome != Outcome::done) return outcome;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh.twin(h))};
  const EdgePoints edge = side_of(mesh, h).points;
  return place(mesh, pair, {edge.ids.data() + 1, static_cast<std::size_t>(mesh.degree() - 1)}, goal, options);
}

Outcome smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options) {
  const std::array<TriangleId, 1> one{t};
  const InnerPoints inner = inner_points(mesh, t);
  return place(mesh, one, {inner.data(), static_cast<std::size_t>(interior_size(mesh.degree()))}, goal, options);
}

Outcome straighten_edge(Mesh& mesh, HalfEdgeId h, double keep, const RefitOptions& options) {
  if (const Outcome outcome = refusal_of(mesh, h); outcome != Outcome::done) return outcome;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh.twin(h))};
  TrialPatch& trial = captured(mesh, pair);
  trial.straighten(mesh, h, keep);
  return trial.apply(mesh, options, true);
}

Outcome blend_interior(Mesh& mesh, TriangleId t, const RefitOptions& options) {
  if (mesh.degree() <= 2) return Outcome::not_removable;
  const std::array<TriangleId, 1> one{t};
  TrialPatch& trial = captured(mesh, one);
  trial.blend(mesh, t);
  return trial.apply(mesh, options, true);
}

}  // namespace pliant

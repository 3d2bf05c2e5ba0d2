// lib/pliant/improve/legalize.cpp: the exact state of an edge; flips, with bent edges straightened before and after.
#include "pliant/improve/legalize.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/predicates.h"
#include "pliant/improve/edge_bend.h"
#include "pliant/improve/smoothing/straighten_together.h"
#include "pliant/ops/flip_edge.h"
#include "pliant/ops/smooth_edge.h"

namespace pliant {
namespace {

/// How far control points may be off their straight places: in lengths of the edge, and in heights of the triangles
/// beside it. An edge is bent beyond either.
struct BendBound {
  double in_lengths, in_heights;
};
constexpr BendBound mild{0.1, 0.3}, bad{0.3, 0.9};

bool is_bent(const Mesh& mesh, HalfEdgeId h, const BendBound& bound = mild) {
  const Point& a = mesh.point(mesh.origin(h));
  const Vector along = mesh.point(mesh.target(h)) - a;
  const double off = squared_bend(mesh, h), length = squared_length(along);  // both squared
  if (off > bound.in_lengths * bound.in_lengths * length) return true;
  const auto exceeds_height = [&](HalfEdgeId side) {
    const double twice_area = cross(along, mesh.point(mesh.apex(side)) - a);
    return off * length > bound.in_heights * bound.in_heights * twice_area * twice_area;
  };
  return exceeds_height(h) || exceeds_height(mesh.twin(h));
}

/// Do both triangles surely turn the right way, and do the angles opposite the edge surely sum up to less than 180
/// degrees, so that the sine of the sum is positive? It takes a fraction of what the exact predicates take, and nearly
/// all edges are far from all limits.
bool is_surely_delaunay(const Point& a, const Point& b, const Point& c, const Point& d) {
  constexpr double margin = 1e-14;                  // of a sum of products: many times its rounding error
  constexpr double floor = 1e-280, ceiling = 1e30;  // between them underflow does not matter
  const Vector ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double c1 = ca.x * cb.y, c2 = ca.y * cb.x, c3 = ca.x * cb.x, c4 = ca.y * cb.y;
  const double d1 = db.x * da.y, d2 = db.y * da.x, d3 = db.x * da.x, d4 = db.y * da.y;
  const double above = c1 - c2, below = d1 - d2;
  const double crosses_c = std::fabs(c1) + std::fabs(c2), dots_c = std::fabs(c3) + std::fabs(c4);
  const double crosses_d = std::fabs(d1) + std::fabs(d2), dots_d = std::fabs(d3) + std::fabs(d4);
  const double sine = above * (d3 + d4) + below * (c3 + c4);
  return above > margin * crosses_c + floor && below > margin * crosses_d + floor &&
         sine > margin * (crosses_c * dots_d + crosses_d * dots_c) + floor && dots_c + dots_d < ceiling;
}

bool is_mildly_bent(const Mesh& mesh, HalfEdgeId h) { return is_bent(mesh, h); }

/// Straightens the bent edges of both triangles at h; false if nothing changed.
bool straighten_around(Mesh& mesh, HalfEdgeId h, const RefitOptions& refit) {
  const HalfEdgeId g = mesh.twin(h);
  thread_local std::vector<HalfEdgeId> edges;
  edges.assign({h, next(h), previous(h), next(g), previous(g)});
  return straighten_bent(mesh, edges, refit);
}

/// Flips an edge, and refuses where the new one would be badly bent and the old one was not. Where the elements leave
/// little room the only valid places of its control points may be far outside, and bends beget bends.
Outcome flip_straight(Mesh& mesh, HalfEdgeId h, const RefitOptions& refit) {
  Transaction transaction(mesh);
  const bool was_bad = is_bent(mesh, h, bad);
  const Outcome outcome = flip_edge(mesh, h, refit);
  if (outcome != Outcome::done) return outcome;
  if (is_bent(mesh, h)) {
    straighten_around(mesh, h, refit);
    if (!was_bad && is_bent(mesh, h, bad)) return Outcome::would_bend;
  }
  transaction.commit();
  return Outcome::done;
}

/// Flips an edge, if need be after the bent edges of both triangles are straightened. The mesh is unchanged if the flip
/// is refused.
Outcome straighten_and_flip(Mesh& mesh, HalfEdgeId h, const RefitOptions& refit) {
  const Outcome first = flip_straight(mesh, h, refit);
  if (first == Outcome::done) return first;
  Transaction transaction(mesh);
  if (!straighten_around(mesh, h, refit)) return first;
  const Outcome outcome = flip_straight(mesh, h, refit);
  if (outcome == Outcome::done) transaction.commit();
  return outcome;
}

}  // namespace

bool is_bent_inside(const Mesh& mesh, HalfEdgeId h) {
  return mesh.twin(h) != none && !mesh.is_constrained(h) && is_bent(mesh, h);
}

bool straighten_bent(Mesh& mesh, std::vector<HalfEdgeId>& edges, const RefitOptions& refit) {
  std::erase_if(edges,
                [&](HalfEdgeId h) { return mesh.is_constrained(h) || mesh.twin(h) == none || !is_bent(mesh, h); });
  const std::size_t bent = edges.size();
  for (std::size_t before = bent + 1; !edges.empty() && edges.size() < before;) {
    before = edges.size();
    std::erase_if(edges, [&](HalfEdgeId h) { return straighten_edge(mesh, h, 0, refit) == Outcome::done; });
  }
  bool any = edges.size() < bent;
  for (const HalfEdgeId h : edges)  // the rest are usually in each other's way: straightened at once or not at all
    if (is_bent(mesh, h, bad)) {
      if (!straighten_together(mesh, h, is_mildly_bent, refit)) break;
      any = true;
    }
  edges.clear();
  return any;
}

EdgeState edge_state(const Mesh& mesh, HalfEdgeId h) {
  const HalfEdgeId g = mesh.twin(h);
  if (g == none || mesh.is_constrained(h)) return EdgeState::delaunay;
  return edge_state(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                    mesh.point(mesh.apex(g)));
}

EdgeState edge_state(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (is_surely_delaunay(a, b, c, d)) return EdgeState::delaunay;
  const int above = orient2d(a, b, c), below = orient2d(b, a, d);
  const auto flips_to_positive = [&] { return orient2d(a, d, c) > 0 && orient2d(d, b, c) > 0; };
  if (above <= 0 || below <= 0)
    return (above > 0 || below > 0) && flips_to_positive() ? EdgeState::turned_over : EdgeState::inverted;
  if (in_circle(a, b, c, d) <= 0) return EdgeState::delaunay;
  // If d lies inside the circle, the quadrilateral is convex, so a flip is possible; the test guards the flat cases.
  return flips_to_positive() ? EdgeState::not_delaunay : EdgeState::inverted;
}

void LegalizeCounts::refuse(Outcome reason) {
  for (auto& [known, count] : refusals)
    if (known == reason) {
      ++count;
      return;
    }
  refusals.emplace_back(reason, 1);
}

void legalize(Mesh& mesh, std::vector<HalfEdgeId>& stack, const RefitOptions& refit, LegalizeCounts& counts,
              long max_flips, std::vector<TriangleId>* touched, bool straightens) {
  while (!stack.empty()) {
    const HalfEdgeId h = stack.back();
    stack.pop_back();
    if (!mesh.is_alive(triangle_of(h)) || !wants_flip(edge_state(mesh, h))) continue;
    const auto list = [&](Outcome reason) {
      if (counts.lists_edges) counts.refused_edges.push_back({mesh.origin(h), mesh.target(h), reason});
    };
    if (max_flips >= 0 && counts.flips >= max_flips) {
      list(Outcome::done);
      continue;
    }
    const Outcome outcome = straightens ? straighten_and_flip(mesh, h, refit) : flip_edge(mesh, h, refit);
    if (outcome != Outcome::done) {
      counts.refuse(outcome);
      list(outcome);
      continue;
    }
    ++counts.flips;
    const HalfEdgeId g = mesh.twin(h);
    for (const HalfEdgeId outer : {next(h), previous(h), next(g), previous(g)}) stack.push_back(outer);
    if (touched) {
      touched->push_back(triangle_of(h));
      touched->push_back(triangle_of(g));
    }
  }
}

}  // namespace pliant

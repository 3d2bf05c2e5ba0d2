// lib/pliant/improve/thin_gaps.cpp: compares an edge with the spans that end where it does.
#include "pliant/improve/thin_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pliant/improve/refining/quick_goals.h"
#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/mesh/star.h"

namespace pliant {
namespace {

constexpr double most_share = 0.25;  // a gap is thin if its width is less than this share of a span's chord

double squared(const Mesh& mesh, HalfEdgeId h) {
  return squared_length(mesh.point(mesh.target(h)) - mesh.point(mesh.origin(h)));
}

/// The longest span that ends at v, squared; 0 where v is on no curve.
double longest_span(const Mesh& mesh, PointId v) {
  thread_local Star star;  // one per thread, so that its memory is reused
  find_star(mesh, v, star);
  double longest = 0;
  for (const HalfEdgeId h : star.outgoing)
    for (const HalfEdgeId side : {h, previous(h)})
      if (mesh.is_constrained(side)) longest = std::max(longest, squared(mesh, side));
  return longest;
}

}  // namespace

bool crosses_thin_gap(const Mesh& mesh, HalfEdgeId h) {
  if (mesh.is_constrained(h) || mesh.twin(h) == none) return false;
  const double length = squared(mesh, h), least = most_share * most_share;
  return length < least * longest_span(mesh, mesh.origin(h)) && length < least * longest_span(mesh, mesh.target(h));
}

ThinGaps find_thin_gaps(const Mesh& mesh, const QualityGoals& goals) {
  ThinGaps gaps;
  const QuickGoals quick(mesh, goals);
  std::optional<SharpCorners> corners;  // found when first asked for
  double most = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t) || !quick.attack_on(t).is_poor) continue;
    const HalfEdgeId shortest = shortest_edge(mesh, t);
    const double longest = std::sqrt(std::max(squared(mesh, next(shortest)), squared(mesh, previous(shortest))));
    if (!crosses_thin_gap(mesh, shortest)) continue;
    if (!corners) corners.emplace(mesh);
    if (corners->excuses(mesh, shortest, longest)) continue;
    const double widths = longest / std::sqrt(squared(mesh, shortest));
    gaps.triangles += widths;
    if (widths <= most) continue;
    most = widths;
    gaps.thinnest = (mesh.point(mesh.origin(shortest)) + mesh.point(mesh.target(shortest))) / 2;
  }
  return gaps;
}

}  // namespace pliant

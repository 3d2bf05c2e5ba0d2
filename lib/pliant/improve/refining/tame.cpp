// lib/pliant/improve/refining/tame.cpp: levels of straightening, flips and cuts; reference triangles of the pieces.
#include "pliant/improve/refining/tame.h"

#include <algorithm>
#include <cmath>

#include "pliant/improve/edge_bend.h"
#include "pliant/improve/refining/refine_attack.h"
#include "pliant/mesh/star.h"
#include "pliant/mesh/turned_over.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

constexpr int most_levels = 60;        // levels of cuts: each halves the area of the pieces that are left
constexpr int most_neighbours = 100;   // neighbours that may be cut before an element is
constexpr double equal_length = 1e-6;  // reference lengths that differ by less are the same up to rounding
constexpr double much_turning = 0.35;  // radians: an edge on a curve that turns by more may keep flips from being made
constexpr double least_edge = 16;      // edges shorter than so many tolerances of the mesh are not cut

Barycentric middle_of(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The distance of two places in an equilateral triangle with unit sides.
double distance_between(const Barycentric& a, const Barycentric& b) {
  const double u = a[0] - b[0], v = a[1] - b[1], w = a[2] - b[2];
  return std::sqrt((u * u + v * v + w * w) / 2);
}

/// The bend of an edge in lengths of its chord, squared.
double relative_bend(const Mesh& mesh, HalfEdgeId h) {
  return squared_bend(mesh, h) / squared_length(mesh.point(mesh.target(h)) - mesh.point(mesh.origin(h)));
}

}  // namespace

TameCounts Tamer::tame(std::vector<TriangleId> seeds, long max_triangles) {
  counts_ = {};
  std::vector<TriangleId> wild;
  for (int level = 0; level < most_levels && !seeds.empty(); ++level) {
    changed_.clear();
    refused_.clear();
    straighten_and_flip(seeds);
    for (const TriangleId t : seeds)
      if (is_wild(t)) changed_.push_back(t);
    bool is_cut = false;
    for (const TriangleId t : seeds)
      if (is_wild(t) && mesh_.triangle_count() < max_triangles) is_cut = cut(t) || is_cut;
    for (const RefusedEdge& edge : refused_)
      if (mesh_.triangle_count() < max_triangles) is_cut = unbend_beside(edge) || is_cut;
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    wild.clear();
    for (const TriangleId t : changed_)
      if (is_wild(t)) wild.push_back(t);
    if (!is_cut) break;
    seeds = changed_;
  }
  counts_.left = static_cast<long>(wild.size());
  return counts_;
}

/// Splits what may have caused the refusal of an edge's flip: a curve beside it that bends much, or else elements
/// beside it with bent inner edges that could not be straightened. The halves and pieces bend less.
bool Tamer::unbend_beside(const RefusedEdge& edge) {
  const HalfEdgeId h = find_half_edge(mesh_, edge.origin, edge.target);
  if (h == none || !wants_flip(edge_state(mesh_, h))) return false;
  const HalfEdgeId g = mesh_.twin(h);
  if (is_in_wedge(triangle_of(h)) || is_in_wedge(triangle_of(g))) return false;
  HalfEdgeId most = none;
  double turning = much_turning;
  for (const HalfEdgeId side : {next(h), previous(h), next(g), previous(g)})
    if (mesh_.is_constrained(side))
      if (const double turns = edge_turning(mesh_, side); turns > turning) turning = turns, most = side;
  if (most != none) return split(most);
  bool is_cut = false;
  for (const HalfEdgeId side : {h, g}) {
    const TriangleId t = triangle_of(side);
    bool has_bend = false;
    for (int e = 0; e < 3; ++e) has_bend = has_bend || is_bent_inside(mesh_, half_edge(t, e));
    is_cut = (has_bend && cut(t)) || is_cut;
    if (is_cut) break;  // the cut may have replaced the other element
  }
  return is_cut;
}

bool Tamer::is_wild(TriangleId t) const { return mesh_.is_alive(t) && is_turned_over(mesh_, t) && !is_in_wedge(t); }

bool Tamer::is_in_wedge(TriangleId t) const {
  if (corners_.empty()) return false;
  for (int c = 0; c < 3; ++c)
    if (corners_.narrow_wedge(mesh_, mesh_.corner(t, c), mesh_.corner(t, (c + 1) % 3), mesh_.face(t)) != none)
      return true;
  return false;
}

/// Straightens the bent edges of these elements and their neighbours, then flips edges; both may change further
/// elements.
void Tamer::straighten_and_flip(const std::vector<TriangleId>& seeds) {
  std::vector<HalfEdgeId> edges, stack;
  for (const TriangleId t : seeds)
    for (int e = 0; e < 3; ++e) {
      if (!mesh_.is_alive(t)) continue;
      const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
      stack.push_back(h);
      if (!is_wild(t)) continue;
      edges.push_back(h);
      if (g == none) continue;
      edges.push_back(next(g));
      edges.push_back(previous(g));
    }
  straighten_bent(mesh_, edges, refit_);
  LegalizeCounts counts;
  counts.lists_edges = true;
  legalize(mesh_, stack, refit_, counts, -1, &changed_, true);
  flips_.flips += counts.flips;
  refused_ = std::move(counts.refused_edges);
}

Tamer::Piece& Tamer::piece(TriangleId t) {
  const Corners corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
  Piece& found = pieces_[t];
  if (found.corners != corners) found = {corners, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  return found;
}

double Tamer::reference_length(HalfEdgeId h) {
  const Piece& own = piece(triangle_of(h));
  return distance_between(own.places[static_cast<std::size_t>(edge_of(h))],
                          own.places[static_cast<std::size_t>(edge_of(next(h)))]);
}

HalfEdgeId Tamer::edge_to_cut(TriangleId t) {
  HalfEdgeId best = half_edge(t, 0);
  for (int e = 1; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    const double length = reference_length(h), longest = reference_length(best);
    if (length > longest * (1 + equal_length) ||
        (length > longest * (1 - equal_length) && relative_bend(mesh_, h) > relative_bend(mesh_, best)))
      best = h;
  }
  return best;
}

bool Tamer::cut(TriangleId t) {
  for (int k = 0; k < most_neighbours; ++k) {
    HalfEdgeId h = edge_to_cut(t);
    for (HalfEdgeId g = mesh_.twin(h); g != none; g = mesh_.twin(h)) {  // to a neighbour with a longer edge, and on
      const HalfEdgeId other = edge_to_cut(triangle_of(g));
      if (reference_length(other) <= reference_length(g) * (1 + equal_length)) break;
      h = other;
    }
    const bool is_own = triangle_of(h) == t || (mesh_.twin(h) != none && triangle_of(mesh_.twin(h)) == t);
    if (!split(h)) return false;
    if (is_own) return true;
  }
  return false;
}

bool Tamer::split(HalfEdgeId h) {
  const Point &a = mesh_.point(mesh_.origin(h)), &b = mesh_.point(mesh_.target(h));
  if (distance(a, b) <= least_edge * mesh_.tolerance()) return false;
  const bool on_curve = mesh_.is_constrained(h);
  const PointId first = mesh_.origin(h), last = mesh_.target(h);
  std::array<std::pair<HalfEdgeId, Piece>, 2> before;
  int sides = 0;
  for (const HalfEdgeId g : {h, mesh_.twin(h)})
    if (g != none) before[static_cast<std::size_t>(sides++)] = {g, piece(triangle_of(g))};
  const InsertResult made = split_edge(mesh_, h, 0.5);
  if (made.outcome != Outcome::done) return false;
  ++(on_curve ? counts_.curve_splits : counts_.splits);
  if (on_curve) corners_.add_between(made.vertex, first, last);
  Star star;
  find_star(mesh_, made.vertex, star);
  for (const HalfEdgeId out : star.outgoing) {
    const TriangleId t = triangle_of(out);
    changed_.push_back(t);
    const Corners corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    // A new triangle is a part of the old element that has both its other corners.
    for (int k = 0; k < sides; ++k) {
      const auto& [g, whole] = before[static_cast<std::size_t>(k)];
      Piece part{corners, {}};
      bool is_part = true;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto e = static_cast<std::size_t>(edge_of(g));
        const auto at = std::find(whole.corners.begin(), whole.corners.end(), corners[c]) - whole.corners.begin();
        if (corners[c] == made.vertex)
          part.places[c] = middle_of(whole.places[e], whole.places[(e + 1) % 3]);
        else if (at < 3)
          part.places[c] = whole.places[static_cast<std::size_t>(at)];
        else
          is_part = false;
      }
      if (is_part) pieces_[t] = part;
    }
  }
  return true;
}

}  // namespace pliant

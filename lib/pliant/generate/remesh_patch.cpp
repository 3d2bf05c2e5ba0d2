// lib/pliant/generate/remesh_patch.cpp: meshes a region by itself, and puts the new elements in its place.
#include "pliant/generate/remesh_patch.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/generate/patch_fields.h"
#include "pliant/generate/patch_region.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

bool is_in_order(const BoundaryComplex& complex) {
  return check_boundary(complex).empty() && check_boundary_geometry(complex).empty() &&
         check_boundary_sides(complex).empty();
}

/// One attempt to replace the elements of a region by those of `piece`, a mesh of the region's boundary.
///
/// Requires    a transaction of the caller, who rolls it back where run() returns false
class Replacement {
 public:
  Replacement(Mesh& mesh, PatchRegion& region, const RegionBoundary& boundary, const Mesh& piece)
      : mesh_(mesh), region_(region), boundary_(boundary), piece_(piece) {}

  bool run(const RefitOptions& refit) {
    if (!split_border()) return false;
    number_vertices();
    if (joins_twice()) return false;
    fields_.capture(mesh_, region_.triangles());
    take_border();
    face_ = mesh_.face(region_.triangles().front());
    remove();
    build();
    if (!all_valid(mesh_, now_)) return false;
    std::sort(free_.begin(), free_.end());
    fields_.put(mesh_, now_, free_, refit);
    return true;
  }
  long count() const { return static_cast<long>(now_.size()); }
  long edges_split() const { return edges_split_; }

 private:
  /// A piece of an edge on the border: its points and what lies beyond it (`side`), and the new half-edges that run
  /// along it and against it.
  struct BorderPiece {
    Side side;
    HalfEdgeId along = none, against = none;
  };
  bool split_border();
  bool split(const BorderEdge& edge, std::span<const double> breaks, std::vector<PointId>& vertices);
  bool joins_twice() const;
  bool stays(PointId a, PointId b) const;
  void take_border();
  void remove();
  void build();
  void number_vertices();
  std::pair<std::size_t, std::size_t> span_of(HalfEdgeId h) const;
  BorderPiece& piece_at(HalfEdgeId h);

  Mesh& mesh_;
  PatchRegion& region_;
  const RegionBoundary& boundary_;
  const Mesh& piece_;
  PatchFields fields_;
  FaceId face_ = none;
  long edges_split_ = 0;
  std::vector<std::vector<double>> breaks_;     // the breaks of each curve of the piece
  std::vector<std::vector<PointId>> vertices_;  // the vertices of the mesh at these breaks
  std::vector<std::size_t> first_piece_;        // for each curve the index of its first piece in border_
  std::vector<BorderPiece> border_;
  std::vector<PointId> points_;  // the point of the mesh for each point of the piece
  std::vector<TriangleId> now_;
  std::vector<PointId> free_;
};

/// Splits the edges of the border where the generator has inserted knots.
bool Replacement::split_border() {
  for (std::size_t i = 0; i < boundary_.border.size(); ++i) {
    breaks_.push_back(piece_.spline(static_cast<CurveId>(i)).breaks());
    vertices_.emplace_back();
    if (!split(boundary_.border[i], breaks_.back(), vertices_.back())) return false;
  }
  return true;
}

bool Replacement::split(const BorderEdge& edge, std::span<const double> breaks, std::vector<PointId>& vertices) {
  vertices.push_back(edge.from);
  for (std::size_t k = 1; k + 1 < breaks.size(); ++k) {
    const HalfEdgeId h = find_half_edge(mesh_, vertices.back(), edge.to);
    if (h == none) return false;
    const double s = (breaks[k] - breaks[k - 1]) / (breaks.back() - breaks[k - 1]);
    const InsertResult made = split_edge(mesh_, h, s, SplitCheck::stays_valid);
    if (made.outcome != Outcome::done) return false;
    for (const HalfEdgeId half :
         {find_half_edge(mesh_, vertices.back(), made.vertex), find_half_edge(mesh_, made.vertex, edge.to)}) {
      region_.add(triangle_of(half));
      if (edge.is_slit) region_.add(triangle_of(mesh_.twin(half)));
    }
    vertices.push_back(made.vertex);
    ++edges_split_;
  }
  vertices.push_back(edge.to);
  return true;
}

/// Finds the vertices of the mesh for those of the piece that lie on the border or alone; the others are new (`none`).
void Replacement::number_vertices() {
  points_.assign(index(piece_.point_slots()), none);
  for (const LoneVertex& lone : piece_.lone_vertices())
    if (lone.point != none) points_[index(lone.point)] = boundary_.vertices[index(lone.vertex)];
  for (const HalfEdgeId h : piece_.half_edges()) {
    if (!piece_.is_constrained(h)) continue;
    const auto [curve, k] = span_of(h);
    const bool forward = piece_.runs_forward(h);
    points_[index(piece_.origin(h))] = vertices_[curve][forward ? k : k + 1];
    points_[index(piece_.target(h))] = vertices_[curve][forward ? k + 1 : k];
  }
}

/// Does an edge between these two vertices outlast the removal of the region?
bool Replacement::stays(PointId a, PointId b) const {
  for (const HalfEdgeId h : {find_half_edge(mesh_, a, b), find_half_edge(mesh_, b, a)})
    if (h != none && (mesh_.is_constrained(h) || !region_.contains(triangle_of(h)))) return true;
  return false;
}

/// Would a new inner edge join two vertices that another edge joins already?
bool Replacement::joins_twice() const {
  for (const HalfEdgeId h : piece_.half_edges()) {
    if (piece_.is_constrained(h) || piece_.twin(h) < h) continue;
    const PointId a = points_[index(piece_.origin(h))], b = points_[index(piece_.target(h))];
    if (a != none && b != none && stays(a, b)) return true;
  }
  return false;
}

void Replacement::take_border() {
  for (const std::vector<PointId>& vertices : vertices_) {
    first_piece_.push_back(border_.size());
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
      border_.push_back({side_of(mesh_, find_half_edge(mesh_, vertices[k], vertices[k + 1]))});
  }
}

/// Removes the elements of the region, and the points that no other element has.
void Replacement::remove() {
  std::vector<PointId> kept;
  for (const BorderPiece& piece : border_)
    for (int k = 0; k <= mesh_.degree(); ++k) kept.push_back(piece.side.points[k]);
  kept.insert(kept.end(), boundary_.vertices.begin(), boundary_.vertices.end());  // lone ones among them
  std::sort(kept.begin(), kept.end());
  std::vector<PointId> gone;
  for (const TriangleId t : region_.triangles()) {
    for (const PointId p : mesh_.net(t))
      if (!std::binary_search(kept.begin(), kept.end(), p)) gone.push_back(p);
    mesh_.free_triangle(t);
  }
  std::sort(gone.begin(), gone.end());
  gone.erase(std::unique(gone.begin(), gone.end()), gone.end());
  for (const PointId p : gone) mesh_.free_point(p);
}

std::pair<std::size_t, std::size_t> Replacement::span_of(HalfEdgeId h) const {
  const ConstraintId c = piece_.constraint(h);
  const auto curve = index(piece_.constraint_curve(c));
  const std::vector<double>& breaks = breaks_[curve];
  return {curve, index(std::lower_bound(breaks.begin(), breaks.end(), piece_.constraint_start(c)) - breaks.begin())};
}

Replacement::BorderPiece& Replacement::piece_at(HalfEdgeId h) {
  const auto [curve, k] = span_of(h);
  return border_[first_piece_[curve] + k];
}

void Replacement::build() {
  const int p = mesh_.degree();
  for (const HalfEdgeId h : piece_.half_edges()) {
    if (!piece_.is_constrained(h)) continue;
    const EdgePoints& edge = piece_at(h).side.points;
    const bool forward = piece_.runs_forward(h);
    for (int k = 0; k <= p; ++k) points_[index(piece_.edge_point(h, k))] = edge[forward ? k : p - k];
  }
  for (PointId q = 0; q < piece_.point_slots(); ++q) {
    if (points_[index(q)] != none) continue;
    points_[index(q)] = mesh_.add_point();
    mesh_.set_point(points_[index(q)], piece_.point(q));
    free_.push_back(points_[index(q)]);
  }
  for (TriangleId t = 0; t < piece_.triangle_slots(); ++t) {
    now_.push_back(mesh_.add_triangle(face_));
    for (int k = 0; k < mesh_.net_size(); ++k)
      mesh_.set_net_point(now_.back(), k, points_[index(piece_.net(t)[index(k)])]);
    for (int c = 0; c < 3; ++c)
      mesh_.set_vertex_half_edge(points_[index(piece_.corner(t, c))], half_edge(now_.back(), c));
  }
  for (const HalfEdgeId h : piece_.half_edges()) {
    const HalfEdgeId own = half_edge(now_[index(triangle_of(h))], edge_of(h));
    if (piece_.is_constrained(h)) {
      BorderPiece& beside = piece_at(h);
      (piece_.runs_forward(h) ? beside.along : beside.against) = own;
    } else if (piece_.twin(h) > h) {
      const HalfEdgeId g = piece_.twin(h);
      mesh_.link(own, half_edge(now_[index(triangle_of(g))], edge_of(g)));
    }
  }
  for (BorderPiece& piece : border_) {
    if (piece.against != none) piece.side.twin = piece.against;  // a slit
    attach(mesh_, piece.along, piece.side);
    if (piece.against != none) mesh_.set_constraint(piece.against, piece.side.constraint);
  }
}

/// Meshes the region anew. Where that is not possible the mesh stays as it was, and false is returned.
bool remesh(Mesh& mesh, PatchRegion region, const RefitOptions& refit, RemeshPatchCounts& counts) {
  const RegionBoundary boundary = boundary_of(mesh, region);
  if (!is_in_order(boundary.complex)) return false;
  GenerateOptions options;
  options.degree = mesh.degree();
  Mesh piece;
  if (!mesh_from_boundary(boundary.complex, options, piece).ok) return false;
  const long before = static_cast<long>(region.triangles().size());
  Transaction transaction(mesh);
  Replacement replacement(mesh, region, boundary, piece);
  if (!replacement.run(refit)) return false;
  transaction.commit();
  ++counts.patches;
  counts.triangles_before += before;
  counts.triangles_after += replacement.count();
  counts.edges_split += replacement.edges_split();
  return true;
}

}  // namespace

RemeshPatchCounts remesh_invalid(Mesh& mesh, const RefitOptions& refit) {
  RemeshPatchCounts counts;
  std::vector<TriangleId> seeds;
  const InvalidElements found = find_invalid(mesh);
  for (const auto* list : {&found.invalid, &found.degenerate}) seeds.insert(seeds.end(), list->begin(), list->end());
  if (seeds.empty()) return counts;
  std::sort(seeds.begin(), seeds.end());
  std::vector<char> invalid(index(mesh.triangle_slots()), 0);
  for (const TriangleId t : seeds) invalid[index(t)] = 1;
  std::vector<char> given_up(invalid.size(), 0);
  for (const TriangleId seed : seeds) {
    if (!invalid[index(seed)] || given_up[index(seed)]) continue;
    PatchRegion region(mesh, invalid, seed);
    bool done = false, grows = true;
    for (int rings = 1; grows; rings *= 2) {
      done = remesh(mesh, region, refit, counts);
      if (done) break;
      grows = region.grow(rings);
    }
    for (const TriangleId t : region.triangles()) {
      if (index(t) >= invalid.size()) continue;
      if (done)
        invalid[index(t)] = 0;
      else
        given_up[index(t)] = 1;
    }
  }
  counts.left = std::count(invalid.begin(), invalid.end(), 1);
  mesh.compact();
  return counts;
}

}  // namespace pliant

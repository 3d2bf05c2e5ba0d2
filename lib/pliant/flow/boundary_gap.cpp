// lib/pliant/flow/boundary_gap.cpp: gathers the constrained edges along their curves and searches them for gaps.
#include "pliant/flow/boundary_gap.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "pliant/geometry/describe.h"

namespace pliant {
namespace {

/// One half-edge of every constrained edge, curve by curve in the direction of each.
std::vector<HalfEdgeId> edges_along_curves(const Mesh& mesh) {
  std::vector<HalfEdgeId> edges;
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_alive(triangle_of(h)) && mesh.is_constrained(h) && (mesh.twin(h) == none || h < mesh.twin(h)))
      edges.push_back(h);
  const auto order = [&mesh](HalfEdgeId h) {
    const ConstraintId c = mesh.constraint(h);
    return std::pair(mesh.constraint_curve(c), mesh.constraint_start(c));
  };
  std::ranges::sort(edges, {}, order);
  return edges;
}

std::string name_of(const Mesh& mesh, CurveId c) {
  const std::string& name = mesh.boundary().curves[index(c)].name;
  return "curve " + std::to_string(c) + (name.empty() ? "" : " (\"" + name + "\")");
}

}  // namespace

std::optional<BoundaryGap> least_gap(const Mesh& mesh, std::span<const Point> points, double below) {
  if (!(below > 0)) return std::nullopt;
  const std::vector<HalfEdgeId> halves = edges_along_curves(mesh);
  const auto size = static_cast<std::size_t>(mesh.degree()) + 1;
  std::vector<Point> polygons(halves.size() * size);
  std::vector<GapEdge> edges;
  for (const HalfEdgeId h : halves) {
    const bool forward = mesh.runs_forward(h);
    const auto polygon = std::span(polygons).subspan(edges.size() * size, size);
    for (int k = 0; k <= mesh.degree(); ++k)
      polygon[index(k)] = points[index(mesh.edge_point(h, forward ? k : mesh.degree() - k))];
    const PointId from = forward ? mesh.origin(h) : mesh.target(h), to = forward ? mesh.target(h) : mesh.origin(h);
    edges.push_back({polygon, mesh.constraint_curve(mesh.constraint(h)), from, to});
  }
  const std::optional<Gap> gap = find_least_gap(edges, below);
  if (!gap) return std::nullopt;
  const auto first = static_cast<std::size_t>(gap->first), second = static_cast<std::size_t>(gap->second);
  return BoundaryGap{gap->distance,       gap->place,    gap->other,    edges[first].curve,
                     edges[second].curve, halves[first], halves[second]};
}

std::optional<BoundaryGap> least_gap(const Mesh& mesh, double below) {
  if (!(below > 0)) return std::nullopt;
  std::vector<Point> points(static_cast<std::size_t>(mesh.point_slots()));
  for (PointId p = 0; p < mesh.point_slots(); ++p) points[index(p)] = mesh.point(p);
  return least_gap(mesh, points, below);
}

std::string describe_gap(const Mesh& mesh, const BoundaryGap& gap) {
  const double unit = mesh.boundary().unit;
  std::ostringstream text;
  text.precision(6);
  if (gap.first == gap.second)
    text << "two parts of " << name_of(mesh, gap.first);
  else
    text << name_of(mesh, gap.first) << " and " << name_of(mesh, gap.second);
  const Point middle = unit * (gap.place + 0.5 * (gap.other - gap.place));
  text << (gap.distance > 0 ? " are " : " meet at ");
  if (gap.distance > 0) text << unit * gap.distance << " apart at ";
  text << describe_point(middle, place_resolution * unit * mesh.size());
  return text.str();
}

}  // namespace pliant

// formats/picture/mesh_edges.cpp: the edges of a mesh document, each once, for those who draw them.
#include "formats/picture/mesh_edges.h"

#include <algorithm>
#include <unordered_map>

#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

std::uint64_t key(PointId a, PointId b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(low)) << 32 | static_cast<std::uint32_t>(high);
}

PointId corner(const MeshData& mesh, HalfEdgeId h) {
  return mesh.triangles[static_cast<std::size_t>(triangle_of(h) * net_size(mesh.degree) + edge_of(h))];
}

}  // namespace

bool MeshEdges::runs_forward(const MeshData& mesh, HalfEdgeId h) const {
  const MeshEdge& edge = edges[static_cast<std::size_t>(of_half_edge[index(h)])];
  return edge.points.front() == corner(mesh, h);
}

MeshEdges find_edges(const MeshData& mesh) {
  const NetLayout& layout = NetLayout::of(mesh.degree);
  const auto triangles = static_cast<TriangleId>(mesh.triangle_faces.size());
  MeshEdges result;
  std::unordered_map<std::uint64_t, std::int32_t> known;
  for (TriangleId t = 0; t < triangles; ++t)
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      const auto next_id = static_cast<std::int32_t>(result.edges.size());
      const auto [place, is_new] = known.try_emplace(key(corner(mesh, h), corner(mesh, next(h))), next_id);
      result.of_half_edge.push_back(place->second);
      if (!is_new) {
        result.edges[static_cast<std::size_t>(place->second)].sides[1] = t;
        continue;
      }
      MeshEdge& edge = result.edges.emplace_back();
      edge.sides = {t, none};
      for (int k = 0; k <= mesh.degree; ++k)
        edge.points.push_back(
            mesh.triangles[static_cast<std::size_t>(t * net_size(mesh.degree) + layout.edge_index(e, k))]);
    }
  for (std::size_t c = 0; c < mesh.constrained_edges.size(); ++c) {
    const std::vector<PointId>& points = mesh.constrained_edges[c].points;
    const auto found = known.find(key(points.front(), points.back()));
    if (found != known.end())
      result.edges[static_cast<std::size_t>(found->second)].constrained = static_cast<std::int32_t>(c);
  }
  return result;
}

std::vector<Point> positions(const MeshData& mesh, const std::vector<PointId>& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const PointId p : points) result.push_back(mesh.points[static_cast<std::size_t>(p)]);
  return result;
}

std::span<const PointId> element_points(const MeshData& mesh, TriangleId t) {
  const auto size = static_cast<std::size_t>(net_size(mesh.degree));
  return std::span(mesh.triangles).subspan(static_cast<std::size_t>(t) * size, size);
}

std::vector<Point> element_net(const MeshData& mesh, TriangleId t) {
  const std::span<const PointId> net = element_points(mesh, t);
  return positions(mesh, {net.begin(), net.end()});
}

std::vector<double> rows_of(const std::vector<Point>& points) {
  std::vector<double> rows;
  rows.reserve(2 * points.size());
  for (const Point& p : points) rows.insert(rows.end(), {p.x, p.y});
  return rows;
}

Box bounding_box(const MeshData& mesh) {
  Box box;
  for (const Point& p : mesh.points) box.extend(p);
  return box;
}

double bulge(const std::vector<Point>& polygon) {
  // |c - chord| <= max |c''| / 8, and c'' has the control points p (p - 1) (b[k] - 2 b[k+1] + b[k+2]).
  const double p = double(polygon.size()) - 1;
  double most = 0;
  for (std::size_t k = 0; k + 2 < polygon.size(); ++k)
    most = std::max(most, length(polygon[k] - polygon[k + 1] * 2 + polygon[k + 2]));
  return p * (p - 1) / 8 * most;
}

}  // namespace pliant

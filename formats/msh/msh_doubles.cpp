// formats/msh/msh_doubles.cpp: nodes at one place twice, where parts that touch have not been joined.
#include <algorithm>
#include <cmath>
#include <map>

#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr double same_place = 1e-12;  ///< nodes closer than this part of the mesh's size are at one place

/// The vertices of edges with only one triangle, each once.
std::vector<PointId> outer_vertices(const MeshData& mesh, const std::vector<OpenEdge>& open) {
  const auto size = static_cast<std::size_t>(NetLayout::of(mesh.degree).size());
  std::vector<PointId> vertices;
  for (const OpenEdge& edge : open) {
    if (edge.right != none) continue;
    const PointId* net = &mesh.triangles[static_cast<std::size_t>(triangle_of(edge.left)) * size];
    vertices.push_back(net[edge_of(edge.left)]);
    vertices.push_back(net[(edge_of(edge.left) + 1) % 3]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

std::string name_double_nodes(const MshFile& file, const MeshData& mesh, const std::vector<OpenEdge>& open) {
  const std::vector<PointId> vertices = outer_vertices(mesh, open);
  const auto place = [&](PointId v) { return mesh.points[static_cast<std::size_t>(v)]; };
  Box box;
  for (const PointId v : vertices) box.extend(place(v));
  const double cell = same_place * box.size();
  if (!(cell > 0) || !std::isfinite(cell)) return {};
  using Cell = std::pair<double, double>;
  std::map<Cell, PointId> first_in;
  std::string text;
  std::size_t count = 0;
  for (const PointId v : vertices) {
    const Point p = place(v);
    const Cell mine{std::floor((p.x - box.low.x) / cell), std::floor((p.y - box.low.y) / cell)};
    PointId other = none;
    for (int dx = -1; dx <= 1 && other == none; ++dx)
      for (int dy = -1; dy <= 1 && other == none; ++dy) {
        const auto found = first_in.find({mine.first + dx, mine.second + dy});
        if (found != first_in.end() && distance(place(found->second), p) <= cell) other = found->second;
      }
    if (other == none) {
      first_in.emplace(mine, v);
      continue;
    }
    constexpr std::size_t most = 3;
    if (count++ < most)
      text += (count > 1 ? ", " : "") + std::to_string(file.tags.tag_of(other)) + " and " +
              std::to_string(file.tags.tag_of(v));
  }
  if (count == 0) return {};
  return "nodes are at one place twice (" + text + (count > 3 ? ", ...; " + std::to_string(count) + " in all" : "") +
         "): what lies beside them is not joined there; Gmsh's \"Coherence Mesh\" makes one node of them";
}

}  // namespace pliant

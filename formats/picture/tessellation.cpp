// formats/picture/tessellation.cpp: curved elements as straight triangles that meet along their edges.
#include "formats/picture/tessellation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "formats/picture/cut_polygon.h"
#include "formats/picture/mesh_edges.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr int max_edge_pieces = 32;
constexpr int max_color_pieces = 8;

/// The least power of two n with error <= tolerance * n^2, but at most `most`.
int pieces_for(double error, double tolerance, int most) {
  int n = 1;
  while (n < most && error > tolerance * n * n) n *= 2;
  return n;
}

int power_of_two(int n) {
  int power = 1;
  while (power < n) power *= 2;
  return power;
}

class Tessellator {
 public:
  Tessellator(const MeshData& mesh, const MeshEdges& edges, const ElementValues& values, ColorBy::Kind kind,
              const std::vector<TriangleId>& without, const TessellationOptions& options)
      : mesh_(mesh), edges_(edges), values_(values), kind_(kind), options_(options) {
    count_pieces(without);
  }
  void add(TriangleId t, bool marked);
  void add_inner_lines();
  Tessellation result;

 private:
  using Node = std::array<int, 2>;
  /// What vertices at one place must have in common to be shared: nothing (fields), the face, or the element.
  std::int64_t owner(TriangleId t) const {
    const auto face = mesh_.triangle_faces[static_cast<std::size_t>(t)];
    if (kind_ == ColorBy::Kind::metric) return t;
    const bool jumps = options_.heights != nullptr && options_.heights->depends_on_face();
    return kind_ == ColorBy::Kind::face || values_.depends_on_face() || jumps ? face : 0;
  }
  void count_pieces(const std::vector<TriangleId>& without);
  int inner_pieces(TriangleId t) const;
  std::uint32_t node_vertex(TriangleId t, const std::vector<double>& rows, int n, const Node& node);
  std::uint32_t edge_vertex(TriangleId t, const std::vector<double>& rows, int e, int k);
  void add_outline(TriangleId t, const std::vector<double>& rows, std::vector<std::uint32_t>& triangles);
  void add_lattice(TriangleId t, const std::vector<double>& rows, std::vector<std::uint32_t>& triangles);
  std::uint32_t make_vertex(TriangleId t, const std::vector<double>& rows, const Barycentric& xi);
  int cut_of_edge(std::size_t edge) const { return result.cuts[edge]; }
  std::size_t edge_of(TriangleId t, int e) const {
    return static_cast<std::size_t>(edges_.of_half_edge[index(half_edge(t, e))]);
  }

  const MeshData& mesh_;
  const MeshEdges& edges_;
  const ElementValues& values_;
  ColorBy::Kind kind_;
  const TessellationOptions& options_;
  std::vector<int> element_pieces_;  // of the lattice inside; 0: the outline is all that is needed
  std::map<std::array<std::int64_t, 3>, std::uint32_t> shared_;  // (owner, corner or -1 - edge, cut) -> vertex
};

/// How often colours and heights want the element cut inside.
int Tessellator::inner_pieces(TriangleId t) const {
  int n = 1;
  if (values_.is_field()) {
    n = pieces_for(values_.departure(t), options_.color_tolerance, max_color_pieces);
    const double spread = values_.spread(t);
    while (n < max_color_pieces && spread > options_.color_spread * n) n *= 2;
  }
  if (options_.heights != nullptr)
    n = std::max(n, pieces_for(options_.heights->departure(t), options_.height_tolerance, max_color_pieces));
  return n;
}

/// Elements whose inside is cut have a lattice, and edges in powers of two, which fit into it; so have those that are
/// not valid, whose outlines may cross themselves. All others are cut along their outlines only.
void Tessellator::count_pieces(const std::vector<TriangleId>& without) {
  const auto elements = static_cast<TriangleId>(mesh_.triangle_faces.size());
  result.cuts.assign(edges_.edges.size(), std::max(1, options_.subdivide));
  element_pieces_.assign(mesh_.triangle_faces.size(), options_.subdivide);
  if (options_.subdivide > 0) return;
  for (std::size_t e = 0; e < edges_.edges.size(); ++e)
    result.cuts[e] = edge_pieces(positions(mesh_, edges_.edges[e].points), options_.tolerance);
  for (TriangleId t = 0; t < elements; ++t) {
    const int inner = inner_pieces(t);
    if (inner == 1 && !std::binary_search(without.begin(), without.end(), t)) continue;
    element_pieces_[static_cast<std::size_t>(t)] = inner;
    for (int e = 0; e < 3; ++e) {
      int& cuts = result.cuts[edge_of(t, e)];
      cuts = power_of_two(std::max(cuts, inner));
    }
  }
  for (TriangleId t = 0; t < elements; ++t)
    if (int& n = element_pieces_[static_cast<std::size_t>(t)]; n > 0)
      for (int e = 0; e < 3; ++e) n = std::max(n, cut_of_edge(edge_of(t, e)));
}

std::uint32_t Tessellator::make_vertex(TriangleId t, const std::vector<double>& rows, const Barycentric& xi) {
  std::array<double, 2> place{};
  evaluate_net(mesh_.degree, 2, rows, xi, place);
  result.vertices.push_back({place[0], place[1]});
  if (values_.exist()) result.values.push_back(values_.at(t, xi));
  if (options_.heights != nullptr) result.heights.push_back(options_.heights->at(t, xi));
  result.vertex_faces.push_back(mesh_.triangle_faces[static_cast<std::size_t>(t)]);
  return static_cast<std::uint32_t>(result.vertices.size() - 1);
}

/// The vertex at the k-th cut of the element's edge e, in the element's direction.
std::uint32_t Tessellator::edge_vertex(TriangleId t, const std::vector<double>& rows, int e, int k) {
  const std::size_t edge = edge_of(t, e);
  const int n = cut_of_edge(edge);
  const auto from = static_cast<std::size_t>(e), to = (from + 1) % 3;
  std::array<std::int64_t, 3> key{owner(t), 0, 0};
  if (k == 0 || k == n) {
    const auto size = static_cast<std::size_t>(net_size(mesh_.degree));
    key[1] = mesh_.triangles[static_cast<std::size_t>(t) * size + (k == 0 ? from : to)];
  } else {
    key[1] = -1 - static_cast<std::int64_t>(edge);
    key[2] = edges_.runs_forward(mesh_, half_edge(t, e)) ? k : n - k;
  }
  const auto [place, is_new] = shared_.try_emplace(key, 0);
  if (is_new) {
    Barycentric xi{};
    xi[from] = double(n - k) / n;
    xi[to] = double(k) / n;
    place->second = make_vertex(t, rows, xi);
  }
  return place->second;
}

std::uint32_t Tessellator::node_vertex(TriangleId t, const std::vector<double>& rows, int n, const Node& node) {
  const std::array<int, 3> weight{n - node[0] - node[1], node[0], node[1]};
  for (int e = 0; e < 3; ++e)
    if (weight[static_cast<std::size_t>(e + 2) % 3] == 0)
      return edge_vertex(t, rows, e, weight[static_cast<std::size_t>(e + 1) % 3] * cut_of_edge(edge_of(t, e)) / n);
  return make_vertex(t, rows, {double(weight[0]) / n, double(weight[1]) / n, double(weight[2]) / n});
}

void Tessellator::add_outline(TriangleId t, const std::vector<double>& rows, std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> outline;
  std::vector<Point> corners;
  for (int e = 0; e < 3; ++e)
    for (int k = 0; k < cut_of_edge(edge_of(t, e)); ++k) {
      outline.push_back(edge_vertex(t, rows, e, k));
      corners.push_back(result.vertices[outline.back()]);
    }
  for (const std::array<int, 3>& triangle : cut_polygon(corners))
    for (const int corner : triangle) triangles.push_back(outline[static_cast<std::size_t>(corner)]);
}

void Tessellator::add_lattice(TriangleId t, const std::vector<double>& rows, std::vector<std::uint32_t>& triangles) {
  ElementLattice lattice{element_pieces_[static_cast<std::size_t>(t)], {}};
  for (int e = 0; e < 3; ++e) lattice.counts[static_cast<std::size_t>(e)] = cut_of_edge(edge_of(t, e));
  std::map<Node, std::uint32_t> vertices;
  for (const auto& triangle : lattice.triangles())
    for (const Node& node : triangle) {
      auto [place, is_new] = vertices.try_emplace(node, 0);
      if (is_new) place->second = node_vertex(t, rows, lattice.n, node);
      triangles.push_back(place->second);
    }
}

void Tessellator::add(TriangleId t, bool marked) {
  const std::vector<double> rows = rows_of(element_net(mesh_, t));
  std::vector<std::uint32_t>& triangles = marked ? result.marked : result.triangles;
  if (element_pieces_[static_cast<std::size_t>(t)] == 0)
    add_outline(t, rows, triangles);
  else
    add_lattice(t, rows, triangles);
}

void Tessellator::add_inner_lines() {
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    const MeshEdge& edge = edges_.edges[e];
    if (edge.constrained != none) continue;
    const std::int64_t from = owner(edge.sides[0]);
    const auto vertex = [&](int k) {
      if (k == 0) return shared_.at({from, edge.points.front(), 0});
      if (k == cut_of_edge(e)) return shared_.at({from, edge.points.back(), 0});
      return shared_.at({from, -1 - static_cast<std::int64_t>(e), k});
    };
    for (int k = 0; k < cut_of_edge(e); ++k)
      result.inner_lines.insert(result.inner_lines.end(), {vertex(k), vertex(k + 1)});
  }
}

}  // namespace

std::array<int, 2> ElementLattice::moved(int i, int j) const {
  const int k = n - i - j;
  // The nearest of the m cuts to step s of n, as a step of n.
  const auto snap = [this](int s, int m) { return (2 * s * m + n) / (2 * n) * (n / m); };
  if (j == 0) return {snap(i, counts[0]), 0};
  if (k == 0) return {n - snap(j, counts[1]), snap(j, counts[1])};
  if (i == 0) return {0, n - snap(k, counts[2])};
  return {i, j};
}

std::vector<std::array<std::array<int, 2>, 3>> ElementLattice::triangles() const {
  std::vector<std::array<std::array<int, 2>, 3>> result;
  const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
    a = moved(a[0], a[1]), b = moved(b[0], b[1]), c = moved(c[0], c[1]);
    if ((b[0] - a[0]) * (c[1] - a[1]) != (b[1] - a[1]) * (c[0] - a[0])) result.push_back({a, b, c});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add({i, j}, {i + 1, j}, {i, j + 1});
      if (i + j < n - 1) add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
    }
  return result;
}

int edge_pieces(const std::vector<Point>& polygon, double tolerance) {
  int n = 1;
  for (const double error = bulge(polygon); n < max_edge_pieces && error > tolerance * n * n;) ++n;
  return n;
}

Polyline sample_edge(const std::vector<Point>& polygon, int n) {
  const int degree = static_cast<int>(polygon.size()) - 1;
  const std::vector<double> rows = rows_of(polygon);
  std::vector<double> derivative;
  for (std::size_t k = 0; k + 2 < rows.size(); ++k) derivative.push_back(rows[k + 2] - rows[k]);
  Polyline line;
  for (int k = 0; k <= n; ++k) {
    const double s = double(k) / n;
    std::array<double, 2> place{}, direction{};
    evaluate_polygon(degree, 2, rows, s, place);
    evaluate_polygon(degree - 1, 2, derivative, s, direction);
    line.points.push_back({place[0], place[1]});
    const Vector tangent{direction[0], direction[1]};
    line.tangents.push_back(length(tangent) > 0 ? tangent / length(tangent) : Vector{});
  }
  line.points.front() = polygon.front();
  line.points.back() = polygon.back();
  return line;
}

Tessellation tessellate(const MeshData& mesh, const MeshEdges& edges, const ElementValues& values, ColorBy::Kind kind,
                        const std::vector<TriangleId>& without, const TessellationOptions& options) {
  Tessellator tessellator(mesh, edges, values, kind, without, options);
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
    tessellator.add(t, std::binary_search(without.begin(), without.end(), t));
  tessellator.add_inner_lines();
  return std::move(tessellator.result);
}

}  // namespace pliant

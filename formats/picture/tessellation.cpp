// formats/picture/tessellation.cpp: curved elements as straight triangles that meet along their edges.
#include "formats/picture/tessellation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr int max_pieces = 32;
constexpr int max_color_pieces = 8;

/// The least power of two n with error <= tolerance * n^2, but at most `most`.
int pieces_for(double error, double tolerance, int most) {
  int n = 1;
  while (n < most && error > tolerance * n * n) n *= 2;
  return n;
}

std::vector<double> rows_of(const std::vector<Point>& points) {
  std::vector<double> rows;
  rows.reserve(2 * points.size());
  for (const Point& p : points) rows.insert(rows.end(), {p.x, p.y});
  return rows;
}

class Tessellator {
 public:
  Tessellator(const MeshData& mesh, const MeshEdges& edges, const ElementValues& values, ColorBy::Kind kind,
              const TessellationOptions& options)
      : mesh_(mesh), edges_(edges), values_(values), kind_(kind), options_(options) {
    count_pieces();
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
    return kind_ == ColorBy::Kind::face || values_.depends_on_face() ? face : 0;
  }
  void count_pieces();
  std::uint32_t vertex(TriangleId t, const std::vector<double>& rows, int n, const Node& node);
  std::uint32_t make_vertex(TriangleId t, const std::vector<double>& rows, const Barycentric& xi);
  int cut_of_edge(std::size_t edge) const { return edge_pieces_[edge]; }

  const MeshData& mesh_;
  const MeshEdges& edges_;
  const ElementValues& values_;
  ColorBy::Kind kind_;
  const TessellationOptions& options_;
  std::vector<int> edge_pieces_, element_pieces_, color_pieces_;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> shared_;  // (owner, corner or -1 - edge, cut) -> vertex
};

void Tessellator::count_pieces() {
  const std::size_t elements = mesh_.triangle_faces.size();
  edge_pieces_.assign(edges_.edges.size(), std::max(1, options_.subdivide));
  element_pieces_.assign(elements, std::max(1, options_.subdivide));
  color_pieces_ = element_pieces_;
  if (options_.subdivide > 0) return;
  for (std::size_t t = 0; t < elements && values_.is_field(); ++t) {
    int n = pieces_for(values_.departure(static_cast<TriangleId>(t)), options_.color_tolerance, max_color_pieces);
    const double spread = values_.spread(static_cast<TriangleId>(t));
    while (n < max_color_pieces && spread > options_.color_spread * n) n *= 2;
    color_pieces_[t] = element_pieces_[t] = n;
  }
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    int& n = edge_pieces_[e];
    n = edge_pieces(positions(mesh_, edges_.edges[e].points), options_.tolerance);
    for (const TriangleId t : edges_.edges[e].sides)
      if (t != none) n = std::max(n, element_pieces_[static_cast<std::size_t>(t)]);
  }
  for (std::size_t h = 0; h < edges_.of_half_edge.size(); ++h)
    element_pieces_[h / 3] =
        std::max(element_pieces_[h / 3], edge_pieces_[static_cast<std::size_t>(edges_.of_half_edge[h])]);
}

std::uint32_t Tessellator::make_vertex(TriangleId t, const std::vector<double>& rows, const Barycentric& xi) {
  std::array<double, 2> place{};
  evaluate_net(mesh_.degree, 2, rows, xi, place);
  result.vertices.push_back({place[0], place[1]});
  if (values_.exist()) result.values.push_back(values_.at(t, xi));
  result.vertex_faces.push_back(mesh_.triangle_faces[static_cast<std::size_t>(t)]);
  return static_cast<std::uint32_t>(result.vertices.size() - 1);
}

std::uint32_t Tessellator::vertex(TriangleId t, const std::vector<double>& rows, int n, const Node& node) {
  const std::array<int, 3> weight{n - node[0] - node[1], node[0], node[1]};
  const Barycentric xi{double(weight[0]) / n, double(weight[1]) / n, double(weight[2]) / n};
  std::array<std::int64_t, 3> key{owner(t), 0, 0};
  const int zeros = static_cast<int>(std::count(weight.begin(), weight.end(), 0));
  if (zeros == 2) {
    const auto c = static_cast<std::size_t>(std::find(weight.begin(), weight.end(), n) - weight.begin());
    key[1] = mesh_.triangles[static_cast<std::size_t>(t) * static_cast<std::size_t>(net_size(mesh_.degree)) + c];
  } else if (zeros == 1) {
    // The node lies on the edge opposite the corner whose weight is 0.
    const auto c = static_cast<std::size_t>(std::find(weight.begin(), weight.end(), 0) - weight.begin());
    const HalfEdgeId h = half_edge(t, static_cast<int>((c + 1) % 3));
    const auto edge = static_cast<std::size_t>(edges_.of_half_edge[index(h)]);
    const int along = weight[edges_.runs_forward(mesh_, h) ? (c + 2) % 3 : (c + 1) % 3];
    key[1] = -1 - static_cast<std::int64_t>(edge);
    key[2] = along * cut_of_edge(edge) / n;
  } else {
    return make_vertex(t, rows, xi);
  }
  const auto [place, is_new] = shared_.try_emplace(key, 0);
  if (is_new) place->second = make_vertex(t, rows, xi);
  return place->second;
}

/// The triangles from the corner opposite the only edge that is cut, where nothing inside asks for more.
std::vector<std::array<std::array<int, 2>, 3>> fan(int n, int edge) {
  const auto node = [](const std::array<int, 3>& weight) { return std::array<int, 2>{weight[1], weight[2]}; };
  std::vector<std::array<std::array<int, 2>, 3>> result;
  for (int k = 0; k < n; ++k) {
    std::array<int, 3> apex{}, from{}, to{};
    const auto a = static_cast<std::size_t>(edge), b = (a + 1) % 3, c = (a + 2) % 3;
    apex[c] = n;
    from[a] = n - k, from[b] = k;
    to[a] = n - k - 1, to[b] = k + 1;
    result.push_back({node(apex), node(from), node(to)});
  }
  return result;
}

void Tessellator::add(TriangleId t, bool marked) {
  ElementLattice lattice{element_pieces_[static_cast<std::size_t>(t)], {}};
  for (int e = 0; e < 3; ++e)
    lattice.counts[static_cast<std::size_t>(e)] =
        cut_of_edge(static_cast<std::size_t>(edges_.of_half_edge[static_cast<std::size_t>(half_edge(t, e))]));
  const std::vector<double> rows = rows_of(element_net(mesh_, t));
  const auto& counts = lattice.counts;
  const bool is_fan =
      color_pieces_[static_cast<std::size_t>(t)] == 1 && std::count(counts.begin(), counts.end(), 1) == 2;
  const auto longest = static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  std::map<Node, std::uint32_t> vertices;
  for (const auto& triangle : is_fan ? fan(lattice.n, longest) : lattice.triangles())
    for (const Node& node : triangle) {
      auto [place, is_new] = vertices.try_emplace(node, 0);
      if (is_new) place->second = vertex(t, rows, lattice.n, node);
      (marked ? result.marked : result.triangles).push_back(place->second);
    }
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
  return pieces_for(bulge(polygon), tolerance, max_pieces);
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
  Tessellator tessellator(mesh, edges, values, kind, options);
  for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
    tessellator.add(t, std::binary_search(without.begin(), without.end(), t));
  tessellator.add_inner_lines();
  return std::move(tessellator.result);
}

}  // namespace pliant

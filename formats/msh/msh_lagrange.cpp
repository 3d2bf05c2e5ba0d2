// formats/msh/msh_lagrange.cpp: from Lagrange nodes to Bézier control points, and which edges lie on curves.
#include <algorithm>
#include <array>
#include <numeric>

#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr std::int32_t taken = -2;   // the point is a corner, an inner point, or one that does not stand for its edge
constexpr std::int32_t paired = -3;  // the point stands for an edge whose two triangles are known

void count_clockwise(const MeshData& mesh, const PointId* net, std::size_t t, EdgeFindings& findings) {
  const Point& a = mesh.points[index(net[0])];
  if (cross(mesh.points[index(net[1])] - a, mesh.points[index(net[2])] - a) < 0 && findings.clockwise++ == 0)
    findings.first_clockwise = t;
}

/// Walks all nets once. One point inside each edge stands for the edge: of the first and the last the one with the
/// lower number, so that both triangles agree on it. There the walk keeps which half-edge of the edge it met first; it
/// converts the edge when it meets that one.
class EdgeWalk {
 public:
  EdgeWalk(MeshData& mesh, EdgeFindings& findings)
      : mesh_(mesh), layout_(NetLayout::of(mesh.degree)), findings_(findings), uses_(findings.uses) {}

  template <int fixed_degree, bool convert>
  void run() {
    const int degree = fixed_degree > 0 ? fixed_degree : mesh_.degree;
    const std::size_t size = index(net_size(degree));
    const std::size_t triangles = mesh_.triangle_faces.size();
    const PointId* net = mesh_.triangles.data();
    for (std::size_t t = 0; t < triangles; ++t, net += size) {
      if (t + ahead < triangles) fetch(net + ahead * size, 3 * degree);
      count_clockwise(mesh_, net, t, findings_);
      for (int e = 0; e < 3; ++e) uses_[index(net[e])] = taken;
      for (int e = 0; e < 3; ++e) {
        const PointId first = net[3 + e * (degree - 1)], last = net[3 + e * (degree - 1) + degree - 2];
        const PointId key = std::min(first, last);
        const HalfEdgeId h = half_edge(static_cast<TriangleId>(t), e);
        if (uses_[index(key)] == unused_point) {
          uses_[index(key)] = as_int(h);
          if constexpr (fixed_degree == 2 && convert)
            convert_middle(key, net[e], net[(e + 1) % 3]);
          else
            take_edge<convert>(net, e, degree);
        } else if (uses_[index(key)] >= 0) {
          pair(HalfEdgeId{uses_[index(key)]}, h);
          uses_[index(key)] = paired;
        }
        // Only in a broken mesh are these points not new: an edge there shares its first point with others.
        if (fixed_degree != 2)
          for (int k = 1; k < degree; ++k) mark(net[layout_.edge_index(e, k)]);
      }
      if (fixed_degree != 2 && degree > 2) take_interior<convert>(net, degree);
    }
    for (const std::int32_t use : uses_)
      if (use >= 0) findings_.open.push_back({HalfEdgeId{use}, none});
  }

 private:
  /// Points of a triangle lie anywhere in memory: they are fetched `ahead` triangles before they are needed.
  static constexpr std::size_t ahead = 12;
  void fetch(const PointId* net, int count) const {
    for (int k = 0; k < count; ++k) {
      __builtin_prefetch(&uses_[index(net[k])], 1);
      __builtin_prefetch(&mesh_.points[index(net[k])], 1);
    }
  }

  void convert_middle(PointId middle, PointId a, PointId b) {
    Point& m = mesh_.points[index(middle)];
    const Point& p = mesh_.points[index(a)];
    const Point& q = mesh_.points[index(b)];
    m = {2 * m.x - (p.x + q.x) / 2, 2 * m.y - (p.y + q.y) / 2};
  }

  template <bool convert>
  void take_edge(const PointId* net, int e, int degree) {
    // From the vertex of lower number, so that the direction does not depend on the triangle.
    const bool forward = net[e] < net[(e + 1) % 3];
    const auto point = [&](int k) { return net[layout_.edge_index(e, forward ? k : degree - k)]; };
    std::array<double, 2 * (max_degree + 1)> polygon;
    if constexpr (convert) {
      for (int k = 0; k <= degree; ++k) set(&polygon[index(2 * k)], mesh_.points[index(point(k))]);
      interpolate_polygon(degree, 2, polygon);
    }
    if constexpr (convert)
      for (int k = 1; k < degree; ++k)
        mesh_.points[index(point(k))] = {polygon[index(2 * k)], polygon[index(2 * k + 1)]};
  }
  void mark(PointId p) {
    if (uses_[index(p)] == unused_point) uses_[index(p)] = taken;
  }

  template <bool convert>
  void take_interior(const PointId* net, int degree) {
    const int first = layout_.first_interior();
    bool is_new = true;
    for (int k = first; k < layout_.size(); ++k) {
      is_new = is_new && uses_[index(net[k])] == unused_point;
      uses_[index(net[k])] = taken;
    }
    if (!convert || !is_new) return;  // two triangles that share inner points are a broken mesh anyway
    std::array<double, 2 * net_size(max_degree)> values;
    for (int k = 0; k < layout_.size(); ++k) set(&values[index(2 * k)], mesh_.points[index(net[k])]);
    interpolate_interior(degree, 2, values);
    for (int k = first; k < layout_.size(); ++k)
      mesh_.points[index(net[k])] = {values[index(2 * k)], values[index(2 * k + 1)]};
  }

  static void set(double* to, const Point& p) {
    to[0] = p.x;
    to[1] = p.y;
  }

  void pair(HalfEdgeId h, HalfEdgeId g) {
    const FaceId mine = mesh_.triangle_faces[index(triangle_of(h))],
                 other = mesh_.triangle_faces[index(triangle_of(g))];
    if (mine != other) findings_.open.push_back(mine < other ? OpenEdge{h, g} : OpenEdge{g, h});
  }

  MeshData& mesh_;
  const NetLayout& layout_;
  EdgeFindings& findings_;
  std::vector<std::int32_t>& uses_;
};

/// Pairs open edges that have the same vertices but other points inside. They are no boundary, but a fault, which the
/// checker finds.
void pair_by_ends(const MeshData& mesh, std::vector<OpenEdge>& edges) {
  const std::size_t size = index(net_size(mesh.degree));
  struct Ends {
    PointId low, high;
    std::size_t edge;
  };
  std::vector<Ends> all;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const HalfEdgeId h = edges[k].left;
    if (edges[k].right != none) continue;
    const PointId* net = &mesh.triangles[index(triangle_of(h)) * size];
    const auto [low, high] = std::minmax(net[edge_of(h)], net[(edge_of(h) + 1) % 3]);
    all.push_back({low, high, k});
  }
  std::sort(all.begin(), all.end(), [](const Ends& a, const Ends& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.edge < b.edge;
  });
  std::vector<char> gone(edges.size(), 0);
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (all[k].low != all[k - 1].low || all[k].high != all[k - 1].high) continue;
    OpenEdge& first = edges[all[k - 1].edge];
    const HalfEdgeId other = edges[all[k].edge].left;
    const FaceId mine = mesh.triangle_faces[index(triangle_of(first.left))];
    const FaceId its = mesh.triangle_faces[index(triangle_of(other))];
    gone[all[k].edge] = 1;
    if (mine == its)
      gone[all[k - 1].edge] = 1;
    else
      first = mine < its ? OpenEdge{first.left, other} : OpenEdge{other, first.left};
    ++k;
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!gone[k]) edges[kept++] = edges[k];
  edges.resize(kept);
}

}  // namespace

void take_nets(MshFile& file, MeshData& mesh) {
  mesh.points = std::move(file.nodes);
  mesh.triangles = std::move(file.triangle_nodes);
  const std::vector<int> order = msh_net_order(mesh.degree);
  if (std::is_sorted(order.begin(), order.end())) return;
  std::vector<PointId> net(order.size());
  for (std::size_t first = 0; first < mesh.triangles.size(); first += order.size()) {
    for (std::size_t k = 0; k < order.size(); ++k) net[index(order[k])] = mesh.triangles[first + k];
    std::copy(net.begin(), net.end(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

std::vector<HalfEdgeId> twins_by_vertices(const MeshData& mesh) {
  const std::size_t size = index(net_size(mesh.degree)), half_edges = 3 * mesh.triangle_faces.size();
  const auto ends = [&](HalfEdgeId h) {
    const PointId* net = &mesh.triangles[index(triangle_of(h)) * size];
    return std::minmax({net[edge_of(h)], net[edge_of(next(h))]});
  };
  std::vector<std::uint32_t> first(mesh.points.size() + 1, 0);
  for (const HalfEdgeId h : mesh.half_edges()) ++first[index(ends(h).first) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  struct Entry {
    PointId high;
    HalfEdgeId half_edge;
  };
  std::vector<Entry> entries(half_edges);
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (const HalfEdgeId h : mesh.half_edges()) {
    const auto [low, high] = ends(h);
    entries[fill[index(low)]++] = {high, h};
  }
  std::vector<HalfEdgeId> twins(half_edges, none);
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    // A stable sort: usually of a handful, but a hostile file may have a huge star.
    const auto begin = entries.begin() + first[v], stop = entries.begin() + first[v + 1];
    std::sort(begin, stop, [](const Entry& a, const Entry& b) {
      return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
    });
    for (auto entry = begin; entry != stop; ++entry) {
      const auto next = entry + 1;
      if (next == stop || next->high != entry->high) continue;
      twins[index(entry->half_edge)] = next->half_edge;
      twins[index(next->half_edge)] = entry->half_edge;
      for (; entry + 1 != stop && entry[1].high == next->high; ++entry)
        if (entry >= next) twins[index(entry[1].half_edge)] = entry[1].half_edge;
    }
  }
  return twins;
}

EdgeFindings pair_edges(MeshData& mesh, bool convert) {
  EdgeFindings findings;
  findings.uses.assign(mesh.points.size(), unused_point);
  if (mesh.degree > 1) {
    EdgeWalk walk(mesh, findings);
    if (mesh.degree == 2)
      convert ? walk.run<2, true>() : walk.run<2, false>();
    else
      convert ? walk.run<0, true>() : walk.run<0, false>();
    pair_by_ends(mesh, findings.open);
    return findings;
  }
  for (const PointId p : mesh.triangles) findings.uses[index(p)] = taken;
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t)
    count_clockwise(mesh, &mesh.triangles[3 * t], t, findings);
  const std::vector<HalfEdgeId> twins = twins_by_vertices(mesh);
  for (const HalfEdgeId h : mesh.half_edges()) {
    const HalfEdgeId g = twins[index(h)];
    const FaceId mine = mesh.triangle_faces[index(triangle_of(h))];
    if (g == none)
      findings.open.push_back({h, none});
    else if (mine < mesh.triangle_faces[index(triangle_of(g))])
      findings.open.push_back({h, g});
  }
  return findings;
}

}  // namespace pliant

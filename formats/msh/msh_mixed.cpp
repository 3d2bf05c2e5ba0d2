// formats/msh/msh_mixed.cpp: triangles of several orders, raised to the highest.
#include <algorithm>
#include <array>
#include <unordered_map>

#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Polygon = std::array<double, 2 * (max_degree + 1)>;
using Net = std::array<double, 2 * net_size(max_degree)>;

class Elevation {
 public:
  Elevation(MshFile& file, MeshData& mesh)
      : file_(file), mesh_(mesh), degree_(mesh.degree), layout_(NetLayout::of(mesh.degree)), nodes_(file.nodes) {}

  std::string run() {
    Box box;
    for (const Point& p : nodes_) box.extend(p);
    tolerance_ = box.tolerance();
    mesh_.points = std::move(file_.nodes);
    size_t triangles = 0;
    for (const MshTriangles& block : file_.blocks) triangles += block.count;
    mesh_.triangles.resize(triangles * index(layout_.size()));
    // Triangles of the highest order come first: their nodes become points of the mesh, which the others look for.
    for (int order = degree_; order >= 1; --order) take_order(order);
    if (torn_ == 0) return {};
    return std::to_string(torn_) + (torn_ == 1 ? " edge is" : " edges are") +
           " not the same curve in both triangles, which have different orders (first: of elements " +
           std::to_string(file_.triangle_tags.tag_of(torn_triangles_[0])) + " and " +
           std::to_string(file_.triangle_tags.tag_of(torn_triangles_[1])) + ")";
  }

 private:
  /// A curve between two vertices: its inner control points, counted from the vertex of lower number.
  struct Curve {
    std::array<PointId, max_degree> inner;
    std::size_t triangle;
  };

  void take_order(int order) {
    const std::vector<int> places = msh_net_order(order);
    const NetLayout& low = NetLayout::of(order);
    std::vector<PointId> net(places.size());
    const PointId* nodes = file_.triangle_nodes.data();
    std::size_t t = 0;
    for (const MshTriangles& block : file_.blocks) {
      const auto size = index(net_size(block.order));
      if (block.order != order) {
        nodes += block.count * size;
        t += block.count;
        continue;
      }
      for (std::size_t k = 0; k < block.count; ++k, ++t, nodes += size) {
        for (std::size_t n = 0; n < size; ++n) net[index(places[n])] = nodes[n];
        take_triangle(t, net.data(), low);
      }
    }
  }

  void take_triangle(std::size_t t, const PointId* net, const NetLayout& low) {
    PointId* out = &mesh_.triangles[t * index(layout_.size())];
    Net values{};
    for (int k = 0; k < low.size(); ++k) set(values.data(), k, nodes_[index(net[k])]);
    for (int e = 0; e < 3; ++e) {
      out[e] = net[e];
      take_edge(t, net, e, low, values, out);
    }
    interpolate_interior(low.degree(), 2, values);
    if (low.degree() == degree_) {
      for (int k = low.first_interior(); k < low.size(); ++k) {
        out[k] = net[k];
        mesh_.points[index(net[k])] = get(values.data(), k);
      }
      return;
    }
    Net raised = values;
    for (int p = low.degree(); p < degree_; ++p) {
      values = raised;
      elevate_net(p, 2, values, raised);
    }
    for (int k = layout_.first_interior(); k < layout_.size(); ++k) out[k] = add_point(get(raised.data(), k));
  }

  /// Writes the control points of the edge: those of its own degree into `values`, raised ones into `out`.
  void take_edge(std::size_t t, const PointId* net, int e, const NetLayout& low, Net& values, PointId* out) {
    const int order = low.degree();
    const PointId a = net[e], b = net[(e + 1) % 3];
    const bool forward = a < b;
    const auto place = [&](const NetLayout& layout, int k) {
      return layout.edge_index(e, forward ? k : layout.degree() - k);
    };
    Polygon polygon{}, raised{};
    for (int k = 0; k <= order; ++k) set(polygon.data(), k, nodes_[index(net[place(low, k)])]);
    interpolate_polygon(order, 2, polygon);
    for (int k = 1; k < order; ++k) set(values.data(), place(low, k), get(polygon.data(), k));
    for (int p = order; p < degree_; ++p) {
      elevate_polygon(p, 2, polygon, raised);
      polygon = raised;
    }
    Curve curve{{}, t};
    for (int k = 1; k < degree_; ++k) curve.inner[index(k)] = order == degree_ ? net[place(low, k)] : none;
    curve = find_or_add({std::min(a, b), std::max(a, b)}, curve, polygon);
    for (int k = 1; k < degree_; ++k) out[place(layout_, k)] = curve.inner[index(k)];
  }

  /// The curve between these vertices with these control points: a known one or else a new one. A new curve takes nodes
  /// of the file as points where it has any, and adds the others.
  Curve find_or_add(const std::pair<PointId, PointId>& ends, Curve curve, const Polygon& polygon) {
    const std::uint64_t key = index(ends.first) << 32 | index(ends.second);
    const auto [first, last] = curves_.equal_range(key);
    for (auto known = first; known != last; ++known) {
      bool same = true;
      for (int k = 1; k < degree_ && same; ++k) {
        const PointId p = known->second.inner[index(k)];
        same = curve.inner[index(k)] != none ? p == curve.inner[index(k)]
                                             : distance(mesh_.points[index(p)], get(polygon.data(), k)) <= tolerance_;
      }
      if (same) return known->second;
    }
    if (first != last && torn_++ == 0) torn_triangles_ = {first->second.triangle, curve.triangle};
    for (int k = 1; k < degree_; ++k) {
      PointId& p = curve.inner[index(k)];
      if (p == none)
        p = add_point(get(polygon.data(), k));
      else
        mesh_.points[index(p)] = get(polygon.data(), k);
    }
    curves_.emplace(key, curve);
    return curve;
  }

  PointId add_point(const Point& p) {
    if (mesh_.points.size() >= index(std::numeric_limits<PointId>::max()))
      throw InputError("", "raised to one order, the mesh has more points than can be numbered");
    mesh_.points.push_back(p);
    return static_cast<PointId>(mesh_.points.size() - 1);
  }
  static void set(double* rows, int k, const Point& p) {
    rows[2 * k] = p.x;
    rows[2 * k + 1] = p.y;
  }
  static Point get(const double* rows, int k) { return {rows[2 * k], rows[2 * k + 1]}; }

  MshFile& file_;
  MeshData& mesh_;
  int degree_;
  const NetLayout& layout_;
  std::vector<Point> nodes_;  ///< the nodes as they are in the file
  double tolerance_ = 0;
  std::unordered_multimap<std::uint64_t, Curve> curves_;
  std::size_t torn_ = 0;
  std::array<std::size_t, 2> torn_triangles_{};
};

}  // namespace

std::string take_mixed_nets(MshFile& file, MeshData& mesh) { return Elevation(file, mesh).run(); }

}  // namespace pliant

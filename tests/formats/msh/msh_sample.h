// tests/formats/msh/msh_sample.h: a small writer of MSH files, of every kind that is read.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant::samples {

struct MshKind {
  int version = 4;  ///< 2 or 4
  bool binary = false;
  bool swapped = false;
};
inline const std::vector<MshKind> msh_kinds = {{2, false, false}, {4, false, false}, {2, true, false},
                                               {4, true, false},  {2, true, true},   {4, true, true}};

struct MshSample {
  struct Node {
    std::int64_t tag;
    double x, y, z;
  };
  struct Element {
    int type;
    std::int64_t tag;
    int physical, entity;
    std::vector<std::int64_t> nodes;
  };
  struct Name {
    int dimension, tag;
    std::string name;
  };
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<Name> names;
  std::string tail;  ///< sections behind the elements
};

inline int msh_dimension(int type) {
  static const std::set<int> lines = {1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
  return type == 15 ? 0 : lines.count(type) ? 1 : type == 4 ? 3 : 2;
}

/// Puts numbers together, as text or as bytes.
class MshWriter {
 public:
  explicit MshWriter(const MshKind& kind) : kind_(kind) {}
  template <class T>
  MshWriter& put(T value) {
    if (kind_.binary) {
      auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
      if (kind_.swapped) std::reverse(bytes.begin(), bytes.end());
      out.append(bytes.data(), bytes.size());
    } else if constexpr (std::is_floating_point_v<T>) {
      char text[40];
      std::snprintf(text, sizeof text, "%.17g ", value);
      out += text;
    } else {
      out += std::to_string(value) + " ";
    }
    return *this;
  }
  MshWriter& end_row() {
    if (!kind_.binary) out += "\n";
    return *this;
  }
  std::string out;

 private:
  MshKind kind_;
};

inline std::string write_msh_2(const MshSample& sample, const MshKind& kind) {
  MshWriter w(kind);
  w.out += "$Nodes\n" + std::to_string(sample.nodes.size()) + "\n";
  for (const auto& node : sample.nodes)
    w.put(static_cast<std::int32_t>(node.tag)).put(node.x).put(node.y).put(node.z).end_row();
  w.out += "\n$EndNodes\n$Elements\n" + std::to_string(sample.elements.size()) + "\n";
  for (std::size_t k = 0; k < sample.elements.size();) {
    std::size_t end = k;
    while (end < sample.elements.size() && sample.elements[end].type == sample.elements[k].type) ++end;
    if (kind.binary) w.put(sample.elements[k].type).put(static_cast<std::int32_t>(end - k)).put(std::int32_t{2});
    for (; k < end; ++k) {
      const auto& element = sample.elements[k];
      w.put(static_cast<std::int32_t>(element.tag));
      if (!kind.binary) w.put(element.type).put(2);
      w.put(element.physical).put(element.entity);
      for (const std::int64_t node : element.nodes) w.put(static_cast<std::int32_t>(node));
      w.end_row();
    }
  }
  w.out += "\n$EndElements\n";
  return w.out;
}

inline std::string write_msh_4(const MshSample& sample, const MshKind& kind) {
  using Size = std::uint64_t;
  const auto size = [](auto value) { return static_cast<Size>(value); };
  MshWriter w(kind);
  std::array<std::map<int, std::set<int>>, 4> entities;  // tag -> physical groups
  for (const auto& element : sample.elements)
    entities[static_cast<std::size_t>(msh_dimension(element.type))][element.entity].insert(element.physical);
  w.out += "$Entities\n";
  for (const auto& of : entities) w.put(size(of.size()));
  w.end_row();
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (auto [tag, groups] : entities[dimension]) {
      groups.erase(0);
      w.put(tag);
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) w.put(0.5);
      w.put(size(groups.size()));
      for (const int group : groups) w.put(group);
      if (dimension > 0) w.put(size(1)).put(-7);
      w.end_row();
    }
  constexpr std::size_t block = 7;
  w.out += "\n$EndEntities\n$Nodes\n";
  w.put(size((sample.nodes.size() + block - 1) / block)).put(size(sample.nodes.size())).put(size(1)).put(size(9));
  w.end_row();
  for (std::size_t first = 0; first < sample.nodes.size(); first += block) {
    const std::size_t end = std::min(first + block, sample.nodes.size());
    const bool parametric = first % 2 == 1;
    w.put(2).put(5).put(parametric ? 1 : 0).put(size(end - first)).end_row();
    for (std::size_t k = first; k < end; ++k) w.put(size(sample.nodes[k].tag)).end_row();
    for (std::size_t k = first; k < end; ++k) {
      w.put(sample.nodes[k].x).put(sample.nodes[k].y).put(sample.nodes[k].z);
      if (parametric) w.put(0.1).put(0.2);
      w.end_row();
    }
  }
  const auto same = [](const MshSample::Element& a, const MshSample::Element& b) {
    return a.type == b.type && a.entity == b.entity;
  };
  Size blocks = 0;
  for (std::size_t k = 0; k < sample.elements.size(); ++k)
    blocks += k == 0 || !same(sample.elements[k], sample.elements[k - 1]);
  w.out += "\n$EndNodes\n$Elements\n";
  w.put(blocks).put(size(sample.elements.size())).put(size(1)).put(size(9)).end_row();
  for (std::size_t k = 0; k < sample.elements.size();) {
    std::size_t end = k;
    while (end < sample.elements.size() && same(sample.elements[end], sample.elements[k])) ++end;
    const auto& first = sample.elements[k];
    w.put(msh_dimension(first.type)).put(first.entity).put(first.type).put(size(end - k)).end_row();
    for (; k < end; ++k) {
      w.put(size(sample.elements[k].tag));
      for (const std::int64_t node : sample.elements[k].nodes) w.put(size(node));
      w.end_row();
    }
  }
  w.out += "\n$EndElements\n";
  return w.out;
}

inline std::string write_msh(const MshSample& sample, const MshKind& kind) {
  std::string out =
      std::string("$MeshFormat\n") + (kind.version == 2 ? "2.2" : "4.1") + (kind.binary ? " 1" : " 0") + " 8\n";
  if (kind.binary) {
    MshWriter one(kind);
    out += one.put(std::int32_t{1}).out + "\n";
  }
  out += "$EndMeshFormat\n";
  if (!sample.names.empty()) {
    out += "$PhysicalNames\n" + std::to_string(sample.names.size()) + "\n";
    for (const auto& name : sample.names)
      out += std::to_string(name.dimension) + " " + std::to_string(name.tag) + " \"" + name.name + "\"\n";
    out += "$EndPhysicalNames\n";
  }
  return out + (kind.version == 2 ? write_msh_2(sample, kind) : write_msh_4(sample, kind)) + sample.tail;
}

/// Gmsh's numbers of the triangle and the line of each order.
inline constexpr std::array<int, 11> msh_triangle_types = {0, 2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
inline constexpr std::array<int, 11> msh_line_types = {0, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66};

/// Exponents (i, j) of the nodes of a triangle in Gmsh's order, by the words of its manual: corners, edges, and then
/// the inner nodes as an element of their own.
inline std::vector<std::array<int, 2>> msh_triangle_nodes(int order) {
  if (order == 0) return {{0, 0}};
  std::vector<std::array<int, 2>> nodes = {{order, 0}, {0, order}, {0, 0}};
  for (int e = 0; e < 3; ++e)
    for (int k = 1; k < order; ++k) {
      const auto &a = nodes[static_cast<std::size_t>(e)], &b = nodes[static_cast<std::size_t>((e + 1) % 3)];
      nodes.push_back({a[0] + k * (b[0] - a[0]) / order, a[1] + k * (b[1] - a[1]) / order});
    }
  if (order >= 3)
    for (const auto& [i, j] : msh_triangle_nodes(order - 3)) nodes.push_back({i + 1, j + 1});
  return nodes;
}

/// The Lagrange nodes of a mesh. The tag of point p is `tag(p)`; lines on all constrained edges, group 10 + curve, of
/// an entity of the same number; face f is group 20 + f, entity 30 + f.
template <class Tag>
MshSample msh_of(const MeshData& mesh, Tag tag) {
  MshSample sample;
  const int p = mesh.degree;
  const NetLayout& layout = NetLayout::of(p);
  const auto size = static_cast<std::size_t>(layout.size());
  std::vector<Point> nodes(mesh.points.size());
  const auto point = [&](PointId id) { return mesh.points[static_cast<std::size_t>(id)]; };
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    const int number = 10 + edge.curve;
    MshSample::Element line{msh_line_types[static_cast<std::size_t>(p)],
                            static_cast<std::int64_t>(sample.elements.size()) + 5,
                            number,
                            number,
                            {}};
    line.nodes = {tag(edge.points.front()), tag(edge.points.back())};
    for (int k = 1; k < p; ++k) line.nodes.push_back(tag(edge.points[static_cast<std::size_t>(k)]));
    sample.elements.push_back(line);
  }
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t) {
    const PointId* net = &mesh.triangles[t * size];
    std::vector<double> values;
    for (std::size_t k = 0; k < size; ++k) {
      values.push_back(point(net[k]).x);
      values.push_back(point(net[k]).y);
    }
    MshSample::Element triangle{msh_triangle_types[static_cast<std::size_t>(p)],
                                static_cast<std::int64_t>(1000 + t),
                                20 + mesh.triangle_faces[t],
                                30 + mesh.triangle_faces[t],
                                {}};
    for (const auto& [i, j] : msh_triangle_nodes(p)) {
      const int index = layout.index(i, j);
      std::array<double, 2> value;
      const double q = p;
      evaluate_net(p, 2, values, Barycentric{i / q, j / q, (p - i - j) / q}, value);
      if (index < 3) value = {point(net[index]).x, point(net[index]).y};
      nodes[static_cast<std::size_t>(net[index])] = {value[0], value[1]};
      triangle.nodes.push_back(tag(net[index]));
    }
    sample.elements.push_back(triangle);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k)
    sample.nodes.push_back({tag(static_cast<PointId>(k)), nodes[k].x, nodes[k].y, 0.25});
  return sample;
}
inline MshSample msh_of(const MeshData& mesh) {
  return msh_of(mesh, [](PointId p) { return std::int64_t{p} + 1; });
}

}  // namespace pliant::samples

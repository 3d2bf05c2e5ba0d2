// formats/msh/msh_writer.cpp: writes Gmsh's MSH files, versions 4.1 and 2.2, text and binary (formats/msh.md).
#include "formats/msh/msh_writer.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "formats/msh/msh_field_writer.h"
#include "formats/msh/msh_file.h"
#include "formats/msh/msh_rows.h"
#include "formats/picture/mesh_edges.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

int type_of(MshElementType::Family family, int order) {
  int type = 1;
  while (msh_element_type(type).family != family || msh_element_type(type).order != order) ++type;
  return type;
}

class MshWriter {
 public:
  MshWriter(const MeshData& mesh, const MshWriteOptions& options, std::string& out)
      : mesh_(mesh),
        layout_(NetLayout::of(mesh.degree)),
        is_4_(options.version == MshWriteOptions::Version::v4_1),
        binary_(options.binary),
        rows_(out, options.binary) {
    place_nodes();
    sort_out();
    own_nodes();
    name_groups();
  }

  void run() {
    rows_.line("$MeshFormat");
    rows_.line(std::string(is_4_ ? "4.1" : "2.2") + (binary_ ? " 1 8" : " 0 8"));
    if (binary_) {
      rows_.put(std::int32_t{1});
      rows_.line("");
    }
    rows_.line("$EndMeshFormat");
    write_names();
    if (is_4_) {
      write_entities();
      write_nodes_4();
      write_elements_4();
    } else {
      write_nodes_2();
      write_elements_2();
    }
    if (mesh_.fields.empty()) return;
    std::vector<char> used(nodes_.size(), 0);
    for (const auto* entities : {&points_, &curves_, &faces_})
      for (const Entity& entity : *entities)
        for (const PointId p : entity.nodes) used[index(p)] = 1;
    write_msh_fields(mesh_, order_, used, rows_);
  }

 private:
  /// A geometrical entity with its elements, nodes and boundary.
  struct Entity {
    int tag = 0;
    std::int32_t group = 0;
    std::vector<std::int32_t> parts;  ///< constrained edges of a curve by span, or triangles of a face
    std::vector<PointId> nodes;       ///< nodes on it that are in no entity of lower dimension
    std::vector<int> bounds;          ///< tags of the entities that bound it, with signs
  };

  const PointId* net(std::int32_t t) const { return &mesh_.triangles[index(t) * index(layout_.size())]; }

  /// Computes the nodes: each triangle's values at its lattice. Nodes inside an edge come from the edge alone, once.
  void place_nodes() {
    const int p = mesh_.degree;
    nodes_ = mesh_.points;
    std::vector<Point> points(index(layout_.size()));
    for (const MeshEdge& edge : find_edges(mesh_).edges) {
      for (std::size_t k = 0; k <= index(p); ++k) points[k] = mesh_.points[index(edge.points[k])];
      for (int k = 1; k < p; ++k)
        evaluate_polygon(p, 2, {&points[0].x, 2 * index(p + 1)}, double(k) / p,
                         {&nodes_[index(edge.points[index(k)])].x, 2});
    }
    for (std::size_t t = 0; t < mesh_.triangle_faces.size() && p > 2; ++t) {
      const PointId* own = net(static_cast<std::int32_t>(t));
      for (std::size_t k = 0; k < points.size(); ++k) points[k] = mesh_.points[index(own[k])];
      for (int k = layout_.first_interior(); k < layout_.size(); ++k) {
        const auto& [i, j, l] = layout_.exponents(k);
        evaluate_net(p, 2, {&points[0].x, 2 * points.size()}, {double(i) / p, double(j) / p, double(l) / p},
                     {&nodes_[index(own[k])].x, 2});
      }
    }
  }

  void sort_out() {
    const BoundaryComplex& boundary = mesh_.boundary;
    points_.resize(boundary.vertices.size());
    curves_.resize(boundary.curves.size());
    faces_.resize(boundary.faces.size());
    for (auto* entities : {&points_, &curves_, &faces_})
      for (std::size_t k = 0; k < entities->size(); ++k) (*entities)[k].tag = static_cast<int>(k) + 1;
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e)
      curves_[index(mesh_.constrained_edges[e].curve)].parts.push_back(static_cast<std::int32_t>(e));
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      std::sort(curves_[c].parts.begin(), curves_[c].parts.end(), [&](std::int32_t a, std::int32_t b) {
        return mesh_.constrained_edges[index(a)].span < mesh_.constrained_edges[index(b)].span;
      });
      const Curve& curve = boundary.curves[c];
      if (curve.start != no_vertex) curves_[c].bounds = {curve.start + 1, curve.end + 1};
      if (curve.left != outside) faces_[index(curve.left)].bounds.push_back(curves_[c].tag);
      if (curve.right != outside) faces_[index(curve.right)].bounds.push_back(-curves_[c].tag);
    }
    for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t)
      faces_[index(mesh_.triangle_faces[t])].parts.push_back(static_cast<std::int32_t>(t));
  }

  /// Gives each node to the entity of the lowest dimension that it lies on.
  void own_nodes() {
    std::vector<Entity*> owners(nodes_.size(), nullptr);
    for (Entity& face : faces_)
      for (const std::int32_t t : face.parts)
        for (int k = 0; k < layout_.size(); ++k) owners[index(net(t)[k])] = &face;
    for (Entity& curve : curves_) {
      if (curve.parts.empty()) continue;
      for (const std::int32_t e : curve.parts)
        for (const PointId p : mesh_.constrained_edges[index(e)].points) owners[index(p)] = &curve;
    }
    for (const Entity& curve : curves_) {
      if (curve.parts.empty() || curve.bounds.empty()) continue;
      owners[index(mesh_.constrained_edges[index(curve.parts.front())].points.front())] =
          &points_[index(curve.bounds[0] - 1)];
      owners[index(mesh_.constrained_edges[index(curve.parts.back())].points.back())] =
          &points_[index(curve.bounds[1] - 1)];
    }
    for (std::size_t p = 0; p < owners.size(); ++p)
      if (owners[p]) owners[p]->nodes.push_back(static_cast<PointId>(p));
    const auto keep_used = [](std::vector<Entity>& entities) {
      std::erase_if(entities, [](const Entity& entity) { return entity.parts.empty() && entity.nodes.empty(); });
    };
    keep_used(points_);
    keep_used(curves_);
    keep_used(faces_);
  }

  /// Makes a physical group for each face and for each name of curves, which curves of one name share.
  void name_groups() {
    for (Entity& face : faces_) {
      face.group = face.tag;
      names_[{2, face.group}] = mesh_.boundary.faces[index(face.tag - 1)].name;
    }
    std::map<std::string, std::int32_t> known;
    for (Entity& curve : curves_) {
      const std::string& name = mesh_.boundary.curves[index(curve.tag - 1)].name;
      if (name.empty()) continue;
      curve.group = known.emplace(name, static_cast<std::int32_t>(known.size()) + 1).first->second;
      names_[{1, curve.group}] = name;
    }
  }

  void write_names() {
    std::erase_if(names_, [](const auto& entry) { return entry.second.empty(); });
    if (names_.empty()) return;
    rows_.line("$PhysicalNames");
    rows_.line(std::to_string(names_.size()));
    for (const auto& [key, name] : names_)
      rows_.line(std::to_string(key.first) + " " + std::to_string(key.second) + " " + msh_quoted(name));
    rows_.line("$EndPhysicalNames");
  }

  Box box_of(const Entity& entity, int dimension) const {
    Box box;
    for (const std::int32_t part : entity.parts) {
      if (dimension == 1)
        for (const PointId p : mesh_.constrained_edges[index(part)].points) box.extend(nodes_[index(p)]);
      else
        for (int k = 0; k < layout_.size(); ++k) box.extend(nodes_[index(net(part)[k])]);
    }
    return box;
  }

  void write_entities() {
    rows_.line("$Entities");
    rows_.size(points_.size()).size(curves_.size()).size(faces_.size()).size(0).end_row();
    for (const Entity& point : points_) {
      rows_.put(point.tag).put(nodes_[index(point.nodes.front())]).size(0);
      rows_.end_row();
    }
    for (const int dimension : {1, 2})
      for (const Entity& entity : dimension == 1 ? curves_ : faces_) {
        const Box box = box_of(entity, dimension);
        rows_.put(entity.tag).put(box.low).put(box.high).size(entity.group != 0);
        if (entity.group != 0) rows_.put(entity.group);
        rows_.size(entity.bounds.size());
        for (std::size_t k = 0; k < entity.bounds.size(); ++k)
          rows_.put(dimension == 1 && k == 1 ? -entity.bounds[k] : entity.bounds[k]);
        rows_.end_row();
      }
    rows_.end_section("Entities");
  }

  std::size_t used_nodes() const {
    std::size_t count = 0;
    for (const auto* entities : {&points_, &curves_, &faces_})
      for (const Entity& entity : *entities) count += entity.nodes.size();
    return count;
  }

  void write_nodes_4() {
    std::size_t blocks = 0;
    PointId least = static_cast<PointId>(nodes_.size()), greatest = 0;
    for (const auto* entities : {&points_, &curves_, &faces_})
      for (const Entity& entity : *entities) {
        if (entity.nodes.empty()) continue;
        ++blocks;
        least = std::min(least, entity.nodes.front());
        greatest = std::max(greatest, entity.nodes.back());
      }
    rows_.line("$Nodes");
    rows_.size(blocks).size(used_nodes()).size(index(least) + 1).size(index(greatest) + 1).end_row();
    std::int32_t dimension = 0;
    for (const auto* entities : {&points_, &curves_, &faces_}) {
      for (const Entity& entity : *entities) {
        if (entity.nodes.empty()) continue;
        rows_.put(dimension).put(entity.tag).put(std::int32_t{0}).size(entity.nodes.size()).end_row();
        for (const PointId p : entity.nodes) rows_.size(index(p) + 1).end_row();
        for (const PointId p : entity.nodes) rows_.put(nodes_[index(p)]).end_row();
      }
      ++dimension;
    }
    rows_.end_section("Nodes");
  }

  void write_nodes_2() {
    std::vector<PointId> used;
    for (const auto* entities : {&points_, &curves_, &faces_})
      for (const Entity& entity : *entities) used.insert(used.end(), entity.nodes.begin(), entity.nodes.end());
    std::sort(used.begin(), used.end());
    rows_.line("$Nodes");
    rows_.line(std::to_string(used.size()));
    for (const PointId p : used) rows_.put(p + 1).put(nodes_[index(p)]).end_row();
    rows_.end_section("Nodes");
  }

  /// Calls use(dimension, entity, type) for each entity that has elements.
  template <class Use>
  void each_block(Use&& use) const {
    for (const std::int32_t dimension : {1, 2})
      for (const Entity& entity : dimension == 1 ? curves_ : faces_)
        if (!entity.parts.empty())
          use(dimension, entity,
              type_of(dimension == 1 ? MshElementType::line : MshElementType::triangle, mesh_.degree));
  }
  std::size_t element_count() const { return mesh_.constrained_edges.size() + mesh_.triangle_faces.size(); }
  std::size_t element_tag(int dimension, std::int32_t part) const {
    return 1 + index(part) + (dimension == 1 ? mesh_.triangle_faces.size() : 0);
  }

  /// Calls put(tag) for each node of a line or triangle in Gmsh's order.
  template <class Put>
  void each_node(int dimension, std::int32_t part, Put&& put) const {
    if (dimension == 2) {
      for (const int k : order_) put(net(part)[k] + 1);
      return;
    }
    const std::vector<PointId>& points = mesh_.constrained_edges[index(part)].points;
    put(points.front() + 1);
    put(points.back() + 1);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) put(points[k] + 1);
  }

  void write_elements_4() {
    std::size_t blocks = 0;
    each_block([&](std::int32_t, const Entity&, std::int32_t) { ++blocks; });
    rows_.line("$Elements");
    rows_.size(blocks).size(element_count()).size(1).size(element_count()).end_row();
    each_block([&](std::int32_t dimension, const Entity& entity, std::int32_t type) {
      rows_.put(dimension).put(entity.tag).put(type).size(entity.parts.size()).end_row();
      for (const std::int32_t part : entity.parts) {
        rows_.size(element_tag(dimension, part));
        each_node(dimension, part, [&](PointId tag) { rows_.size(index(tag)); });
        rows_.end_row();
      }
    });
    rows_.end_section("Elements");
  }

  void write_elements_2() {
    rows_.line("$Elements");
    rows_.line(std::to_string(element_count()));
    each_block([&](std::int32_t dimension, const Entity& entity, std::int32_t type) {
      constexpr std::int32_t tags = 2;
      if (binary_) rows_.put(type).put(static_cast<std::int32_t>(entity.parts.size())).put(tags);
      for (const std::int32_t part : entity.parts) {
        rows_.put(static_cast<std::int32_t>(element_tag(dimension, part)));
        if (!binary_) rows_.put(type).put(tags);
        rows_.put(entity.group).put(entity.tag);
        each_node(dimension, part, [&](PointId tag) { rows_.put(tag); });
        rows_.end_row();
      }
    });
    rows_.end_section("Elements");
  }

  const MeshData& mesh_;
  const NetLayout& layout_;
  bool is_4_, binary_;
  MshRows rows_;
  const std::vector<int> order_ = msh_net_order(mesh_.degree);
  std::vector<Point> nodes_;
  std::vector<Entity> points_, curves_, faces_;
  std::map<std::pair<int, std::int32_t>, std::string> names_;  // names of physical groups, by dimension and tag
};

}  // namespace

void write_msh(const MeshData& mesh, const MshWriteOptions& options, std::string& out) {
  MshWriter(mesh, options, out).run();
}

}  // namespace pliant

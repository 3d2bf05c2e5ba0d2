// formats/msh/msh.cpp: from what the file says to a mesh, and what to tell about it.
#include "formats/msh/msh.h"

#include <algorithm>
#include <set>

#include "formats/document/characters.h"
#include "formats/msh/msh_fields.h"
#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

std::string count_of(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

class Import {
 public:
  Import(MshFile& file, const MshOptions& options) : file_(file), options_(options) {}

  MshImport run() {
    resolve_groups();
    drop_repeated();
    const bool is_mixed = find_degree();
    make_faces();
    check_plane();
    if (is_mixed)
      warn(take_mixed_nets(file_, mesh()));
    else
      take_nets(file_, mesh());
    MshViews views = read_views(file_, mesh(), options_.step);
    for (std::string& text : views.warnings) warn(std::move(text));
    result_.no_step = views.no_step;
    mesh().time = views.time;
    if (options_.orient) turned_ = orient_triangles(mesh());
    const EdgeFindings findings = pair_edges(mesh(), !is_mixed);
    warn_of_clockwise(findings);
    warn(name_double_nodes(file_, mesh(), findings.open));
    for (MshViews::View& view : views.views) {
      mesh().fields.push_back(std::move(view.values).take(mesh(), view.by_face));
      mesh().fields.back().name = view.name;
    }
    drop_unused(findings.uses);
    for (std::string& text : trace_curves(file_, findings.open, mesh())) warn(std::move(text));
    warn_of_the_rest();
    result_.elements = std::move(file_.triangle_tags);
    std::uint64_t next_tag = file_.tags.highest() + 1;
    while (result_.nodes.size() < mesh().points.size()) result_.nodes.add(next_tag++);
    return std::move(result_);
  }

 private:
  MeshData& mesh() { return result_.mesh; }
  void warn(std::string text) {
    if (!text.empty()) result_.warnings.push_back(std::move(text));
  }

  /// Gives each block and line its physical group, which MSH 4.0 and 4.1 keep with the entities.
  void resolve_groups() {
    if (file_.entities.empty()) return;
    bool has_more = false;
    const auto resolve = [&](int dimension, int& entity, int& physical) {
      const auto found = file_.entities.find({dimension, entity});
      if (found == file_.entities.end()) return;
      physical = found->second.physical;
      has_more = has_more || found->second.has_more;
      if (found->second.parent != 0) entity = found->second.parent;
    };
    for (MshTriangles& block : file_.blocks) resolve(2, block.entity, block.physical);
    for (MshLine& line : file_.lines) resolve(1, line.entity, line.physical);
    if (has_more) warn_of_several_groups();
  }
  void warn_of_several_groups() { warn("elements in several physical groups count for the first one"); }

  /// Keeps the first of equal elements: MSH 2.2 lists an element once for each physical group of its entity.
  void drop_repeated() {
    std::map<int, std::set<int>> groups;
    for (const MshTriangles& block : file_.blocks) groups[block.entity].insert(block.physical);
    const auto is_doubtful = [&](const MshTriangles& block) { return groups[block.entity].size() > 1; };
    if (std::none_of(file_.blocks.begin(), file_.blocks.end(), is_doubtful)) return;
    struct Listed {
      const PointId* nodes;
      std::size_t size, triangle;
      int physical;
      bool is_before(const Listed& b) const {
        return std::lexicographical_compare(nodes, nodes + size, b.nodes, b.nodes + b.size);
      }
    };
    std::vector<Listed> all;
    std::size_t t = 0;
    const PointId* nodes = file_.triangle_nodes.data();
    for (const MshTriangles& block : file_.blocks) {
      const std::size_t size = index(net_size(block.order));
      const bool doubtful = is_doubtful(block);
      for (std::size_t k = 0; k < block.count; ++k, ++t, nodes += size)
        if (doubtful) all.push_back({nodes, size, t, block.physical});
    }
    std::stable_sort(all.begin(), all.end(), [](const Listed& a, const Listed& b) { return a.is_before(b); });
    std::vector<char> gone(t, 0);
    bool any = false;
    for (std::size_t k = 1, first = 0; k < all.size(); ++k) {
      if (all[first].is_before(all[k]))
        first = k;
      else if (all[k].physical != all[first].physical)
        gone[all[k].triangle] = any = true;
    }
    if (!any) return;
    warn_of_several_groups();
    std::vector<PointId> kept;
    TagRuns tags;
    t = 0;
    nodes = file_.triangle_nodes.data();
    for (MshTriangles& block : file_.blocks) {
      const std::size_t size = index(net_size(block.order)), count = block.count;
      for (std::size_t k = 0; k < count; ++k, ++t, nodes += size) {
        if (gone[t]) {
          --block.count;
          continue;
        }
        kept.insert(kept.end(), nodes, nodes + size);
        tags.add(file_.triangle_tags.tag_of(t));
      }
    }
    file_.triangle_nodes = std::move(kept);
    file_.triangle_tags = std::move(tags);
  }

  /// Makes the highest order the degree of the mesh. True if there are triangles of lower orders.
  bool find_degree() {
    int low = max_degree, high = 0;
    for (const MshTriangles& block : file_.blocks)
      if (block.count > 0) {
        low = std::min(low, block.order);
        high = std::max(high, block.order);
      }
    if (high == 0) {
      std::string text = "the file has no triangles";
      for (std::size_t type = 0; type < file_.left_out.size(); ++type)
        if (file_.left_out[type] > 0)
          text += "; it has " + describe_left_out(static_cast<std::int64_t>(type), file_.left_out[type]);
      throw InputError("", text);
    }
    mesh().degree = high;
    if (low < high)
      warn("the triangles have orders from " + std::to_string(low) + " to " + std::to_string(high) +
           ": all are raised to " + std::to_string(high));
    return low < high;
  }

  void make_faces() {
    std::map<std::pair<bool, int>, FaceId> known;
    std::set<std::string> names;
    mesh().triangle_faces.reserve(file_.triangle_tags.size());
    for (const MshTriangles& block : file_.blocks) {
      if (block.count == 0) continue;
      const bool is_group = block.physical != 0;
      const int tag = is_group ? std::abs(block.physical) : block.entity;
      const auto [place, is_new] = known.emplace(std::pair(is_group, tag), static_cast<FaceId>(known.size()));
      if (is_new) {
        std::string name = (is_group ? "physical surface " : "surface ") + std::to_string(tag);
        if (const auto named = file_.names.find({2, tag});
            is_group && named != file_.names.end() && !named->second.empty())
          name = msh_name(named->second);
        // Different groups of one name stay different faces.
        while (!names.insert(name).second) name += " (" + std::to_string(tag) + ")";
        mesh().boundary.faces.push_back({name, {}});
      }
      mesh().triangle_faces.insert(mesh().triangle_faces.end(), block.count, place->second);
    }
  }

  /// Checks that the nodes of triangles lie in one plane of constant z. Other nodes may lie anywhere.
  void check_plane() {
    if (file_.z.empty()) return;
    Box box;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const PointId p : file_.triangle_nodes) {
      box.extend(file_.nodes[index(p)]);
      low = std::fmin(low, file_.z[index(p)]);
      high = std::fmax(high, file_.z[index(p)]);
    }
    if (high - low <= 1e-12 * box.size()) return;
    const double first = file_.z[index(file_.triangle_nodes.front())];
    for (const PointId p : file_.triangle_nodes)
      if (!(std::fabs(file_.z[index(p)] - first) <= 1e-12 * box.size()))
        throw InputError("node " + std::to_string(file_.tags.tag_of(p)),
                         "has z = " + std::to_string(file_.z[index(p)]) + " where the first triangle has z = " +
                             std::to_string(first) + ": only meshes in a plane of constant z are read");
  }

  void warn_of_clockwise(const EdgeFindings& findings) {
    const std::size_t count = findings.clockwise, all = mesh().triangle_faces.size();
    if (turned_ > 0) warn(count_of(turned_, "triangle") + " turned to run counter-clockwise");
    if (count > 0)
      warn(std::to_string(count) + " of " + count_of(all, "triangle") + (count == 1 ? " runs" : " run") +
           " clockwise (first: element " + std::to_string(file_.triangle_tags.tag_of(findings.first_clockwise)) + ")" +
           (options_.orient ? " among neighbours that do not" : "; import-msh --orient turns whole parts that do"));
  }

  /// Drops the nodes that no triangle uses: points of the geometry, nodes of other elements.
  void drop_unused(const std::vector<std::int32_t>& uses) {
    result_.nodes = file_.tags.all();
    if (std::find(uses.begin(), uses.end(), unused_point) == uses.end()) return;
    result_.nodes = {};
    std::vector<PointId> number(uses.size(), none);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < uses.size(); ++p) {
      if (uses[p] == unused_point) continue;
      number[p] = static_cast<PointId>(kept);
      if (p < file_.tags.size()) result_.nodes.add(file_.tags.tag_of(static_cast<PointId>(p)));
      mesh().points[kept++] = mesh().points[p];
    }
    mesh().points.resize(kept);
    for (Field& field : mesh().fields) drop_values(field, number);
    for (PointId& p : mesh().triangles) p = number[index(p)];
    // Lines whose ends belong to no triangle are kept, so that the warning counts them.
    for (MshLine& line : file_.lines) {
      line.from = number[index(line.from)];
      line.to = number[index(line.to)];
    }
  }

  /// Renumbers the points of a field; those without a new number are dropped.
  static void drop_values(Field& field, const std::vector<PointId>& number) {
    // All places of a field by face are places of triangles.
    for (auto& place : field.places) place[0] = number[index(place[0])];
    if (field.by_face) return;
    const std::size_t width = index(field.components);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < number.size(); ++p) {
      if (number[p] == none) continue;
      for (std::size_t c = 0; c < width; ++c) field.values[kept * width + c] = field.values[p * width + c];
      ++kept;
    }
    field.values.resize(kept * width);
  }

  void warn_of_the_rest() {
    for (std::size_t type = 0; type < file_.left_out.size(); ++type)
      if (const std::uint64_t count = file_.left_out[type]; count > 0)
        (type == msh_point_type ? result_.notes : result_.warnings)
            .push_back(describe_left_out(static_cast<std::int64_t>(type), count) + (count == 1 ? " is" : " are") +
                       " left out");
    std::string sections;
    for (const std::string& name : file_.skipped) sections += (sections.empty() ? "" : ", ") + ("$" + name);
    if (!sections.empty()) warn("not read: " + sections);
  }

  MshFile& file_;
  MshOptions options_;
  MshImport result_;
  std::size_t turned_ = 0;
};

}  // namespace

std::string msh_name(const std::string& bytes) {
  if (find_no_utf8(bytes) == nullptr) return bytes;
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xc0 | byte >> 6);
      text += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return text;
}

MshImport read_msh(std::string_view bytes, const MshOptions& options) {
  MshFile file = read_msh_file(bytes);
  return Import(file, options).run();
}

}  // namespace pliant

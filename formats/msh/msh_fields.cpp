// formats/msh/msh_fields.cpp: reads the values of one time step of each view, and decides what field they make.
#include "formats/msh/msh_fields.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "formats/msh/msh_basis.h"
#include "formats/msh/msh_mesh.h"
#include "formats/msh/msh_views.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// Finds triangles by the tags of their elements.
class TriangleTags {
 public:
  explicit TriangleTags(const TagRuns& tags) {
    const std::vector<TagRuns::Run>& runs = tags.runs();
    for (std::size_t k = 0; k < runs.size(); ++k)
      ranges_.push_back(
          {runs[k].tag, (k + 1 < runs.size() ? runs[k + 1].first : tags.size()) - runs[k].first, runs[k].first});
    std::sort(ranges_.begin(), ranges_.end(), [](const Range& a, const Range& b) { return a.tag < b.tag; });
    for (std::size_t k = 1; k < ranges_.size(); ++k)
      unique_ = unique_ && ranges_[k].tag - ranges_[k - 1].tag >= ranges_[k - 1].count;
  }
  bool are_unique() const { return unique_; }
  std::optional<std::size_t> find(std::uint64_t tag) {
    if (last_ < ranges_.size() && tag - ranges_[last_].tag < ranges_[last_].count)
      return ranges_[last_].first + static_cast<std::size_t>(tag - ranges_[last_].tag);
    const auto behind = std::upper_bound(ranges_.begin(), ranges_.end(), tag,
                                         [](std::uint64_t wanted, const Range& range) { return wanted < range.tag; });
    if (behind == ranges_.begin()) return std::nullopt;
    last_ = static_cast<std::size_t>(behind - ranges_.begin()) - 1;
    const std::uint64_t place = tag - ranges_[last_].tag;
    if (place >= ranges_[last_].count) return std::nullopt;
    return ranges_[last_].first + static_cast<std::size_t>(place);
  }

 private:
  struct Range {
    std::uint64_t tag, count;
    std::size_t first;
  };
  std::vector<Range> ranges_;
  std::size_t last_ = 0;
  bool unique_ = true;
};

/// What makes a view no field of the mesh.
struct LeftOut {
  std::string why;
};

class ViewReader {
 public:
  ViewReader(const MshFile& file, const MeshData& mesh)
      : file_(file), mesh_(mesh), triangles_(file.triangle_tags), size_(index(net_size(mesh.degree))) {
    std::vector<char> used(mesh.points.size(), 0);
    const std::vector<PointId>& nodes = is_mixed() ? file.triangle_nodes : mesh.triangles;
    for (const PointId p : nodes) used[index(p)] = 1;
    for (std::size_t p = 0; p < used.size(); ++p)
      if (used[p]) used_.push_back(static_cast<PointId>(p));
  }

  /// The view whose sections these are.   Throws LeftOut
  MshNodalField read(const std::vector<const MshDataSection*>& sections) {
    const MshDataSection& first = *sections.front();
    std::uint64_t entries = 0;
    for (const MshDataSection* section : sections) {
      if (section->components != first.components || section->scheme != first.scheme)
        throw LeftOut{"its sections differ in components or interpolation scheme"};
      entries += section->entries;
    }
    const MshScheme* scheme = nullptr;
    if (!first.scheme.empty()) {
      const auto found = file_.schemes.find(first.scheme);
      if (found == file_.schemes.end()) throw LeftOut{"the file has no interpolation scheme " + first.scheme};
      scheme = &found->second;
    }
    const bool is_nodal = first.kind == MshDataSection::node;
    if (!is_nodal && !triangles_.are_unique())
      throw LeftOut{"several triangles have the same tag, and values of elements cannot be told apart"};
    const std::size_t wanted = is_nodal ? used_.size() : mesh_.triangle_faces.size();
    // Each entry takes bytes of the file, so that what follows costs no more than the file is long.
    if (entries < wanted)
      throw LeftOut{"it has " + std::to_string(entries) + " entries for " + std::to_string(wanted) +
                    (is_nodal ? " nodes of triangles" : " triangles")};
    MshNodalField field(mesh_, first.components);
    MshBasis& basis = bases_.try_emplace(scheme, mesh_.degree, scheme).first->second;
    is_nodal ? read_nodal(sections, scheme != nullptr, basis, field) : read_elements(sections, basis, field);
    const auto& jump = field.jump_inside_face();
    if (!field.is_rounding(jump.size))
      throw LeftOut{"its values jump inside a face (most at a node of element " + tag_of(jump.triangle) +
                    "), and fields are continuous there"};
    return field;
  }

 private:
  bool is_mixed() const { return !file_.triangle_nodes.empty(); }
  std::string tag_of(std::size_t t) const { return std::to_string(file_.triangle_tags.tag_of(t)); }

  template <bool swap>
  static void load_values(const char* at, std::vector<double>& values) {
    for (double& value : values) value = load<double, swap>(at), at += sizeof(double);
  }

  /// Calls use(tag, values, where) for each entry of a section.
  template <class Use>
  void each_entry(const MshDataSection& section, Use&& use) const {
    MshCursor in = section.in;
    const bool is_nodal = section.kind == MshDataSection::node;
    const auto width = index(section.components);
    std::vector<double> values;
    for (std::uint64_t k = 0; k < section.entries; ++k) {
      if (!in.binary) in.skip_space();
      const char* where = in.at();
      const std::int32_t tag = in.int32(is_nodal ? "a node's tag" : "an element's tag");
      if (tag < 0)
        in.fail_at(where, std::string(is_nodal ? "a node's" : "an element's") + " tag " + std::to_string(tag) +
                              " is negative");
      std::int32_t count = 1;
      if (section.kind == MshDataSection::element_node) {
        count = in.int32("an element's number of nodes");
        if (count < 1) in.fail("expected an element's number of nodes, found " + std::to_string(count));
        in.room_for(index(count), (in.binary ? 8 : 2) * width, "values");
      }
      values.resize(index(count) * width);
      if (in.binary) {
        const char* at = in.take(values.size(), sizeof(double), "values");
        in.swapped ? load_values<true>(at, values) : load_values<false>(at, values);
      } else {
        for (double& value : values) value = in.text_number("a value");
      }
      for (const double value : values)
        if (!(std::fabs(value) <= msh_largest))
          in.fail_at(where, "$" + std::string(section_name(section.kind)) + (is_nodal ? ", node " : ", element ") +
                                std::to_string(tag) + ": expected finite values up to 1e300");
      use(static_cast<std::uint64_t>(tag), values, in, where);
    }
    in.expect("$End" + std::string(section_name(section.kind)),
              (" behind " + std::to_string(section.entries) + " entries").c_str());
  }

  void read_nodal(const std::vector<const MshDataSection*>& sections, bool has_scheme, MshBasis& basis,
                  MshNodalField& field) const {
    const auto width = index(sections.front()->components);
    const bool is_direct = !has_scheme && !is_mixed();
    std::vector<char> has(file_.tags.size(), 0);
    std::vector<double> values(is_direct ? 0 : file_.tags.size() * width, 0.0);
    for (const MshDataSection* section : sections)
      each_entry(
          *section, [&](std::uint64_t tag, const std::vector<double>& row, const MshCursor& in, const char* where) {
            const PointId node = file_.tags.find(tag);
            if (node == none) in.fail_at(where, "there is no node of tag " + std::to_string(tag));
            has[index(node)] = 1;
            if (is_direct)
              field.set(node, row.data());
            else
              std::copy(row.begin(), row.end(), values.begin() + static_cast<std::ptrdiff_t>(index(node) * width));
          });
    std::size_t missing = 0;
    PointId first = none;
    for (const PointId p : used_)
      if (!has[index(p)] && missing++ == 0) first = p;
    if (missing > 0)
      throw LeftOut{"it has no value at " + std::to_string(missing) + " of " + std::to_string(used_.size()) +
                    " nodes of triangles (first: node " + std::to_string(file_.tags.tag_of(first)) + ")"};
    if (is_direct) return;
    std::vector<double> element, at_nodes(size_ * width);
    each_triangle([&](std::size_t t, const std::vector<PointId>& nodes) {
      element.clear();
      for (const PointId p : nodes)
        element.insert(element.end(), values.begin() + static_cast<std::ptrdiff_t>(index(p) * width),
                       values.begin() + static_cast<std::ptrdiff_t>((index(p) + 1) * width));
      set(t, nodes.size(), element, basis, at_nodes, field);
    });
  }

  /// Calls use(t, nodes) for each triangle, with its nodes in the order of the file.
  template <class Use>
  void each_triangle(Use&& use) const {
    std::vector<PointId> nodes;
    std::size_t t = 0;
    const PointId* own = file_.triangle_nodes.data();
    const std::vector<int> order = msh_net_order(mesh_.degree);
    for (const MshTriangles& block : file_.blocks)
      for (std::size_t k = 0; k < block.count; ++k, ++t) {
        nodes.clear();
        if (is_mixed()) {
          const auto count = static_cast<std::ptrdiff_t>(net_size(block.order));
          nodes.assign(own, own + count);
          own += count;
        } else {
          for (const int place : order) nodes.push_back(mesh_.triangles[t * size_ + index(place)]);
        }
        use(t, nodes);
      }
  }

  void read_elements(const std::vector<const MshDataSection*>& sections, MshBasis& basis, MshNodalField& field) {
    std::vector<char> has(mesh_.triangle_faces.size(), 0);
    std::vector<double> at_nodes(size_ * index(sections.front()->components));
    for (const MshDataSection* section : sections)
      each_entry(*section, [&](std::uint64_t tag, const std::vector<double>& row, const MshCursor&, const char*) {
        const std::optional<std::size_t> t = triangles_.find(tag);
        if (!t) return;  // another element's
        if (has[*t]) throw LeftOut{"element " + std::to_string(tag) + " has values twice"};
        has[*t] = 1;
        set(*t, row.size() / index(section->components), row, basis, at_nodes, field);
      });
    const auto missing = std::count(has.begin(), has.end(), 0);
    if (missing == 0) return;
    const auto first = static_cast<std::size_t>(std::find(has.begin(), has.end(), 0) - has.begin());
    throw LeftOut{"it has no values on " + std::to_string(missing) + " of " + std::to_string(has.size()) +
                  " triangles (first: element " + tag_of(first) + ")"};
  }

  void set(std::size_t t, std::size_t count, const std::vector<double>& values, MshBasis& basis,
           std::vector<double>& at_nodes, MshNodalField& field) const {
    if (const std::string why = basis.prepare(count); !why.empty())
      throw LeftOut{why + " (at element " + tag_of(t) + ")"};
    basis.apply(values.data(), values.size() / count, at_nodes.data());
    for (const double value : at_nodes)
      if (!(std::fabs(value) <= msh_largest)) throw LeftOut{"its values overflow at element " + tag_of(t)};
    field.set_triangle(t, at_nodes.data(), mesh_);
  }

  const MshFile& file_;
  const MeshData& mesh_;
  TriangleTags triangles_;
  std::size_t size_;
  std::vector<PointId> used_;                   ///< the nodes of the file that triangles have
  std::map<const MshScheme*, MshBasis> bases_;  ///< each scheme's, which costs more than a small view's values
};

/// Words of the third string tag that export-msh writes.
bool has_word(const std::string& mark, const std::string& word) {
  return (" " + mark + " ").find(" " + word + " ") != std::string::npos;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

MshViews read_views(const MshFile& file, const MeshData& mesh, std::optional<int> step) {
  MshViews result;
  if (file.data.empty()) return result;
  std::set<std::string> names;
  std::optional<ViewReader> reader;
  std::optional<double> time;
  bool several_times = false;
  std::string first_name;
  for (const MshView& view : group_views(file)) {
    std::string name = view.name.empty() ? "view" : msh_name(view.name);
    const std::string called = "the view " + name;
    for (int k = 2; names.count(name) > 0; ++k)
      name = (view.name.empty() ? "view" : msh_name(view.name)) + " (" + std::to_string(k) + ")";
    const auto count = static_cast<std::int64_t>(view.steps.size());
    std::int64_t number = count == 1 ? 0 : step.value_or(0);
    if (number < 0) number += count;
    if (number < 0 || number >= count) {
      result.no_step = called + " has " + std::to_string(count) + " steps";
      return result;
    }
    const auto chosen = std::next(view.steps.begin(), number);
    const MshDataSection& head = *chosen->second.front();
    try {
      if (!reader) reader.emplace(file, mesh);
      MshNodalField values = reader->read(chosen->second);
      bool by_face = head.kind != MshDataSection::node && values.differs_between_faces();
      if (head.kind != MshDataSection::node && has_word(head.mark, "by_face")) by_face = true;
      // Gmsh knows vectors of three components only: of a plane vector the third is 0.
      if (head.components == 3 && !has_word(head.mark, "components=3") && values.is_flat()) values.keep_components(2);
      result.views.push_back({name, by_face, std::move(values)});
      names.insert(name);
    } catch (const LeftOut& reason) {
      result.warnings.push_back(called + " is left out: " + reason.why);
      continue;
    }
    if (count > 1 && !step)
      result.warnings.push_back(called + " has " + std::to_string(count) + " time steps: the first is read, of time " +
                                number_text(head.time) + "; import-msh --step takes another");
    if (!time) {
      time = head.time;
      first_name = name;
    }
    several_times = several_times || head.time != *time;
  }
  if (several_times)
    result.warnings.push_back("the views have different times: that of " + first_name + ", " + number_text(*time) +
                              ", is the mesh's");
  result.time = time.value_or(0);
  return result;
}

}  // namespace pliant

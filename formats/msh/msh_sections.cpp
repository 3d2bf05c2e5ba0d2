// formats/msh/msh_sections.cpp: the header of an MSH file, its sections in turn, names of groups, entities.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "formats/msh/msh_file.h"

namespace pliant {
namespace {

class SectionReader {
 public:
  explicit SectionReader(std::string_view bytes) : in_(bytes) {}

  MshFile read() {
    for (in_.skip_space(); !in_.at_end(); in_.skip_space()) read_section();
    if (version_ == 0) fail_without_header(in_.at());
    if (!has("Nodes")) in_.fail("the file has no section $Nodes");
    if (!has("Elements")) in_.fail("the file has no section $Elements");
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail_without_header(const char* where) const {
    in_.fail_at(where, "expected " + std::string(msh_magic) + " (an MSH file), found " + in_.found_at(where));
  }

  void read_header() {
    in_.skip_space();
    const char* start = in_.at();
    const std::string_view version = in_.word();
    if (version == "4.1")
      version_ = 41;
    else if (version == "4" || version == "4.0")
      version_ = 40;
    else if (version == "2.2" || version == "2.1" || version == "2" || version == "2.0")
      version_ = 20;
    else
      in_.fail_at(start, "MSH version " + std::string(version.substr(0, 20)) +
                             ": versions 1, 2, 4.0 and 4.1 are read (gmsh -format msh41 writes one)");
    const std::int32_t type = in_.text_int("0 (text) or 1 (binary)");
    if (type != 0 && type != 1) in_.fail("the file type is " + std::to_string(type) + ", not 0 (text) or 1 (binary)");
    const std::int32_t size = in_.text_int("8, the size of numbers");
    if (size != 8) in_.fail("numbers of " + std::to_string(size) + " bytes: only those of 8 are read");
    in_.end_line("the file's format");
    if (type == 1) {
      in_.binary = true;
      const char* p = in_.take(1, 4, "bytes that tell their order");
      in_.swapped = load<std::int32_t, false>(p) != 1;
      if (in_.swapped && load<std::int32_t, true>(p) != 1)
        in_.fail_at(p, "expected the integer 1 in four bytes, lowest or highest first");
    }
    in_.expect("$EndMeshFormat", " behind the file's format");
  }

  bool has(std::string_view name) const { return std::find(seen_.begin(), seen_.end(), name) != seen_.end(); }

  /// Begins a section that is read: checks that the header and the section `needed` came before it, and that there are
  /// not too many of its kind.
  void begin(std::string_view name, const char* start, std::string_view needed = {}) {
    const std::string text(name);
    if (version_ == 0) in_.fail_at(start, "expected " + std::string(msh_magic) + " before $" + text);
    if (std::count(seen_.begin(), seen_.end(), name) == most_of_a_kind)
      in_.fail_at(start, "more than " + std::to_string(most_of_a_kind) + " sections $" + text + " are not read");
    if (!needed.empty() && !has(needed))
      in_.fail_at(start, "expected the section $" + std::string(needed) + " before $" + text);
    seen_.push_back(name);
  }

  void read_section() {
    const char* start = in_.at();
    if (*start != '$') {
      if (version_ == 0) fail_without_header(start);
      in_.fail("expected a section, which starts with $, found " + in_.found());
    }
    const std::string_view line = in_.line();
    const std::string_view name = line.substr(
        1, line.find_last_not_of(" \t") == std::string_view::npos ? line.npos : line.find_last_not_of(" \t"));
    const bool is_4 = version_ >= 40, is_4_0 = version_ == 40;
    if (name == "MeshFormat") {
      if (version_ != 0) in_.fail_at(start, "a second section $MeshFormat: only files with one are read");
      read_header();
    } else if ((name == "NOD" || name == "NOE") && (version_ == 0 || version_ == 1)) {
      version_ = 1;
      begin("Nodes", start);
      read_nodes_1(in_, file_);
      in_.expect("$END" + std::string(name), " behind the nodes");
    } else if (name == "ELM" && version_ == 1) {
      begin("Elements", start, "Nodes");
      read_elements_1(in_, file_);
      in_.expect("$ENDELM", " behind the elements");
    } else if (name == "Nodes" || (name == "ParametricNodes" && !is_4)) {
      begin("Nodes", start);
      is_4 ? read_nodes_4(in_, file_, is_4_0) : read_nodes_2(in_, file_, name == "ParametricNodes");
      in_.expect("$End" + std::string(name), " behind the nodes");
    } else if (name == "Elements") {
      begin("Elements", start, "Nodes");
      is_4 ? read_elements_4(in_, file_, is_4_0) : read_elements_2(in_, file_);
      in_.expect("$EndElements", " behind the elements");
    } else if (name == "PhysicalNames") {
      begin("PhysicalNames", start);
      read_names();
      in_.expect("$EndPhysicalNames", " behind the names");
    } else if (name == "Entities" && is_4) {
      begin("Entities", start);
      read_entities(false);
      in_.expect("$EndEntities", " behind the entities");
    } else if (name == "PartitionedEntities" && is_4) {
      begin("PartitionedEntities", start);
      read_entities(true);
      in_.expect("$EndPartitionedEntities", " behind the entities");
    } else if (name == "InterpolationScheme" && version_ >= 20) {
      read_scheme(in_, file_);
      in_.expect("$EndInterpolationScheme", " behind the scheme");
    } else if (const auto kind = data_kind(name); kind && version_ >= 20) {
      read_data_head(in_, file_, *kind, start);
    } else {
      skip_section(start, name);
    }
  }

  static std::optional<MshDataSection::Kind> data_kind(std::string_view name) {
    for (const auto kind : {MshDataSection::node, MshDataSection::element, MshDataSection::element_node})
      if (name == section_name(kind)) return kind;
    return std::nullopt;
  }

  void skip_section(const char* start, std::string_view name) {
    if (name.empty() || name.size() > 100 || name.substr(0, 3) == "End")
      in_.fail_at(start, "expected a section, which starts with $ and its name");
    const char* behind = in_.at();
    for (const char c : name)
      if (c < 33 || c > 126) in_.fail_at(start, "expected a section, which starts with $ and its name");
    if (!in_.skip_behind("$End" + std::string(name)) && version_ == 0) fail_without_header(start);
    if (in_.at() == behind)
      in_.fail_at(start, "the section $" + std::string(name) + " does not end: there is no $End" + std::string(name));
    // These sections have nothing that a mesh is made of.
    for (const char* dull : {"Comments", "Comment", "Periodic", "GhostElements", "Parametrizations"})
      if (name == dull) return;
    if (std::find(file_.skipped.begin(), file_.skipped.end(), name) == file_.skipped.end())
      file_.skipped.emplace_back(name);
  }

  void read_names() {
    const std::uint64_t count = in_.text_size("the number of physical names");
    in_.room_for(count, 6, "names");
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::int32_t dimension = in_.text_int("a dimension"), tag = in_.text_int("a physical tag");
      const char* start = in_.at();
      const std::string_view line = in_.line();
      const std::size_t first = line.find('"'), last = line.rfind('"');
      if (first == std::string_view::npos || first == last)
        in_.fail_at(start, "expected a name in double quotes behind dimension and tag");
      file_.names.emplace(std::pair(dimension, tag), line.substr(first + 1, last - first - 1));
    }
  }

  void read_entities(bool partitioned) {
    if (partitioned) {
      in_.size("the number of partitions");
      const std::uint64_t ghosts = in_.size("the number of ghost entities");
      for (std::uint64_t k = 0; k < ghosts; ++k) {
        in_.int32("a ghost entity's tag");
        in_.int32("a partition");
      }
    }
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t& count : counts) count = in_.size("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::uint64_t k = 0; k < counts[static_cast<std::size_t>(dimension)]; ++k)
        read_entity(dimension, partitioned);
  }

  void read_entity(int dimension, bool partitioned) {
    const std::int32_t tag = in_.int32("an entity's tag");
    MshEntity entity;
    if (partitioned) {
      const std::int32_t parent_dimension = in_.int32("a parent's dimension");
      const std::int32_t parent = in_.int32("a parent's tag");
      if (parent_dimension == dimension) entity.parent = parent;
      skip_ints("a number of partitions", "a partition");
    }
    for (int k = 0; k < (dimension == 0 && version_ != 40 ? 3 : 6); ++k) in_.number("a coordinate");
    const std::uint64_t physical = in_.size("a number of physical tags");
    for (std::uint64_t k = 0; k < physical; ++k) {
      const std::int32_t value = in_.int32("a physical tag");
      if (k == 0) entity.physical = value;
    }
    entity.has_more = physical > 1;
    if (dimension > 0) skip_ints("a number of bounding entities", "an entity's tag");
    file_.entities[{dimension, tag}] = entity;
  }

  void skip_ints(const char* count_name, const char* name) {
    const std::uint64_t count = in_.size(count_name);
    for (std::uint64_t k = 0; k < count; ++k) in_.int32(name);
  }

  MshCursor in_;
  MshFile file_;
  static constexpr int most_of_a_kind = 64;  // most sections of one name: after each $Nodes all tags are sorted
  int version_ = 0;                          ///< 0: not known yet; 1, 20, 40, 41
  std::vector<std::string_view> seen_;       ///< names of the sections that were read
};

}  // namespace

MshFile read_msh_file(std::string_view bytes) { return SectionReader(bytes).read(); }

}  // namespace pliant

// formats/msh/msh_views.cpp: the heads of sections with values, interpolation schemes, and which sections make a view.
#include "formats/msh/msh_views.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pliant {
namespace {

constexpr std::uint64_t most_view_tags = 100;      // Gmsh writes two string tags, one real and four integer ones
constexpr std::int32_t most_components = 9;        // of a tensor; Gmsh has no views of more
constexpr std::int32_t triangle_topology = 3;      // Gmsh's number of triangles in interpolation schemes
constexpr std::uint64_t most_values = 10000;       // in an entry of a section, or in a row of a scheme
constexpr std::int32_t most_element_nodes = 4000;  // above the 1331 nodes of a hexahedron of order 10

/// How many tags of one kind follow.
std::uint64_t tag_count(MshCursor& in, const char* what) {
  const std::uint64_t count = in.text_size(what);
  if (count > most_view_tags)
    in.fail("expected " + std::string(what) + ", at most 100, found " + std::to_string(count));
  return count;
}

std::string quoted_line(MshCursor& in) {
  const char* start = in.at();
  const std::string_view line = in.line();
  const std::size_t first = line.find('"'), last = line.rfind('"');
  if (first == std::string_view::npos || first == last) in.fail_at(start, "expected a name in double quotes");
  return std::string(line.substr(first + 1, last - first - 1));
}

/// Passes the entries of a section, so that values of steps that nobody asks for cost no time.
void pass_entries(MshCursor& in, const MshDataSection& section, const char* start) {
  const std::string end = "$End" + std::string(section_name(section.kind));
  const std::size_t row = 8 * static_cast<std::size_t>(section.components);
  if (!in.binary) {
    in.room_for(section.entries, 2 + 2 * static_cast<std::size_t>(section.components), "entries");
    if (!in.skip_behind(end))
      in.fail_at(start,
                 "the section $" + std::string(section_name(section.kind)) + " does not end: there is no " + end);
    return;
  }
  if (section.kind != MshDataSection::element_node) {
    in.take(in.room_for(section.entries, 4 + row, "entries"), 4 + row, "entries");
  } else {
    in.room_for(section.entries, 8 + row, "entries");
    for (std::uint64_t k = 0; k < section.entries; ++k) {
      in.int32("an element's tag");
      const std::int32_t nodes = in.int32("an element's number of nodes");
      if (nodes < 1 || nodes > most_element_nodes)
        in.fail("expected an element's number of nodes, found " + std::to_string(nodes));
      in.take(static_cast<std::size_t>(nodes), row, "values");
    }
  }
  in.expect(end, " behind the values");
}

/// Reads the numbers of one matrix, which always are text.
std::vector<double> read_matrix(MshCursor& in, std::uint64_t& rows, std::uint64_t& columns) {
  rows = in.text_size("a matrix's number of rows");
  columns = in.text_size("a matrix's number of columns");
  if (rows > most_values || columns > most_values) in.fail("expected a matrix of at most 10000 rows and columns");
  in.room_for(rows * columns, 2, "numbers of a matrix");
  std::vector<double> numbers(static_cast<std::size_t>(rows * columns));
  for (double& number : numbers) {
    in.skip_space();
    const char* where = in.at();
    number = in.text_number("a number of a matrix");
    if (!std::isfinite(number)) in.fail_at(where, "expected a finite number of a matrix");
  }
  return numbers;
}

}  // namespace

const char* section_name(MshDataSection::Kind kind) {
  switch (kind) {
    case MshDataSection::node:
      return "NodeData";
    case MshDataSection::element:
      return "ElementData";
    case MshDataSection::element_node:
      return "ElementNodeData";
  }
  return "";
}

void read_data_head(MshCursor& in, MshFile& file, MshDataSection::Kind kind, const char* start) {
  MshDataSection section{kind, {}, {}, {}, 0, 0, 1, 0, 0, in};
  const std::uint64_t strings = tag_count(in, "the number of string tags");
  in.end_line("the number of string tags");
  for (std::uint64_t k = 0; k < strings; ++k) {
    std::string text = quoted_line(in);
    if (k < 3) (k == 0 ? section.view : k == 1 ? section.scheme : section.mark) = std::move(text);
  }
  const std::uint64_t reals = tag_count(in, "the number of real tags");
  for (std::uint64_t k = 0; k < reals; ++k) {
    in.skip_space();
    const char* where = in.at();
    const double value = in.text_number("a real tag");
    if (k > 0) continue;
    if (!std::isfinite(value)) in.fail_at(where, "the time of the values is not finite");
    section.time = value;
  }
  const std::uint64_t integers = tag_count(in, "the number of integer tags");
  std::int32_t entries = 0;
  for (std::uint64_t k = 0; k < integers; ++k) {
    in.skip_space();
    const char* where = in.at();
    const std::int32_t value = in.text_int("an integer tag");
    if (k == 1 && (value < 1 || value > most_components))
      in.fail_at(where, "expected 1 to 9 components, found " + std::to_string(value));
    if (k == 2 && value < 0) in.fail_at(where, "expected the number of entries, found " + std::to_string(value));
    if (k < 4) (k == 0 ? section.step : k == 1 ? section.components : k == 2 ? entries : section.partition) = value;
  }
  section.entries = static_cast<std::uint64_t>(entries);
  in.end_line("the tags");
  section.in = in;
  pass_entries(in, section, start);
  file.data.push_back(std::move(section));
}

void read_scheme(MshCursor& in, MshFile& file) {
  const std::string name = quoted_line(in);
  MshScheme scheme;
  const std::uint64_t topologies = in.text_size("the number of topologies");
  for (std::uint64_t k = 0; k < topologies; ++k) {
    const std::int32_t topology = in.text_int("a topology");
    const std::uint64_t matrices = in.text_size("the number of matrices");
    for (std::uint64_t m = 0; m < matrices; ++m) {
      std::uint64_t rows = 0, columns = 0;
      const char* where = in.at();
      const std::vector<double> numbers = read_matrix(in, rows, columns);
      if (topology != triangle_topology) continue;
      if (m == 0) {
        scheme.count = static_cast<std::size_t>(rows);
        scheme.coefficients = numbers;
      } else if (m == 1) {
        // A third column, of exponents of w, is 0 for triangles.
        const std::size_t monomials = scheme.count == 0 ? 0 : scheme.coefficients.size() / scheme.count;
        if (rows != monomials || columns < 2 || columns > 3)
          in.fail_at(where, "expected " + std::to_string(monomials) + " rows of 2 or 3 exponents, found a matrix of " +
                                std::to_string(rows) + " x " + std::to_string(columns));
        scheme.exponents.clear();
        for (std::size_t row = 0; row < monomials; ++row)
          for (std::size_t c = 0; c < 2; ++c)
            scheme.exponents.push_back(numbers[row * static_cast<std::size_t>(columns) + c]);
      }
    }
  }
  file.schemes.emplace(name, std::move(scheme));
}

std::vector<MshView> group_views(const MshFile& file) {
  std::vector<MshView> views;
  std::map<std::pair<std::string, MshDataSection::Kind>, std::vector<std::size_t>> of_name;
  std::map<std::tuple<std::string, MshDataSection::Kind, std::int32_t, std::int32_t>, std::size_t> seen;
  for (const MshDataSection& section : file.data) {
    std::vector<std::size_t>& same = of_name[{section.view, section.kind}];
    const std::size_t nth = seen[{section.view, section.kind, section.step, section.partition}]++;
    if (nth == same.size()) {
      same.push_back(views.size());
      views.push_back({section.view, {}});
    }
    views[same[nth]].steps[section.step].push_back(&section);
  }
  return views;
}

}  // namespace pliant

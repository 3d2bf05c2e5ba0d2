// tests/formats/msh/msh_fields_test.cpp: fields that are written as views and read again are the same fields.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "formats/msh/msh.h"
#include "formats/msh/msh_writer.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "support/msh_texts.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"

using namespace pliant;
using samples::msh_file, samples::written_kinds;

namespace {

/// A mesh with continuous fields of 1, 2, 3 and 9 components, and fields by face of 1 and 2, that jump.
MeshData with_fields(const BoundaryComplex& boundary, int degree) {
  Mesh mesh;
  REQUIRE(mesh_from_boundary(boundary, {degree}, mesh).ok);
  mesh.time = 0.1;
  std::string why;
  const auto add = [&](const std::string& name, int components, bool by_face) {
    const auto faces = static_cast<FaceId>(mesh.to_data().boundary.faces.size());
    for (FaceId face = by_face ? 0 : none; face < (by_face ? faces : 0); ++face)
      mesh.set_field(make_field(
          mesh, name, components, face,
          [&](const Point& p, std::span<double> value) {
            for (std::size_t c = 0; c < value.size(); ++c)
              value[c] = std::sin(3 * p.x + double(c)) * p.y + (by_face ? 10 * face : 0);
          },
          why));
  };
  add("u", 1, false);
  add("speed and \"more\"", 2, false);
  add("v", 3, false);
  add("tensor", 9, false);
  add("pressure", 1, true);
  add("jump", 2, true);
  return mesh.to_data();
}

using Values = std::map<std::array<std::int64_t, 2>, std::vector<double>>;
/// The control values of a field by point and face (none where it is continuous), as `number` numbers the points.
template <class Number>
Values values_of(const MeshData& mesh, const Field& field, Number&& number) {
  Values values;
  const auto c = index(field.components);
  for (std::size_t k = 0; k < field.values.size() / c; ++k) {
    const auto place = field.by_face ? field.places[k] : std::array<std::int32_t, 2>{static_cast<std::int32_t>(k), -1};
    // Faces are read in the order of their first triangles, so their names tell which they are.
    std::int64_t face = -1;
    if (field.by_face)
      for (const char letter : mesh.boundary.faces[index(place[1])].name) face = 31 * face + letter;
    values[{number(index(place[0])), face}] = {field.values.begin() + static_cast<std::ptrdiff_t>(k * c),
                                               field.values.begin() + static_cast<std::ptrdiff_t>((k + 1) * c)};
  }
  return values;
}

/// The fields of `import` are those of `mesh` to `tolerance`, relative to each field's largest value.
void check_same_fields(const MeshData& mesh, const MshImport& import, double tolerance) {
  CHECK(import.mesh.time == mesh.time);
  REQUIRE(import.mesh.fields.size() == mesh.fields.size());
  for (std::size_t f = 0; f < mesh.fields.size(); ++f) {
    const Field &before = mesh.fields[f], &after = import.mesh.fields[f];
    CAPTURE(before.name);
    CHECK(after.components == before.components);
    CHECK(after.by_face == before.by_face);
    const Values wanted = values_of(mesh, before, [](std::size_t p) { return static_cast<std::int64_t>(p); });
    const Values found = values_of(
        import.mesh, after, [&](std::size_t p) { return static_cast<std::int64_t>(import.nodes.tag_of(p)) - 1; });
    REQUIRE(found.size() == wanted.size());
    double largest = 0, worst = 0;
    for (const auto& [place, row] : wanted) {
      REQUIRE(found.count(place) == 1);
      for (std::size_t c = 0; c < row.size(); ++c) {
        largest = std::max(largest, std::fabs(row[c]));
        worst = std::max(worst, std::fabs(row[c] - found.at(place)[c]));
      }
    }
    CHECK(worst <= tolerance * largest);
  }
}

}  // namespace

TEST_CASE("fields that are written and read are the same fields", "[msh]") {
  const int degree = GENERATE(range(1, 6));
  for (const auto& boundary : {samples::one_cell(degree), samples::three_cells(degree), samples::interface(degree)}) {
    MeshData mesh = with_fields(boundary, degree);
    for (const MshWriteOptions& kind : written_kinds) {
      CAPTURE(degree, boundary.faces.front().name, kind.version, kind.binary);
      const MshImport import = read_msh(msh_file(mesh, kind));
      CHECK(import.warnings.empty());
      CHECK(check_structure(import.mesh).empty());
      check_same_fields(mesh, import, 2e-14);
      CHECK(import.mesh.fields[1].name == "speed and 'more'");
    }
  }
}

TEST_CASE("fields of meshes of extreme sizes, and extreme values, come back", "[msh]") {
  MeshData mesh = with_fields(samples::three_cells(3), 3);
  for (const double unit : {1e-150, 1e150})
    for (const double scale : {1e-250, 1e250, 1.0}) {
      MeshData scaled = mesh;
      for (Point& p : scaled.points) p = p * unit;
      for (Field& field : scaled.fields)
        for (double& value : field.values) value *= scale;
      for (const MshWriteOptions& kind : written_kinds) {
        const MshImport import = read_msh(msh_file(scaled, kind));
        CHECK(import.warnings.empty());
        check_same_fields(scaled, import, 2e-14);
      }
    }
}

TEST_CASE("a field of degree ten comes back to the rounding of its nodes", "[msh]") {
  MeshData mesh = with_fields(samples::one_cell(2), 10);
  for (const MshWriteOptions& kind : written_kinds) check_same_fields(mesh, read_msh(msh_file(mesh, kind)), 1e-12);
}

TEST_CASE("what is by face stays so, even where it does not jump, and a flat vector keeps its components", "[msh]") {
  MeshData mesh = with_fields(samples::three_cells(2), 2);
  for (Field& field : mesh.fields)
    for (std::size_t k = 0; k < field.values.size(); ++k)
      field.values[k] = field.components == 3 && k % 3 == 2 ? 0 : 0.5;
  for (const MshWriteOptions& kind : written_kinds) check_same_fields(mesh, read_msh(msh_file(mesh, kind)), 0);
}

TEST_CASE("fields of other numbers of components are a view for each component", "[msh]") {
  MeshData mesh = with_fields(samples::one_cell(2), 2);
  Field field = mesh.fields[0];
  field.name = std::string(200, 'n');
  field.components = 4;
  field.values.clear();
  for (std::size_t k = 0; k < 4 * mesh.points.size(); ++k) field.values.push_back(double(k % 4));
  mesh.fields = {field};
  const MshImport import = read_msh(msh_file(mesh, {}));
  REQUIRE(import.mesh.fields.size() == 4);
  for (std::size_t c = 0; c < 4; ++c)
    for (const double value : import.mesh.fields[c].values) CHECK(value == double(c));
  mesh.fields[0].name = "short";
  CHECK(read_msh(msh_file(mesh, {})).mesh.fields[3].name == "short 4");
}

TEST_CASE("views of names that are equal in MSH get numbers, within what Gmsh reads of a name", "[msh]") {
  const std::size_t length = GENERATE(range<std::size_t>(120, 130));
  MeshData mesh = with_fields(samples::one_cell(2), 2);
  const Field field = mesh.fields[0];
  mesh.fields.clear();
  for (const char* end : {"\1", "\2", "\3"}) {
    mesh.fields.push_back(field);
    mesh.fields.back().name = std::string(length - 1, 'n') + end;
  }
  std::set<std::string> names;
  for (const Field& read : read_msh(msh_file(mesh, {})).mesh.fields) {
    CHECK(read.name.size() <= 127);
    names.insert(read.name);
  }
  CHECK(names.size() == 3);
}

// tests/formats/msh/msh_test.cpp: MSH files of every kind are read as the meshes that they describe.
#include "formats/msh/msh.h"

#include <catch2/catch.hpp>

#include "pliant/geometry/index.h"
#include "pliant/mesh/check_mesh.h"
#include "support/document_texts.h"
#include "support/sample_meshes.h"
#include "tests/formats/msh/msh_sample.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// A disk whose middle is a face of its own.
MeshData disk_with_core(int degree) {
  MeshData mesh = disk(degree);
  mesh.boundary.faces.push_back({"core", {}});
  for (std::size_t t = 0; t < 8; ++t) mesh.triangle_faces[3 * t] = 1;
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t) mesh.triangle_faces[t] = t % 3 == 0 ? 1 : 0;
  return mesh;
}

bool warns(const MshImport& import, const std::string& part) {
  return std::any_of(import.warnings.begin(), import.warnings.end(),
                     [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

bool has(const std::vector<Fault>& faults, const std::string& invariant) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) { return fault.invariant == invariant; });
}

/// Two triangles of a unit square: nodes 1 to 4 round it, and a node in the middle of the diagonal 1 3 and of each
/// side.
MshSample square_sample() {
  MshSample sample;
  sample.nodes = {{1, 0, 0, 0},   {2, 1, 0, 0},   {3, 1, 1, 0},   {4, 0, 1, 0},    {5, 0.5, 0, 0},
                  {6, 1, 0.5, 0}, {7, 0.5, 1, 0}, {8, 0, 0.5, 0}, {9, 0.5, 0.5, 0}};
  sample.elements = {{9, 1, 0, 1, {1, 2, 3, 5, 6, 9}}, {9, 2, 0, 1, {1, 3, 4, 9, 7, 8}}};
  return sample;
}

MshImport read(const MshSample& sample, const MshOptions& options = {}) {
  return read_msh(write_msh(sample, {}), options);
}

}  // namespace

TEST_CASE("Lagrange nodes of every order and kind of file become the control points they were made from", "[msh]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  CAPTURE(degree);
  const MeshData mesh = disk(degree, std::max(8, degree));
  const MshSample sample = msh_of(mesh);
  // Rounding, times the growth of the condition number of interpolation at equally spaced nodes.
  const double tolerance = 2e-16 * std::pow(2.6, degree);
  for (const MshKind& kind : msh_kinds) {
    CAPTURE(kind.version, kind.binary, kind.swapped);
    const MshImport import = read_msh(write_msh(sample, kind));
    CHECK(check_arrays(import.mesh).empty());
    for (const Fault& fault : check_structure(import.mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
    CHECK(import.mesh.degree == degree);
    CHECK(import.mesh.triangles == mesh.triangles);
    REQUIRE(import.mesh.points.size() == mesh.points.size());
    double worst = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
      worst = std::max(worst, distance(import.mesh.points[p], mesh.points[p]));
    CHECK(worst <= tolerance);
    CHECK(find_invalid(import.mesh).empty());
    CHECK(import.warnings.empty());
    CHECK(import.elements.tag_of(7) == 1007);
  }
}

TEST_CASE("all kinds of MSH files of one mesh give the same mesh bit for bit", "[msh]") {
  const int degree = GENERATE(1, 2, 3, 5);
  MshSample sample = msh_of(disk_with_core(degree));
  sample.names = {{2, 20, "cell"}, {2, 21, "core \"inner\""}, {1, 10, "rim"}, {1, 99, "nothing"}};
  const std::string expected = text_of(read_msh(write_msh(sample, msh_kinds[0])).mesh);
  for (const MshKind& kind : msh_kinds) CHECK(text_of(read_msh(write_msh(sample, kind)).mesh) == expected);
}

TEST_CASE("physical groups name faces and curves, and edges between faces lie on curves", "[msh]") {
  const int degree = GENERATE(1, 2, 4);
  MshSample sample = msh_of(disk_with_core(degree));
  sample.names = {{2, 20, "cell"}, {2, 21, "core"}, {1, 10, "rim"}};
  const MshImport import = read(sample);
  const BoundaryComplex& boundary = import.mesh.boundary;
  CHECK(check_structure(import.mesh).empty());
  REQUIRE(boundary.faces.size() == 2);
  CHECK(boundary.faces[0].name == "core");  // the group of the first triangle
  CHECK(boundary.faces[1].name == "cell");
  REQUIRE(boundary.curves.size() == 2);
  for (const Curve& curve : boundary.curves) {
    CHECK(curve.spline.closed());
    CHECK(curve.spline.span_count() == 8);
    CHECK(curve.spline.multiplicity(curve.spline.breaks()[1]) == degree);
    const bool is_rim = curve.name == "rim";
    CHECK((is_rim || curve.name == "core | cell"));
    CHECK(curve.left == (is_rim ? 1 : 0));
    CHECK(curve.right == (is_rim ? outside : 1));
  }
  CHECK(import.mesh.constrained_edges.size() == 16);
}

TEST_CASE("surfaces and curves in no group are named after their tags, equal names are told apart", "[msh]") {
  MshSample sample = square_sample();
  sample.elements[1].entity = 2;
  sample.elements.push_back({8, 3, 0, 4, {1, 2, 5}});
  const MshImport import = read(sample);
  CHECK(check_structure(import.mesh).empty());
  CHECK(import.mesh.boundary.faces[0].name == "surface 1");
  CHECK(import.mesh.boundary.faces[1].name == "surface 2");
  CHECK(import.mesh.boundary.curves.size() == 4);
  const auto named = [&](const std::string& name) {
    return std::count_if(import.mesh.boundary.curves.begin(), import.mesh.boundary.curves.end(),
                         [&](const Curve& curve) { return curve.name == name; });
  };
  CHECK(named("curve 4") == 1);
  CHECK(named("surface 1 | surface 2") == 1);
  CHECK(named("boundary of surface 2") == 1);

  sample.elements[0].physical = 5;
  sample.elements[1].physical = 6;
  sample.names = {{2, 5, "A"}, {2, 6, "A"}};
  const MshImport twice = read(sample);
  CHECK(twice.mesh.boundary.faces[0].name == "A");
  CHECK(twice.mesh.boundary.faces[1].name == "A (6)");
  sample.names = {{2, 5, "na\xefve"}};
  CHECK(read(sample).mesh.boundary.faces[0].name == "na\xc3\xafve");
  CHECK(read(sample).mesh.boundary.faces[1].name == "physical surface 6");
}

TEST_CASE("node tags may have gaps, any order and any size; nodes of no triangle are dropped", "[msh]") {
  const MeshData mesh = disk(3);
  const std::string expected = text_of(read(msh_of(mesh)).mesh);
  const auto n = static_cast<std::int64_t>(mesh.points.size());
  CHECK(text_of(read(msh_of(mesh, [n](PointId p) { return n - p; })).mesh) == expected);
  CHECK(text_of(read(msh_of(mesh, [](PointId p) { return 3 * std::int64_t{p} + 100; })).mesh) == expected);
  CHECK(text_of(read(msh_of(mesh, [](PointId p) { return (std::int64_t{p} * 7919) % 10007 * 1000003; })).mesh) ==
        expected);
  MshSample sample = msh_of(mesh);
  sample.nodes.insert(sample.nodes.begin() + 3, {100000, 5, 5, 77});
  sample.nodes.push_back({100001, -5, 5, 0});
  const MshImport import = read(sample);
  CHECK(text_of(import.mesh) == expected);
  CHECK(import.nodes.tag_of(3) == 4);
  CHECK(import.nodes.size() == mesh.points.size());
}

TEST_CASE("triangles of mixed orders are raised to the highest, and share what is the same curve", "[msh]") {
  MshSample sample = square_sample();
  sample.elements[1] = {2, 2, 0, 1, {1, 3, 4}};
  const MshImport import = read(sample);
  CHECK(import.mesh.degree == 2);
  CHECK(check_structure(import.mesh).empty());
  CHECK(warns(import, "orders from 1 to 2"));
  CHECK(import.mesh.points.size() == 9);
  for (const PointId p : import.mesh.triangles) CHECK(std::fmod(4 * import.mesh.points[index(p)].x, 2) == 0);

  // The diagonal bends in one triangle only: two curves between the same vertices.
  sample.nodes[8].x = 0.6;
  const MshImport torn = read(sample);
  CHECK(check_arrays(torn.mesh).empty());
  CHECK(warns(torn, "1 edge is not the same curve in both triangles"));
  const std::vector<Fault> faults = check_structure(torn.mesh);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].invariant == "M1");
  CHECK(in_msh_words(torn, faults[0]).place.substr(0, 8) == "element ");

  // Order 3 beside order 2 of one parabola.
  MeshData mesh = disk(2);
  MshSample both = msh_of(mesh);
  const MeshData low = read(both).mesh;
  std::int64_t next = 5000;
  for (auto& element : both.elements) {
    if (element.type != 9 || element.tag % 2 == 0) continue;
    std::vector<std::int64_t> nodes(element.nodes.begin(), element.nodes.begin() + 3);
    std::vector<double> values;
    const std::size_t t = index(element.tag - 1000);
    for (std::size_t k = 0; k < 6; ++k) {
      const Point& p = low.points[index(low.triangles[6 * t + k])];
      values.insert(values.end(), {p.x, p.y});
    }
    for (const auto& [i, j] : msh_triangle_nodes(3)) {
      if (i == 3 || j == 3 || i + j == 0) continue;
      std::array<double, 2> value;
      evaluate_net(2, 2, values, Barycentric{i / 3.0, j / 3.0, (3 - i - j) / 3.0}, value);
      both.nodes.push_back({next, value[0], value[1], 0.25});
      nodes.push_back(next++);
    }
    element = {21, element.tag, element.physical, element.entity, nodes};
  }
  const MshImport raised = read(both);
  CHECK(raised.mesh.degree == 3);
  // Elements of order 3 that are neighbours of each other have nodes of their own here; only those are torn.
  for (const Fault& fault : check_structure(raised.mesh)) CHECK(fault.invariant != "M2");
  CHECK(find_invalid(raised.mesh).empty());
}

TEST_CASE("clockwise triangles are counted, and turned on request, but not tangled ones", "[msh]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const MeshData mesh = disk(degree);
  MshSample sample = msh_of(mesh);
  std::vector<std::array<int, 2>> nodes = msh_triangle_nodes(degree);
  for (auto& element : sample.elements) {
    if (msh_dimension(element.type) != 2) continue;
    const std::vector<std::int64_t> old = element.nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const std::array<int, 2> mirror{nodes[k][0], degree - nodes[k][0] - nodes[k][1]};
      element.nodes[index(std::find(nodes.begin(), nodes.end(), mirror) - nodes.begin())] = old[k];
    }
  }
  const MshImport as_is = read(sample);
  CHECK(warns(as_is, "24 of 24 triangles run clockwise (first: element 1000)"));
  CHECK(find_invalid(as_is.mesh).invalid.size() == 24);
  CHECK(check_structure(as_is.mesh).empty());
  const MshImport turned = read(sample, {true});
  CHECK(warns(turned, "24 triangles turned"));
  CHECK(check_structure(turned.mesh).empty());
  CHECK(find_invalid(turned.mesh).empty());
  double off = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    off = std::max(off, distance(turned.mesh.points[p], mesh.points[p]));
  CHECK(off < 1e-13);

  // One clockwise triangle among others is turned; one that a misplaced vertex turned over is not.
  MshSample one = msh_of(mesh);
  one.elements.back() = sample.elements.back();
  CHECK(!check_structure(read(one).mesh).empty());
  CHECK(find_invalid(read(one, {true}).mesh).empty());
  MshSample tangled = msh_of(mesh);
  tangled.nodes[0].x = 3;  // the middle vertex
  const MshImport kept = read(tangled, {true});
  CHECK(check_structure(kept.mesh).empty());
  CHECK(!find_invalid(kept.mesh).empty());
  CHECK(kept.mesh.triangles == read(tangled).mesh.triangles);
}

TEST_CASE("what is no triangle or line is counted and named", "[msh]") {
  for (const MshKind& kind : msh_kinds) {
    MshSample sample = square_sample();
    sample.elements.push_back({3, 3, 0, 1, {1, 2, 3, 4}});
    sample.elements.push_back({3, 4, 0, 1, {1, 2, 3, 4}});
    sample.elements.push_back({20, 5, 0, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}});
    sample.elements.push_back({15, 6, 0, 1, {1}});
    sample.elements.push_back({8, 7, 0, 9, {1, 3, 9}});
    sample.tail = "$Comments\nanything\n$EndComments\n$NodeStates\n1\n$EndNodeStates\n$Mine\n$EndMine\n";
    const MshImport import = read_msh(write_msh(sample, kind));
    CHECK(import.warnings ==
          std::vector<std::string>{"1 line element lies neither on the boundary nor between two faces, and is left out",
                                   "2 quadrangles of 4 nodes (type 3) are left out",
                                   "1 triangle without all their inner nodes (type 20) is left out",
                                   "not read: $NodeStates, $Mine"});
    CHECK(import.notes == std::vector<std::string>{"1 point (type 15) is left out"});
    CHECK(import.mesh.triangle_faces.size() == 2);
  }
}

TEST_CASE("an element in several physical groups counts for the first", "[msh]") {
  MshSample sample = square_sample();
  for (auto& element : sample.elements) element.physical = 3;
  const std::string once = text_of(read(sample).mesh);
  for (std::size_t k = 0; k < 2; ++k) {
    sample.elements.push_back(sample.elements[k]);
    sample.elements.back().physical = 8;
  }
  const MshImport import = read_msh(write_msh(sample, {2, false, false}));
  CHECK(text_of(import.mesh) == once);
  CHECK(import.warnings.size() == 1);
  CHECK(warns(import, "several physical groups"));
  // Elements that are listed twice in the same group are a fault of the mesh.
  sample.elements[2].physical = sample.elements[3].physical = 3;
  const MshImport doubled = read_msh(write_msh(sample, {2, false, false}));
  CHECK(doubled.mesh.triangle_faces.size() == 4);
  CHECK(!check_structure(doubled.mesh).empty());
}

TEST_CASE("meshes whose triangles do not fit together still have well-formed arrays", "[msh]") {
  const auto faults_of = [](const MshSample& sample) {
    for (const MshKind& kind : msh_kinds) CHECK(check_arrays(read_msh(write_msh(sample, kind)).mesh).empty());
    return check_structure(read(sample).mesh);
  };
  SECTION("three triangles at an edge") {
    MshSample sample = square_sample();
    sample.nodes.push_back({10, 2, 0.5, 0});
    sample.nodes.push_back({11, 2, 0.25, 0});
    sample.nodes.push_back({12, 2, 0.75, 0});
    sample.elements.push_back({9, 3, 0, 1, {1, 3, 10, 9, 11, 12}});
    CHECK(has(faults_of(sample), "M2"));
    for (auto& element : sample.elements) {
      element.type = 2;
      element.nodes.resize(3);
    }
    CHECK(has(faults_of(sample), "M2"));
  }
  SECTION("neighbours that share the vertices of an edge only") {
    MshSample sample = square_sample();
    sample.nodes.push_back({10, 0.5, 0.5, 0});
    sample.elements[1].nodes[3] = 10;
    const std::vector<Fault> faults = faults_of(sample);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].invariant == "M1");
  }
  SECTION("an element twice, corners that are one node, one node everywhere") {
    MshSample sample = square_sample();
    sample.elements.push_back(sample.elements[0]);
    CHECK(!faults_of(sample).empty());
    sample.elements[2].nodes = {1, 1, 2, 5, 6, 7};
    CHECK(!faults_of(sample).empty());
    sample.elements[2].nodes = {1, 1, 1, 1, 1, 1};
    CHECK(!faults_of(sample).empty());
    sample.elements = {sample.elements[2], sample.elements[2]};
    CHECK(!faults_of(sample).empty());
  }
  SECTION("two parts that touch without common nodes are sound, each by itself") {
    MshSample sample = square_sample();
    for (std::size_t k = 0; k < 9; ++k) {
      MshSample::Node node = sample.nodes[k];
      sample.nodes.push_back({node.tag + 20, node.x + 1, node.y, 0});
    }
    for (std::size_t k = 0; k < 2; ++k) {
      MshSample::Element element = sample.elements[k];
      for (std::int64_t& node : element.nodes) node += 20;
      sample.elements.push_back(element);
    }
    CHECK(faults_of(sample).empty());
  }
  SECTION("a vertex where the mesh only touches itself") {
    MshSample sample = square_sample();
    sample.nodes.insert(sample.nodes.end(),
                        {{10, 2, 1, 0}, {11, 2, 2, 0}, {12, 1.5, 1, 0}, {13, 2, 1.5, 0}, {14, 1.5, 1.5, 0}});
    sample.elements.push_back({9, 3, 0, 1, {3, 10, 11, 12, 13, 14}});
    CHECK(faults_of(sample).empty());
    CHECK(read(sample).mesh.boundary.vertices.size() == 1);
  }
}

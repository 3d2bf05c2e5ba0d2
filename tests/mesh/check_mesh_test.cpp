// tests/mesh/check_mesh_test.cpp: planted breaches of the invariants are found and named.
#include "pliant/mesh/check_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "ops/random_operations.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"

// Each breach is planted alone into a sound document, and must be found as a breach of its invariant.
using namespace pliant;

namespace {

PointId& entry(MeshData& data, TriangleId t, int k) {
  return data.triangles[static_cast<std::size_t>(t * net_size(data.degree) + k)];
}
PointId copy_of(MeshData& data, PointId p) {
  const Point place = data.points[static_cast<std::size_t>(p)];
  data.points.push_back(place);
  for (Field& field : data.fields)
    if (!field.by_face) field.values.resize(field.values.size() + static_cast<std::size_t>(field.components), 0.0);
  return static_cast<PointId>(data.points.size()) - 1;
}

/// A sound document: two round cells, with a continuous field and a field by face.
MeshData sound(int degree) {
  samples::MeshBuilder builder(degree);
  samples::add_disk(builder, 8, {0, 0}, 1, "left");
  samples::add_disk(builder, 9, {3, 0}, 1, "right");
  MeshData data = std::move(builder.data());
  samples::add_field(data, "u", 2, [](const Point& p) { return std::vector<double>{p.x, p.y}; });
  Field pressure;
  pressure.name = "p";
  pressure.by_face = true;
  const auto n = static_cast<std::size_t>(net_size(degree));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    pressure.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::sort(pressure.places.begin(), pressure.places.end());
  pressure.places.erase(std::unique(pressure.places.begin(), pressure.places.end()), pressure.places.end());
  pressure.values.resize(pressure.places.size(), 1.0);
  data.fields.push_back(std::move(pressure));
  return data;
}

std::set<std::string> names(const std::vector<Fault>& faults) {
  std::set<std::string> found;
  for (const Fault& fault : faults) {
    found.insert(fault.invariant);
    CHECK(!fault.text.empty());
    CHECK(fault.place.front() == '/');
  }
  return found;
}

struct Breach {
  const char* name;
  const char* invariant;
  std::function<void(MeshData&)> plant;
  int least_degree = 1;
};

/// All breaches, each with the function that plants it. This function is long since it is one table.
const std::vector<Breach>& breaches() {
  static const std::vector<Breach> all{
      {"a shared edge has another control point in one triangle", "M1",
       [](MeshData& d) { entry(d, 0, 3) = copy_of(d, entry(d, 0, 3)); }, 2},
      {"a point is not used", "M1", [](MeshData& d) { copy_of(d, 0); }},
      {"a corner is also the control point of an edge elsewhere", "M1",
       [](MeshData& d) { entry(d, 40, 3) = entry(d, 0, 0); }, 2},
      {"a point lies inside two triangles", "M1",
       [](MeshData& d) { entry(d, 0, net_size(d.degree) - 1) = entry(d, 1, net_size(d.degree) - 1); }, 3},
      {"the points of an edge are in the wrong order", "M1",
       [](MeshData& d) { std::swap(entry(d, 0, 3), entry(d, 0, 4)); }, 3},
      {"two corners are one point", "M2", [](MeshData& d) { entry(d, 0, 1) = entry(d, 0, 0); }},
      {"a triangle occurs twice", "M2",
       [](MeshData& d) {
         const auto n = net_size(d.degree);
         for (int k = 0; k < n; ++k) d.triangles.push_back(d.triangles[static_cast<std::size_t>(k)]);
         d.triangle_faces.push_back(d.triangle_faces[0]);
       }},
      {"a triangle is turned over", "M2",
       [](MeshData& d) {
         std::swap(entry(d, 0, 1), entry(d, 0, 2));
         const int p = d.degree;
         // Turned over, the triangle's edges 12, 23, 31 become 13, 32, 21.
         for (int k = 0; k < p - 1; ++k) std::swap(entry(d, 0, 3 + k), entry(d, 0, 3 + 2 * (p - 1) + (p - 2 - k)));
         for (int k = 0; k < (p - 1) / 2; ++k)
           std::swap(entry(d, 0, 3 + (p - 1) + k), entry(d, 0, 3 + 2 * (p - 1) - 1 - k));
       }},
      {"two disks touch in a point", "M2",
       [](MeshData& d) {
         const PointId a = entry(d, 0, 0), b = entry(d, 24, 0);  // the middles
         std::replace(d.triangles.begin(), d.triangles.end(), b, a);
       }},
      {"a constrained edge is off its curve", "M4",
       [](MeshData& d) { d.points[static_cast<std::size_t>(d.constrained_edges[3].points[0])].x += 1e-9; }},
      {"a curve is off its edges", "M4",
       [](MeshData& d) {
         BSpline& spline = d.boundary.curves[1].spline;
         spline.set_point(4, spline.points()[4] + Vector{0, 1e-9});
       }},
      {"a span has no edge", "M4", [](MeshData& d) { d.constrained_edges.pop_back(); }},
      {"a span has two edges", "M4", [](MeshData& d) { d.constrained_edges[1].span = 0; }},
      {"an edge is listed twice", "M4", [](MeshData& d) { d.constrained_edges.push_back(d.constrained_edges[0]); }},
      {"a constrained edge is no edge", "M4",
       [](MeshData& d) { d.constrained_edges[0].points.back() = entry(d, 0, 0); }},
      {"a constrained edge runs against its curve", "M4",
       [](MeshData& d) { std::reverse(d.constrained_edges[0].points.begin(), d.constrained_edges[0].points.end()); }},
      {"a constrained edge names other inner points", "M4",
       [](MeshData& d) { d.constrained_edges[0].points[1] = d.constrained_edges[1].points[1]; }, 2},
      {"a triangle is in the wrong face", "M5", [](MeshData& d) { d.triangle_faces[2] = 1; }},
      {"the faces of a curve are exchanged", "M5",
       [](MeshData& d) { std::swap(d.boundary.curves[0].left, d.boundary.curves[1].left); }},
      {"the outer boundary is on no curve", "M5", [](MeshData& d) { d.constrained_edges.pop_back(); }},
      {"a curve at the outer boundary names a face outside", "M5", [](MeshData& d) { d.boundary.curves[0].right = 1; }},
      {"a curve names no face", "boundary", [](MeshData& d) { d.boundary.curves[0].left = 5; }},
      {"two fields have one name", "M6", [](MeshData& d) { d.fields[1].name = d.fields[0].name; }},
      {"a field by face lacks a place", "M6",
       [](MeshData& d) {
         d.fields[1].places.pop_back();
         d.fields[1].values.pop_back();
       }},
      {"a field by face has its places in the wrong order", "M6",
       [](MeshData& d) { std::swap(d.fields[1].places[0], d.fields[1].places[1]); }},
      {"a field by face has a place in a face that is elsewhere", "M6",
       [](MeshData& d) { d.fields[1].places[5][1] = 1 - d.fields[1].places[5][1]; }}};
  return all;
}

}  // namespace

TEST_CASE("sound documents have no faults", "[mesh]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  for (const MeshData& data : {samples::disk(degree), samples::three_disks(degree, 11), sound(degree)}) {
    CHECK(check_arrays(data).empty());
    for (const Fault& fault : check_structure(data)) FAIL_CHECK(fault.place << ": " << fault.text);
    CHECK(check_mesh(Mesh(data)).empty());
  }
}

TEST_CASE("every planted breach is found by the name of its invariant", "[mesh]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const Breach& breach : breaches()) {
    if (degree < breach.least_degree) continue;
    CAPTURE(degree, breach.name);
    MeshData data = sound(degree);
    breach.plant(data);
    CHECK(check_arrays(data).empty());
    CHECK(names(check_structure(data)).count(breach.invariant) == 1);
  }
}

TEST_CASE("arrays that do not fit are found before anything is asked of them", "[mesh]") {
  const std::vector<std::pair<const char*, std::function<void(MeshData&)>>> plants{
      {"degree 0", [](MeshData& d) { d.degree = 0; }},
      {"degree 99", [](MeshData& d) { d.degree = 99; }},
      {"a point is not finite", [](MeshData& d) { d.points[3].y = std::numeric_limits<double>::quiet_NaN(); }},
      {"a time is not finite", [](MeshData& d) { d.time = HUGE_VAL; }},
      {"a net is cut off", [](MeshData& d) { d.triangles.pop_back(); }},
      {"an index is negative", [](MeshData& d) { d.triangles[7] = -1; }},
      {"an index is beyond the points", [](MeshData& d) { d.triangles[7] = static_cast<PointId>(d.points.size()); }},
      {"a face is beyond the faces", [](MeshData& d) { d.triangle_faces[1] = 2; }},
      {"a triangle is in no face", [](MeshData& d) { d.triangle_faces[1] = outside; }},
      {"a constrained edge has too few points", [](MeshData& d) { d.constrained_edges[1].points.pop_back(); }},
      {"a constrained edge names no curve", [](MeshData& d) { d.constrained_edges[1].curve = 2; }},
      {"a constrained edge names no span", [](MeshData& d) { d.constrained_edges[1].span = 8; }},
      {"a field is too short", [](MeshData& d) { d.fields[0].values.pop_back(); }},
      {"a field has no components", [](MeshData& d) { d.fields[0].components = 0; }},
      {"a field is not finite", [](MeshData& d) { d.fields[1].values[2] = -HUGE_VAL; }},
      {"a place names no point", [](MeshData& d) { d.fields[1].places[2][0] = 100000; }}};
  for (const auto& [name, plant] : plants) {
    CAPTURE(name);
    MeshData data = sound(2);
    plant(data);
    CHECK(!names(check_arrays(data)).empty());
  }
}

TEST_CASE("at most as many faults of an invariant are listed as asked", "[mesh]") {
  MeshData data = sound(2);
  for (Point& p : data.points) p = 1.5 * p;
  CHECK(check_structure(data, 3).size() == 3);
  CHECK(check_structure(data, 1).size() == 1);
}

TEST_CASE("broken adjacency of a live mesh is found", "[mesh]") {
  const int degree = GENERATE(1, 2, 3);
  const std::vector<std::pair<const char*, std::function<void(Mesh&)>>> plants{
      {"a lost twin", [](Mesh& mesh) { mesh.link(mesh.twin(half_edge(0, 1)), none); }},
      {"a lost constraint",
       [](Mesh& mesh) {
         for (const HalfEdgeId h : mesh.half_edges())
           if (mesh.is_constrained(h)) return mesh.set_constraint(h, none);
       }},
      {"a free point in a net", [](Mesh& mesh) { mesh.free_point(mesh.net(4)[0]); }},
      {"a vertex without a half-edge", [](Mesh& mesh) { mesh.set_vertex_half_edge(mesh.corner(3, 1), none); }},
      {"a vertex with a half-edge elsewhere",
       [](Mesh& mesh) { mesh.set_vertex_half_edge(mesh.corner(3, 1), next(next(half_edge(3, 1)))); }},
      {"a triangle that is gone", [](Mesh& mesh) { mesh.free_triangle(5); }},
      {"a point that nothing uses", [](Mesh& mesh) { mesh.add_point(); }}};
  for (const auto& [name, plant] : plants) {
    CAPTURE(degree, name);
    Mesh mesh = carried_disk(degree);
    REQUIRE(check_mesh(mesh).empty());
    plant(mesh);
    CHECK(!check_mesh(mesh).empty());
  }
}

TEST_CASE("elements that are not valid are found, each as what it is", "[mesh]") {
  const int degree = GENERATE(2, 3);
  MeshData data = samples::disk(degree);
  CHECK(find_invalid(data).empty());
  // The inner edge between triangle 0 and the next one around the middle is pulled far to the side.
  data.points[static_cast<std::size_t>(entry(data, 0, 3))] += Vector{3, 0.5};
  const InvalidElements live = find_invalid(Mesh(data)), plain = find_invalid(data);
  CHECK(live.invalid == plain.invalid);
  CHECK(live.degenerate == plain.degenerate);
  CHECK(std::count(plain.invalid.begin(), plain.invalid.end(), 0) == 1);

  MeshData flat = samples::disk(1);
  const Point a = flat.points[static_cast<std::size_t>(entry(flat, 0, 0))];
  const Point b = flat.points[static_cast<std::size_t>(entry(flat, 0, 1))];
  flat.points[static_cast<std::size_t>(entry(flat, 0, 2))] = a + 0.5 * (b - a);
  const InvalidElements found = find_invalid(flat);
  CHECK(std::count(found.degenerate.begin(), found.degenerate.end(), 0) == 1);
}

TEST_CASE("a cusp that names no vertex is a fault of the arrays", "[mesh]") {
  MeshData data = samples::disk(2);
  REQUIRE(check_arrays(data).empty());
  for (const int v : {-1, 0, 1000000}) {
    data.boundary.cusps = {v};
    const auto faults = check_arrays(data);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].place == "/boundary/cusps/0");
  }
}

TEST_CASE("a point that stands twice in one edge breaks M1", "[mesh]") {
  MeshData data = samples::disk(3);
  REQUIRE(check_structure(data).empty());
  const auto& layout = NetLayout::of(3);
  const auto first = static_cast<std::size_t>(layout.edge_index(0, 1)),
             second = static_cast<std::size_t>(layout.edge_index(0, 2));
  const PointId kept = data.triangles[first], dropped = data.triangles[second];
  for (PointId& p : data.triangles)
    if (p == dropped) p = kept;
  bool found = false;
  for (const Fault& fault : check_structure(data))
    found = found || fault.text.find("used in two places") != fault.text.npos;
  CHECK(found);
}

// This took minutes when the spans of the curve were counted anew for each edge.
TEST_CASE("the arrays of a mesh whose curve has very many spans are looked at once", "[mesh]") {
  constexpr int spans = 400000;
  std::vector<Point> points;
  for (int i = 0; i < spans; ++i) points.push_back({std::cos(i * 1e-3), std::sin(i * 1e-3)});
  MeshData data;
  data.degree = 2;
  data.points.resize(3);
  data.boundary.faces.resize(1);
  data.boundary.curves.emplace_back().spline = samples::closed_spline(2, std::move(points));
  for (int s = 0; s < spans; ++s) data.constrained_edges.push_back({0, s, {0, 1, 2}});
  CHECK(check_arrays(data).empty());
  data.constrained_edges.back().span = spans;
  CHECK(check_arrays(data).size() == 1);
}

TEST_CASE("a control point far outside does not hide that an edge is off its curve", "[mesh]") {
  MeshData data = samples::disk(2);
  const PointId on_curve = data.constrained_edges[0].points[1];
  data.points[static_cast<std::size_t>(on_curve)].x += 1e-9;
  std::vector<char> is_on_curve(data.points.size(), 0);
  for (const ConstrainedEdge& edge : data.constrained_edges)
    for (const PointId p : edge.points) is_on_curve[static_cast<std::size_t>(p)] = 1;
  const auto inner = std::find(is_on_curve.begin(), is_on_curve.end(), 0) - is_on_curve.begin();
  data.points[static_cast<std::size_t>(inner)] = {1e12, 0};
  const std::vector<Fault> faults = check_structure(data);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].invariant == "M4");
}

TEST_CASE("a mesh far from the origin has no faults, moved by more than its rounding it has", "[mesh][check]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const double offset = GENERATE(1e3, 1e6, 2e9);
  CAPTURE(degree, offset);
  MeshData data = samples::disk(degree, 8, {offset, offset / 3});
  CHECK(check_structure(data).empty());
  const double unit = offset * 0x1p-52;
  data.points[static_cast<std::size_t>(data.constrained_edges[0].points[0])].x += 64 * unit;
  if (64 * unit > 1e-11) CHECK_FALSE(check_structure(data).empty());
}

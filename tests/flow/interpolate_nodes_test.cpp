// tests/flow/interpolate_nodes_test.cpp: interpolation of functions by control values: which are exact, and fields by
// face.
#include "pliant/mesh/interpolate_nodes.h"

#include "flow_meshes.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

/// The greatest difference between field 0 (of one component) and the function, at sample points in all elements of a
/// face.
double field_error(const Mesh& mesh, FaceId face, const std::function<double(const Point&)>& function) {
  double greatest = 0;
  std::vector<double> rows(static_cast<std::size_t>(mesh.net_size() * mesh.width()));
  std::vector<double> value(static_cast<std::size_t>(mesh.width()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (mesh.face(t) != face) continue;
    mesh.gather(t, rows);
    for (const Barycentric& xi : {Barycentric{0.2, 0.3, 0.5}, {0.6, 0.4, 0}, {1, 0, 0}, {0.1, 0.8, 0.1}}) {
      evaluate_net(mesh.degree(), mesh.width(), rows, xi, value);
      greatest = std::max(greatest, std::abs(value[2] - function({value[0], value[1]})));
    }
  }
  return greatest;
}

}  // namespace

TEST_CASE("a linear function is carried exactly by curved elements", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const MeshData& data : all(degree)) {
    Mesh mesh(data);
    std::string why;
    const auto linear = [](const Point& x) { return 3 * x.x - 2 * x.y + 1; };
    mesh.set_field(make_field(
        mesh, "u", 1, none, [&](const Point& x, std::span<double> v) { v[0] = linear(x); }, why));
    REQUIRE(why.empty());
    for (FaceId f = 0; f < static_cast<FaceId>(data.boundary.faces.size()); ++f)
      CHECK(field_error(mesh, f, linear) < 1e-13);
    CHECK(check_mesh(mesh).empty());
  }
}

TEST_CASE("a polynomial of the mesh's degree is carried exactly by straight elements", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh(two_rooms(degree));
  std::string why;
  const auto power = [&](const Point& x) { return std::pow(x.x + 0.5 * x.y, degree) - x.y; };
  mesh.set_field(make_field(
      mesh, "u", 1, none, [&](const Point& x, std::span<double> v) { v[0] = power(x); }, why));
  CHECK(field_error(mesh, 0, power) < 1e-11);
  CHECK(field_error(mesh, 1, power) < 1e-11);
}

TEST_CASE("a field by face jumps at the interface and keeps its other faces", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh(two_rooms(degree));
  std::string why;
  const auto set = [&](FaceId face, double constant) {
    mesh.set_field(make_field(
        mesh, "p", 1, face, [&](const Point&, std::span<double> v) { v[0] = constant; }, why));
    REQUIRE(why.empty());
    CHECK(check_mesh(mesh).empty());
  };
  const auto is = [](double constant) { return [constant](const Point&) { return constant; }; };
  set(0, 5);
  CHECK(field_error(mesh, 0, is(5)) < 1e-14);
  CHECK(field_error(mesh, 1, is(0)) < 1e-14);
  set(1, -2);
  CHECK(field_error(mesh, 0, is(5)) < 1e-14);
  CHECK(field_error(mesh, 1, is(-2)) < 1e-14);
  set(none, 7);
  CHECK_FALSE(mesh.fields()[0].by_face);
  set(1, 1);  // a continuous field becomes by face
  CHECK(field_error(mesh, 0, is(7)) < 1e-14);
  CHECK(field_error(mesh, 1, is(1)) < 1e-14);
  CHECK(mesh.fields().size() == 1);
}

TEST_CASE("a function that is not finite at a node is refused with its place", "[flow]") {
  const Mesh mesh(two_rooms(2));
  std::string why;
  const Field field = make_field(
      mesh, "u", 1, none, [](const Point& x, std::span<double> v) { v[0] = 1 / (x.x - 1.5); }, why);
  CHECK(field.values.empty());
  CHECK(why.find("(1.5, ") != std::string::npos);
}

// tests/tools/problem_coefficients_test.cpp: expressions of a problem as coefficients: fields, allocation, any text.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/boundary/fault.h"
#include "problem/diffusion.h"
#include "problem/problem_names.h"
#include "problem_samples.h"
#include "support/counted_malloc.h"

using namespace pliant;
using namespace pliant::testing;
using Catch::Matchers::Contains;

TEST_CASE("a coefficient that uses fields has their values at the place, at any degree", "[tools][problem]") {
  const int degree = GENERATE(1, 2, 3, 6, 10);
  CAPTURE(degree);
  Mesh mesh = channel(degree);
  set_field(mesh, "w", 1, none, [](const Point& p, std::span<double> v) { v[0] = 3 * p.x - 2 * p.y + 1; });
  set_field(mesh, "vel", 2, none, [](const Point& p, std::span<double> v) { v[0] = p.y, v[1] = -p.x; });
  set_field(mesh, "many", 3, none, [](const Point& p, std::span<double> v) { v[0] = 1, v[1] = p.x, v[2] = p.y; });
  for (int face = 0; face < 3; ++face)
    set_field(mesh, "q", 1, FaceId(face), [face](const Point& p, std::span<double> v) { v[0] = p.x + 100 * face; });
  for (int face = 0; face < 3; ++face)
    for (const Barycentric& xi : {Barycentric{0.2, 0.3, 0.5}, Barycentric{1, 0, 0}, Barycentric{0, 0.5, 0.5}}) {
      const CoefficientPoint at = point_of(mesh, triangle_in(mesh, face), xi, 0.25);
      const double x = at.place.x, y = at.place.y;
      CHECK(value_at("w*k + t", at, R"({"k": 2})") == Approx(2 * (3 * x - 2 * y + 1) + 0.25));
      CHECK(value_at("vel_x + 10*vel_y + w*0", at) == Approx(y - 10 * x));
      CHECK(value_at("many_1 + 10*many_2 + 100*many_3", at) == Approx(1 + 10 * x + 100 * y));
      CHECK(value_at("q", at) == Approx(x + 100 * face));
    }
}

TEST_CASE("the fields of the mesh that is asked about count, wherever they stand in it", "[tools][problem]") {
  Mesh mesh = channel(2);
  set_field(mesh, "a", 1, none, [](const Point&, std::span<double> v) { v[0] = 5; });
  const DiffusionProblem problem =
      make_diffusion_problem(problem_of(R"("materials": {"*": {"source": "u + 10*a"}})"), mesh);
  const auto source = [&](const Mesh& asked) {
    return (*problem.materials[0].source)(point_of(asked, TriangleId{0}, {1, 0, 0}));
  };
  CHECK(std::isnan(source(mesh)));  // the unknown is not there yet
  set_field(mesh, "u", 1, none, [](const Point&, std::span<double> v) { v[0] = 3; });
  CHECK(source(mesh) == 53);
  Mesh other = channel(2);
  set_field(other, "u", 1, none, [](const Point&, std::span<double> v) { v[0] = 4; });
  set_field(other, "b", 1, none, [](const Point&, std::span<double> v) { v[0] = 9; });
  set_field(other, "a", 1, none, [](const Point&, std::span<double> v) { v[0] = 6; });
  CHECK(source(other) == 64);
  CHECK(source(mesh) == 53);
}

#ifdef PLIANT_COUNTS_MALLOC
TEST_CASE("evaluating a coefficient allocates nothing", "[tools][problem]") {
  Mesh mesh = channel(4);
  set_field(mesh, "a", 1, none, [](const Point& p, std::span<double> v) { v[0] = p.x; });
  set_field(mesh, "vel", 2, none, [](const Point& p, std::span<double> v) { v[0] = p.x, v[1] = p.y; });
  set_field(mesh, "q", 1, FaceId{0}, [](const Point& p, std::span<double> v) { v[0] = p.x; });
  const DiffusionProblem problem = make_diffusion_problem(
      problem_of(R"("materials": {"*": {"source": "max(a, 2, x)^2 + exp(vel_x)*vel_y + q + k*t"}})", R"({"k": 3})"),
      mesh);
  const Coefficient& source = *problem.materials[0].source;
  const CoefficientPoint at = point_of(mesh, triangle_in(mesh, 0), {0.2, 0.3, 0.5}, 2);
  const double first = source(at);
  const long before = allocations;
  double sum = 0;
  for (int k = 0; k < 100; ++k) sum += source(at) - first;
  const long after = allocations;
  CHECK(after == before);
  CHECK(sum == 0);
}
#endif

TEST_CASE("any text is an expression or refused with its place", "[tools][problem][property]") {
  Mesh mesh = channel(1);
  set_field(mesh, "w", 1, none, [](const Point&, std::span<double> v) { v[0] = 2; });
  const std::vector<std::string> words{"x",  "y",        "t",   "k",   "w",   "u",    "sin", "(", ")",   "+",
                                       "-",  "*",        "/",   "^",   ",",   "?",    ":",   "<", "==",  "=",
                                       "&&", "||",       "!",   "1",   ".",   "e",    "2e3", " ", "min", "\"",
                                       "'",  "\xC3\xA9", "pow", "sum", "_pi", "0x1F", "#",   "{", "\n",  ">="};
  std::mt19937 random(3);
  ProblemDocument problem = problem_of(plain, R"({"k": 2})");
  int compiled = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (auto count = 1 + random() % 9; count > 0; --count) text += words[random() % words.size()];
    problem.diffuse->materials[0].second.source = text;
    try {
      const DiffusionProblem diffusion = make_diffusion_problem(problem, mesh);
      (*diffusion.materials[0].source)(point_of(mesh, TriangleId{0}, {0.5, 0.25, 0.25}, 1));
      ++compiled;
    } catch (const InputError& e) {
      ++refused;
      if (e.pointer() != "/problem/diffuse/materials/*/source") FAIL(text << " at " << e.pointer());
    }
  }
  CHECK(compiled > 50);
  CHECK(refused > 1000);
  problem.diffuse->materials[0].second.source = std::string(100000, '(');
  CHECK(refusal_of(problem, mesh).pointer == "/problem/diffuse/materials/*/source");
}

// tests/tools/stages_test.cpp: stages in one process do, to the bit, what their tools do in a pipe.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "run/exit_status.h"
#include "run_tools.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::testing;

namespace {

/// A problem for `diffuse` and `navierstokes`, in a file that is there as long as the program runs.
class ProblemFile {
 public:
  ProblemFile()
      : name_((std::filesystem::temp_directory_path() / ("stages_problem_" + std::to_string(getpid()))).string()) {
    std::ofstream(name_) << R"json({"format": "pliant-problem", "version": 1, "parameters": {"k": 0.1}, "diffuse": {
      "field": "heat", "materials": {"*": {"diffusivity": "k*(1+x^2)", "source": "sin(t)"}}, "initial": "x*y"},
      "navierstokes": {"materials": {"*": {"viscosity": 0.1}}, "force": ["k*y", "-k*x"],
                       "conditions": [{"curve": "*", "velocity": [0, 0]}]}})json";
  }
  ~ProblemFile() { std::remove(name_.c_str()); }
  ProblemFile(const ProblemFile&) = delete;
  ProblemFile& operator=(const ProblemFile&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};
std::string problem_file() {
  static const ProblemFile file;
  return file.name();
}

/// Every stage once, with what it must be told and nothing else.
Pipe bare() {
  return {{"advect", "--flow", "shear", "--dt", "0.2"},
          {"diffuse", "--problem", problem_file(), "--dt", "0.1"},
          {"navierstokes", "--problem", problem_file(), "--dt", "0.1"},
          {"flipdelaunay"},
          {"refine"},
          {"coarsen"},
          {"smoothcurves"},
          {"measure", "--face", "*:area", "--csv", "/dev/null"}};
}

/// Every stage once, with many of its options.
Pipe with_options() {
  return {
      {"advect", "--vx", "0.3*sin(y)*cos(t)", "--vy", "0.3*sin(2*x)+0.1*t", "--dt", "0.2", "--until", "0.5",
       "--substeps", "2", "--limit", "--keep-area"},
      {"diffuse", "--problem", problem_file(), "--set", "k=0.2", "--flow", "shear", "--dt", "0.05", "--steps", "2",
       "--scheme", "crank-nicolson", "--limit"},
      {"navierstokes", "--problem", problem_file(), "--dt", "0.05", "--steps", "2", "--scheme", "euler",
       "--mesh-velocity", "blend", "--vorticity", "--keep-area"},
      {"flipdelaunay", "--max-flips", "20", "--projection", "l2"},
      {"refine", "--size", "0.3+0.1*x*x", "--max-area", "0.2", "--max-turning", "35", "--projection", "conservative"},
      {"coarsen", "--tolerance", "1e-2", "--step-tolerance", "5e-3", "--factor", "1.5", "--region-change", "conserve",
       "--keep-area", "--feature-size", "2"},
      {"smoothcurves", "--max-distortion", "1.01", "--vertices", "--flips", "--split"},
      {"measure", "--face", "*:area,n=integral(x*y),centre,circularity", "--curve", "*:length,flux(x,y)", "--at",
       "0,0:x+t", "--value", "a=2*all_area", "--line", "0,0:1,1:5:x", "--csv", "/dev/null", "--lines-csv",
       "/dev/null"}};
}

/// A document that carries a field, one by face, and a velocity.
std::string with_fields(const std::string& document) {
  Words words{"advect",
              "--flow",
              "uniform",
              "--dt",
              "0.1",
              "--field",
              "u=sin(3*x)+y,x*y",
              "--field",
              "v=0.2*sin(y),0.1*cos(x)"};
  const BoundaryComplex boundary = read_mesh(document).boundary;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    words.push_back("--field");
    words.push_back("p@" + boundary.faces[f].name + "=x*x-" + std::to_string(f + 1) + "*y");
  }
  return output_of({words}, document);
}

std::string scaled(const std::string& document, int exponent) {
  MeshData data = read_mesh(document);
  const double factor = std::ldexp(1.0, exponent);
  for (Point& p : data.points) p *= factor;
  for (Point& p : data.boundary.vertices) p *= factor;
  for (Curve& curve : data.boundary.curves)
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
  std::string text;
  write_mesh(data, text);
  return text;
}

/// Sends a document through the tools and through the stages, again and again.
void check_equal(const Pipe& pipe, const std::string& document, int times) {
  const Stages stages(pipe);
  const std::string by_tools = output_of(repeated(pipe, times), document);
  const bool same = stages.output(document, times) == by_tools;
  CHECK(same);
}

}  // namespace

TEST_CASE("the pipes of these tests hold every stage", "[tools]") {
  for (const Pipe& pipe : {bare(), with_options()}) {
    std::vector<std::string> names;
    for (const Words& words : pipe) names.push_back(words.front());
    CHECK_THAT(names, Catch::UnorderedEquals(stage_names()));
  }
}

namespace {

/// Without the stage that wants degree 2 at least.
Pipe for_degree(int degree, Pipe pipe) {
  if (degree == 1) std::erase_if(pipe, [](const Words& words) { return words.front() == "navierstokes"; });
  return pipe;
}

}  // namespace

TEST_CASE("stages in one process give the bytes of the pipe of their tools", "[tools]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  const std::string document = degree == 1 ? document_of(Mesh(samples::three_disks(1))) : three_cells(degree);
  const std::string carrying = with_fields(document);
  SECTION("at bare defaults") { check_equal(for_degree(degree, bare()), document, 3); }
  SECTION("at bare defaults, with fields") { check_equal(for_degree(degree, bare()), carrying, 3); }
  SECTION("with options") { check_equal(for_degree(degree, with_options()), carrying, 3); }
  SECTION("carried by dopri5, and by a field with its acceleration") {
    check_equal({{"advect", "--vx", "sin(y+t)", "--vy", "x/9", "--dt", "0.1", "--method", "dopri5", "--limit"},
                 {"flipdelaunay"},
                 {"advect", "--velocity-field", "v", "--acceleration-field", "u", "--dt", "0.02", "--limit"}},
                carrying, 3);
  }
  SECTION("carried by the velocity of another mesh") {
    const std::string file = "stages_flow_" + std::to_string(degree) + ".json";
    std::ofstream(file) << carrying;
    check_equal(
        {{"advect", "--flow", file, "--flow-field", "v", "--outside", "nearest", "--dt", "0.1"}, {"flipdelaunay"}},
        carrying, 3);
    std::remove(file.c_str());
  }
  SECTION("carried by a field of the mesh") {
    check_equal({{"advect", "--velocity-field", "v", "--dt", "0.3"}, {"flipdelaunay"}, {"coarsen"}}, carrying, 3);
  }
  SECTION("each pass alone, twice") {
    for (const Words& words : for_degree(degree, with_options())) {
      CAPTURE(words.front());
      check_equal({words}, carrying, 2);
    }
  }
}

TEST_CASE("nothing of one mesh is left in a stage for the next one", "[tools]") {
  const std::string disk = document_of(Mesh(samples::disk(2))), cells = with_fields(three_cells(2)),
                    other = three_cells(3);
  for (const Pipe& pipe : {bare(), with_options()}) {
    const Stages stages(pipe);
    for (const std::string* document : {&cells, &disk, &other, &cells}) {
      const bool same = stages.output(*document) == output_of(pipe, *document);
      CHECK(same);
    }
  }
}

TEST_CASE("stages do with meshes of extreme sizes what their tools do", "[tools]") {
  const int exponent = GENERATE(100, -100, 59, 400);
  CAPTURE(exponent);
  check_equal({{"advect", "--vx", "x", "--vy", "y", "--dt", "1", "--limit"}, {"flipdelaunay"}, {"coarsen"}, {"refine"}},
              scaled(three_cells(2), exponent), 3);
}

TEST_CASE("a mesh that a stage may leave tangled is checked before one that wants it valid", "[tools]") {
  const std::string cells = three_cells(2);
  const Words forced{"advect", "--vx", "3*sin(9*y)", "--vy", "3*sin(8*x)", "--dt", "1", "--force"};
  const Words keeps_going{"smoothcurves", "--keep-going", "--max-sweeps", "1"};
  Mesh mesh = mesh_of(cells);
  CHECK_THROWS_AS(Stages({forced, {"refine"}}).run(mesh), BadMesh);
  CHECK_THROWS(output_of({forced, {"refine"}}, cells));
  check_equal({forced, keeps_going}, cells, 1);
  check_equal({{"advect", "--flow", "shear", "--dt", "0.1", "--force"}, {"refine"}}, cells, 2);  // valid all the same
}

TEST_CASE("stages say what they do to time and to tangled meshes", "[tools]") {
  for (const std::string& name : stage_names()) {
    CAPTURE(name);
    const auto stage = make_stage(name);
    REQUIRE(stage != nullptr);
    CHECK(name == stage->name());
    CHECK(stage->advances_time() == (name == "advect" || name == "diffuse" || name == "navierstokes"));
    CHECK(stage->accepts_tangled() == (name == "smoothcurves"));
    CHECK_FALSE(stage->may_leave_tangled());
  }
  CHECK(make_stage("evolve") == nullptr);
  CHECK(parse_stage({"advect", "--flow", "shear", "--dt", "1", "--force"})->may_leave_tangled());
  CHECK(parse_stage({"smoothcurves", "--keep-going"})->may_leave_tangled());
}

TEST_CASE("what a stage does not take is wrong usage, with a word on what is there", "[tools]") {
  const auto refused = [](const Words& words) -> std::string {
    try {
      parse_stage(words);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "nothing";
  };
  CHECK(refused({}) == "there is no stage ''");
  CHECK(refused({"qualityreport"}) == "there is no stage 'qualityreport'");
  CHECK(refused({"refine", "--max-aera", "1"}) ==
        "refine: there is no option --max-aera; the nearest one is --max-area");
  for (const char* common : {"-o", "--report", "-q", "--version"})
    CHECK_THAT(refused({"coarsen", common}), Catch::StartsWith("coarsen: there is no option "));
  CHECK(refused({"coarsen", "mesh.json"}) == "coarsen: a stage reads no INPUT, 'mesh.json' is too much");
  CHECK_THAT(refused({"advect", "--flow", "shear"}), Catch::Contains("--dt is required"));
  CHECK_THAT(refused({"refine", "--size", "x+"}), Catch::Contains("--size"));
  CHECK_THAT(refused({"smoothcurves", "--global"}), Catch::Contains("--global"));
}

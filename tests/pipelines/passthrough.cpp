// tests/pipelines/passthrough.cpp: a filter that leaves the mesh alone, or fails as it is told: what every tool
// inherits.
#include <CLI/CLI.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "options/criteria_options.h"
#include "options/problem_option.h"
#include "problem/diffusion.h"
#include "problem/incompressible.h"
#include "run/exit_status.h"
#include "run/run_filter.h"

namespace {

using namespace pliant;

class PassThroughStage : public Stage {
 public:
  const char* name() const override { return "passthrough"; }
  const char* description() const override { return "Pass meshes through."; }
  bool accepts_tangled() const override { return accepts_tangled_; }

  void add_options(CLI::App& app) override {
    app.add_option("--stop-at", stop_at_, "no result from this time on");
    app.add_option("--spoil-at", spoil_at_, "make a number that is not finite from this time on");
    app.add_option("--fault", fault_, "throw an exception that a tool does not expect, of this kind");
    app.add_flag("--tangled", accepts_tangled_, "take tangled meshes");
    app.add_option("--naps", naps_, "sleep so many tenths of a second a mesh, and count them");
    criteria_.add(app);
    problem_.add(app);
  }

  void check(const CLI::App& app) override {
    criteria_.check();
    problem_.check(app);
    has_problem_ = app.count("--problem") + app.count("--set") + app.count("--explain") > 0;
    if (fault_ == "early") throw std::runtime_error("told to fail");
  }

  PassReport run(Mesh& mesh, const StageContext& context) const override {
    if (mesh.time >= stop_at_) throw NoResult("told to stop");
    if (fault_ == "logic") throw std::logic_error("told to fail");
    if (fault_ == "length") throw std::length_error("told to fail");
    if (fault_ == "integer") throw 7;
    if (mesh.time >= spoil_at_) mesh.time = std::numeric_limits<double>::quiet_NaN();
    criteria_.apply(mesh.criteria, mesh.boundary());
    if (has_problem_) {
      const ProblemDocument problem = problem_.load(mesh);
      std::string words;
      if (problem.navierstokes) words = explain(problem_.make_flow(problem, mesh), problem, mesh);
      if (problem.diffuse || !problem.navierstokes)
        words += explain(problem_.make_diffusion(problem, mesh), problem, mesh);
      if (problem_.wants_explanation()) context.say(words);
    }
    if (context.progress != nullptr) context.progress->start("sleep", "naps", naps_);
    for (int nap = 0; nap < naps_; ++nap) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (context.progress != nullptr) context.progress->count(nap + 1);
    }
    PassReport report;
    report.add("triangles", mesh.triangle_count());
    report.add("half", 0.5);
    report.refuse("would \"invert\"", 3);
    for (int k = 0; k < 1200; ++k) report.refuse("too far", {0.5 + k, -2});
    report.notes.push_back("nothing was done");
    return report;
  }

 private:
  double stop_at_ = std::numeric_limits<double>::infinity();
  double spoil_at_ = std::numeric_limits<double>::infinity();
  std::string fault_;
  int naps_ = 0;
  bool accepts_tangled_ = false;
  bool has_problem_ = false;
  CriteriaOptions criteria_;
  ProblemOption problem_;
};

}  // namespace

int main(int argc, char** argv) {
  PassThroughStage stage;
  return run_filter(stage, argc, argv);
}

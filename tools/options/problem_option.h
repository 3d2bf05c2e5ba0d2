// tools/options/problem_option.h: --problem, --set and --explain: what is to be solved on a mesh.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "formats/problem/problem_document.h"
#include "pliant/fem/diffusion/diffusion_problem.h"
#include "pliant/fem/navier_stokes/flow_problem.h"
#include "pliant/mesh/mesh.h"

namespace CLI {
class App;
}

namespace pliant {

/// The problem of a file, or of the mesh that carries one.
class ProblemOption {
 public:
  /// Adds --problem, --set (repeatable) and --explain.
  void add(CLI::App& app);
  /// Reads what was parsed, and the file.
  /// Throws      UsageError; Placed for a faulty file, with its place; std::system_error
  void check(const CLI::App& app);
  /// Was --explain given?
  bool wants_explanation() const { return wants_explanation_; }

  /// The problem with the parameters of --set: of the file, where there is one, else the one that the mesh carries. A
  /// mesh carries it (its document's member `problem`) from then on.
  /// Throws      InputError where there is none, or a faulty one; UsageError where --set names no parameter of it
  ProblemDocument load(Mesh& mesh) const;
  /// make_diffusion_problem with a problem that `load` has returned; what it throws tells the line of the file.
  DiffusionProblem make_diffusion(const ProblemDocument& problem, const Mesh& mesh) const;
  /// The same of make_flow_problem.
  FlowProblem make_flow(const ProblemDocument& problem, const Mesh& mesh) const;
  /// Runs `work` on a problem that `load` has returned. Where --problem gave it, an InputError with a pointer below
  /// "/problem" comes out with the line of the file.
  void in_problem(const std::function<void()>& work) const;

 private:
  void read_file();
  void set_parameters(ProblemDocument& problem) const;

  std::string file_;
  std::vector<std::string> set_texts_;
  bool wants_explanation_ = false;
  std::vector<std::pair<std::string, double>> set_;
  std::string text_;  ///< of the file
  ProblemDocument problem_;
  std::shared_ptr<const DocumentValue> carried_;  ///< the same as a mesh carries it
};

}  // namespace pliant

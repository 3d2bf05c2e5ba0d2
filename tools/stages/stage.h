// tools/stages/stage.h: the options, the check and the pass of one mesh-to-mesh tool, as an object.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/mesh/progress.h"

namespace CLI {
class App;
}

namespace pliant {

/// What the program that runs a stage gives it, anew in each run.
struct StageContext {
  std::function<void(const std::string&)> say = [](const std::string&) {};  ///< takes warnings, a sentence each
  Progress* progress = nullptr;  ///< is told how far the pass has come; null where nobody looks
  bool wants_details = false;    ///< somebody reads the report: what only it shows is worth computing
  /// Where a loop steps to: a stage that moves time on goes no further than this time, and where its step is unsafe
  /// takes the safe part of it, unless its options say otherwise.
  std::optional<double> goal{};
};

/// One mesh-to-mesh tool without its process: a program adds its options to a parser, parses, calls `check` once, and
/// then runs it on as many meshes as it likes. Nothing of one run is left for the next one.
class Stage {
 public:
  virtual ~Stage() = default;
  Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  virtual const char* name() const = 0;         ///< of the tool
  virtual const char* description() const = 0;  ///< the sentence on top of --help
  /// Does a run move `mesh.time` on?
  virtual bool advances_time() const { return false; }
  /// For a stage that advances time, after `check`: the length of its step, and the option with which it stops by
  /// itself at a time that was given; null if it does not.
  virtual double time_step() const { return 0; }
  virtual const char* own_end() const { return nullptr; }
  /// The index of the field of the mesh that is the velocity of such a stage; none where it has another velocity.
  /// Throws      InputError where the mesh has no such field
  virtual int velocity_field(const Mesh& /*mesh*/) const { return none; }
  /// Does a run that throws NoResult leave the mesh as it was?
  virtual bool keeps_refused_mesh() const { return false; }
  /// May elements of the mesh be invalid before?
  virtual bool accepts_tangled() const { return false; }
  /// May a run, with the options that were checked, leave elements invalid?
  virtual bool may_leave_tangled() const { return false; }

  /// Adds the tool's own options; once. The parser lives until `check` has returned.
  virtual void add_options(CLI::App& app) = 0;
  /// Reads what was parsed, and compiles expressions; before any mesh is read.   Throws UsageError
  virtual void check(const CLI::App& app) = 0;
  /// Do the options that were checked ask for text in place of meshes, as an explanation of what the stage would do?
  virtual bool explains() const { return false; }
  /// The option that asks for it.
  virtual const char* explaining_option() const { return "--explain"; }
  /// That text, whole lines; the mesh is then of no further use.   Throws UsageError, InputError
  virtual std::string explanation(Mesh& /*mesh*/) const { return {}; }
  /// Works on a mesh: valid unless the stage accepts tangled ones, and in the numbering of its document, before and
  /// after. The report is in the units of the mesh (`run_stage` brings it into the document's).
  /// Throws      UsageError, InputError, NoResult (the mesh is then unspecified)
  virtual PassReport run(Mesh& mesh, const StageContext& context) const = 0;
};

}  // namespace pliant

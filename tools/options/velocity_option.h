// tools/options/velocity_option.h: --vx with --vy, --flow or --velocity-field: the velocity that moves a mesh.
#pragma once
#include <string>

#include "pliant/flow/velocity_field.h"
#include "pliant/mesh/mesh.h"

namespace CLI {
class App;
}

namespace pliant {

/// Exactly one of the three ways to give a velocity.
class VelocityOption {
 public:
  /// Adds --vx, --vy, --flow, --velocity-field and what goes with them. `--flow help` ends the parsing, as --help
  /// does, with the list of the flows.
  void add(CLI::App& app);
  /// Reads what was parsed, compiles the expressions and reads the file of a flow.   Throws UsageError, and what
  /// read_flow throws
  void check(const CLI::App& app);
  /// Was one of the three ways given?
  static bool is_given(const CLI::App& app);
  /// The velocity in units of the document; empty with --velocity-field.
  const VelocityField& velocity() const { return velocity_; }
  /// The index of the field that --velocity-field names.   Throws InputError
  int find_field(const Mesh& mesh) const;
  /// The same for --acceleration-field; none if it was not given.   Throws InputError
  int find_acceleration(const Mesh& mesh) const;

 private:
  std::string vx_, vy_, flow_, field_, acceleration_, flow_field_ = "velocity", outside_ = "error";
  VelocityField velocity_;
};

}  // namespace pliant

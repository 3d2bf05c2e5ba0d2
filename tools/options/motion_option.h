// tools/options/motion_option.h: how a mesh moves in one step: velocity, length of the step, method, what stops it.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "options/velocity_option.h"
#include "pliant/flow/advect_to.h"

namespace pliant {

/// The options of a certified step of motion.
class MotionOption {
 public:
  /// What a stage offers of it.
  struct Offer {
    bool may_force = false;  ///< --force: take unsafe steps, too
    bool may_rest = false;   ///< without a velocity the mesh stays where it is, and only time goes on
    bool by_itself = false;  ///< the stage knows the velocity: there are no options for one, nor for methods
  };
  void add(CLI::App& app, Offer offer);
  /// Reads what was parsed.   Throws UsageError, and what read_flow throws
  void check(const CLI::App& app);

  static bool is_given(const CLI::App& app);  ///< Was any of these options given?
  bool moves() const { return moves_; }
  double dt() const { return options_.dt; }
  bool forces() const { return options_.policy == StepPolicy::force; }
  const std::optional<double>& until() const { return until_; }
  /// The index of the mesh's field that is the velocity; none where it is another.   Throws InputError
  int velocity_field(const Mesh& mesh) const { return !moves_ || flow_.velocity() ? none : flow_.find_field(mesh); }

  /// Takes a step towards `goal`, if a loop has one, else towards --until. The result is a step that was taken whole or
  /// in part, or none because the mesh is at that time or later.
  /// Throws      NoResult where no step is possible; the mesh is then as it was
  AdvectOutcome move(Mesh& mesh, std::optional<double> goal) const;
  /// The same by a step of the stage, for `by_itself`.
  AdvectOutcome move(Mesh& mesh, std::optional<double> goal, const Step& step) const;
  /// The same where only time goes on.
  AdvectOutcome rest(Mesh& mesh, std::optional<double> goal) const;

 private:
  void add_method(CLI::App& app);
  void check_method(const CLI::App& app);
  using Towards = std::function<AdvectOutcome(const AdvectOptions&, std::optional<double> until)>;
  AdvectOutcome take(Mesh& mesh, std::optional<double> goal, const Towards& advance) const;

  Offer offer_;
  VelocityOption flow_;
  AdvectOptions options_;
  std::optional<double> until_;
  std::string dt_text_, until_text_, method_ = "rk4", tolerance_text_;
  std::string min_gap_text_, gap_ = "stop";
  double min_gap_ = 0;
  bool limit_ = false, force_ = false, moves_ = true;
};

}  // namespace pliant

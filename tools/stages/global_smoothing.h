// tools/stages/global_smoothing.h: smoothcurves --global and its options, also in programs without the smoother.
#pragma once
#include <string>

#include "stages/global_smoother.h"

namespace CLI {
class App;
}

namespace pliant {
struct StageContext;

class GlobalSmoothing {
 public:
  /// `smoother` may be null.
  explicit GlobalSmoothing(const GlobalSmoother* smoother) : smoother_(smoother) {}
  /// Adds --global, --good and --rings, and --version where the smoother has a licence to tell of.
  void add(CLI::App& app);
  bool has_smoother() const { return smoother_ != nullptr; }
  bool is_wanted() const { return is_wanted_; }
  /// Throws UsageError where --global was asked for and there is no smoother, a value is wrong, or an option of local
  /// smoothing was given with it.
  void check(const CLI::App& app);
  SmoothOutcome run(Mesh& mesh, bool vertices, const RefitOptions& refit, const StageContext& context) const;
  /// GlobalSmoother::advice; empty without a smoother.
  std::string advice(SmoothOutcome& outcome, const Mesh& result, bool vertices) const;

 private:
  const GlobalSmoother* smoother_;
  bool is_wanted_ = false;
  std::string good_ = "0.999";
  GlobalSmoothOptions options_;
};

}  // namespace pliant

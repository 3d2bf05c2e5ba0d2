// tools/global_smoothing.h: smoothcurves --global and its options, also in builds without the smoother.
#pragma once
#include <string>

#include "pliant/improve/global/smooth_globally.h"
#include "pliant/improve/smooth_curves.h"

namespace CLI {
class App;
}

namespace pliant {

class GlobalSmoothing {
 public:
  /// Adds --global, --good and --rings; sets --version to say under which licence a binary with Ceres goes out.
  explicit GlobalSmoothing(CLI::App& app);
  bool is_wanted() const { return is_wanted_; }
  /// Throws UsageError where --global was asked for and this binary was built without it, a value is wrong, or an
  /// option of local smoothing was given with it.
  void prepare();
  SmoothOutcome run(Mesh& mesh, bool vertices, const RefitOptions& refit);
  /// A sentence, if --global would have made a better mesh of the input than local smoothing has: fewer elements
  /// invalid, or as many, neither the least shape nor the least scaled Jacobian lower, and one of them higher. It is
  /// tried: small meshes as a whole, of large ones what was too curved and the rings around it. Else empty, as in
  /// builds without the smoother and where the outcome has no input.
  std::string advice(SmoothOutcome& outcome, const Mesh& result, bool vertices) const;

 private:
  CLI::App* app_;
  bool is_wanted_ = false;
  std::string good_ = "0.999";
  GlobalSmoothOptions options_;
};

}  // namespace pliant

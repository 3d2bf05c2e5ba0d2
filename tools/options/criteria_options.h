// tools/options/criteria_options.h: --min-angle, --max-area and the other criteria of refine, coarsen, bspline2mesh.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/mesh_data.h"

namespace CLI {
class App;
}

namespace pliant {

/// The function of a size expression in x, y and t.   Throws std::invalid_argument where it is no formula
SizeFunction compile_size(const std::string& text);

/// The criteria as given on the command line. An option replaces its entry of the document and is written back.
class CriteriaOptions {
 public:
  /// Adds --min-angle DEG, --max-area AREA, --face-area NAME=AREA (repeatable), --size EXPR, --max-turning DEG,
  /// --accuracy LENGTH,
  /// --min-size LENGTH and --thin keep|refine; with `fields`, for tools that read meshes, --size-field NAME. Values are
  /// checked in `check`, so that wrong ones are wrong usage.
  void add(CLI::App& app, bool fields = true);
  /// Reads the texts of the options and compiles the size; call it before any input is read (Stage::check).   Throws
  /// UsageError
  void check();
  /// Writes what was given into the criteria of a document.
  /// Throws      UsageError where --face-area names a face that the boundary does not have
  void apply(Criteria& criteria, const BoundaryComplex& boundary) const;
  /// apply, then the goals of the mesh.
  /// Throws      UsageError or, where the expression of a size came with the document, InputError
  QualityGoals goals(Mesh& mesh) const;

 private:
  std::optional<std::string> min_angle_text_, max_area_text_, max_turning_text_, accuracy_text_, min_size_text_,
      size_text_, thin_text_, size_field_;
  std::vector<std::string> face_area_texts_;
  Criteria given_;
  SizeFunction given_size_;  // given_.size, compiled
};

}  // namespace pliant

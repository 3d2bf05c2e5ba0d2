// tools/criteria_options.h: --min-angle, --max-area and the other criteria of refine, coarsen, bspline2mesh.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/improve/sizing.h"
#include "pliant/mesh/mesh_data.h"

namespace CLI {
class App;
}

namespace pliant {
struct ToolOptions;

/// A finite number from an option's text, all of it.   Throws UsageError that names the option
double parse_number(const std::string& option, const std::string& text);
/// The same, above zero.
double parse_positive(const std::string& option, const std::string& text);
double parse_not_negative(const std::string& option, const std::string& text);
/// NAME=NUMBER, split at the last '='; the number finite and above zero.
std::pair<std::string, double> parse_named_number(const std::string& option, const std::string& text);

/// --max-triangles N: more are no result.
void add_max_triangles(CLI::App& app, long& most);

/// Says beforehand, unless -q, that thin gaps ask for very many triangles, where, and what leaves them.
void warn_of_thin_gaps(const ToolOptions& options, const Mesh& mesh, const QualityGoals& goals);

/// The function of a size expression in x, y and t.   Throws std::invalid_argument where it is no formula
SizeFunction compile_size(const std::string& text);

/// The criteria as given on the command line. An option replaces its entry of the document and is written back.
class CriteriaOptions {
 public:
  /// Adds --min-angle DEG, --max-area AREA, --face-area NAME=AREA (repeatable), --size EXPR, --max-turning DEG,
  /// --min-size LENGTH and --thin keep|refine; with `fields`, for tools that read meshes, --size-field NAME. Values are
  /// checked in `check`, so that wrong ones are wrong usage.
  void add(CLI::App& app, bool fields = true);
  /// Reads the texts of the options; call it before any input is read (FilterOptions::prepare).   Throws UsageError
  void check();
  /// Writes what was given into the criteria of a document.
  /// Throws      UsageError where --face-area names a face that the boundary does not have
  void apply(Criteria& criteria, const BoundaryComplex& boundary) const;
  /// apply, then the goals of the mesh; `compile` makes a function of an expression in x, y, t and throws
  /// std::invalid_argument where it is none.
  /// Throws      UsageError or, where the expression came with the document, InputError
  QualityGoals goals(Mesh& mesh, const std::function<SizeFunction(const std::string&)>& compile) const;

 private:
  std::optional<std::string> min_angle_text_, max_area_text_, max_turning_text_, min_size_text_, size_text_, thin_text_,
      size_field_;
  std::vector<std::string> face_area_texts_;
  Criteria given_;
};

}  // namespace pliant

// tools/options/criteria_options.cpp: from the texts of options to criteria of a document.
#include "options/criteria_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "options/expression.h"
#include "options/numbers.h"
#include "pliant/mesh/override_criteria.h"
#include "run/exit_status.h"

namespace pliant {

SizeFunction compile_size(const std::string& text) {
  return [size = Expression(text)](const Point& p, double time) { return size(p.x, p.y, time); };
}

void CriteriaOptions::add(CLI::App& app, bool fields) {
  app.add_option("--min-angle", min_angle_text_, "least angle of a logical triangle, degrees; 0: any")
      ->type_name("DEG");
  app.add_option("--max-area", max_area_text_, "greatest area of an element")->type_name("AREA");
  app.add_option("--face-area", face_area_texts_, "greatest area of an element in one face (repeatable)")
      ->type_name("FACE=AREA")
      ->allow_extra_args(false);
  app.add_option("--size", size_text_, "wanted edge length, an expression in x, y, t")->type_name("EXPR");
  if (fields)
    app.add_option("--size-field", size_field_, "wanted edge length, too: the values of this field")
        ->type_name("FIELD");
  app.add_option("--max-turning", max_turning_text_, "greatest angle by which an edge turns, degrees")
      ->type_name("DEG");
  app.add_option("--accuracy", accuracy_text_,
                 "how far curves may be from smooth ones that they stand for; edges are as fine as that asks for")
      ->type_name("LENGTH");
  app.add_option("--min-size", min_size_text_, "no two vertices closer than this")->type_name("LENGTH");
  app.add_option("--thin", thin_text_,
                 "keep or refine triangles across gaps that are thin for the spans beside them; default: refine")
      ->type_name("keep|refine")
      ->check(CLI::IsMember({"keep", "refine"}).description(""));
}

void CriteriaOptions::check() {
  given_ = {};
  if (min_angle_text_) {
    given_.min_angle = parse_number("--min-angle", *min_angle_text_);
    if (!(*given_.min_angle >= 0 && *given_.min_angle < 60))
      throw UsageError("--min-angle: '" + *min_angle_text_ + "' should be from 0 to below 60 degrees");
  }
  if (max_area_text_) given_.max_area = parse_positive("--max-area", *max_area_text_);
  for (const std::string& text : face_area_texts_) {
    auto bound = parse_named_number("--face-area", text);
    const auto same = [&](const auto& other) { return other.first == bound.first; };
    if (std::any_of(given_.face_area.begin(), given_.face_area.end(), same))
      throw UsageError("--face-area: the face '" + bound.first + "' is given twice");
    given_.face_area.push_back(std::move(bound));
  }
  if (size_text_) {
    given_.size = *size_text_;
    try {
      given_size_ = compile_size(*size_text_);
    } catch (const std::invalid_argument& e) {
      throw UsageError(std::string("--size: ") + e.what());
    }
  }
  if (size_field_) given_.size_field = *size_field_;
  if (max_turning_text_) given_.max_turning = parse_positive("--max-turning", *max_turning_text_);
  if (accuracy_text_) given_.accuracy = parse_positive("--accuracy", *accuracy_text_);
  if (thin_text_) given_.keeps_thin = *thin_text_ == "keep";
  if (min_size_text_) given_.min_size = parse_positive("--min-size", *min_size_text_);
}

void CriteriaOptions::apply(Criteria& criteria, const BoundaryComplex& boundary) const {
  try {
    override_criteria(criteria, given_, boundary);
  } catch (const std::invalid_argument& e) {
    throw UsageError(std::string("--face-area: ") + e.what());
  }
}

QualityGoals CriteriaOptions::goals(Mesh& mesh) const {
  apply(mesh.criteria, mesh.boundary());
  SizeFunction size;
  if (mesh.criteria.size) {
    try {
      size = given_size_ ? given_size_ : compile_size(*mesh.criteria.size);
      require_lengths(mesh, size);
    } catch (const std::invalid_argument& e) {
      if (given_.size) throw UsageError(std::string("--size: ") + e.what());
      throw InputError("/criteria/size", e.what());
    }
  }
  try {
    return goals_of(mesh, std::move(size));
  } catch (const std::invalid_argument& e) {
    if (given_.size_field) throw UsageError(std::string("--size-field: ") + e.what());
    throw InputError("/criteria/size_field", e.what());
  }
}

}  // namespace pliant

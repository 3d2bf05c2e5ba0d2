// tools/problem/on_mesh.cpp: names of faces and curves become indices, and those that do not fit are refused.
#include "problem/on_mesh.h"

#include <algorithm>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/describe.h"

namespace pliant {

std::string require_section(const ProblemDocument& problem, const char* name, bool is_there) {
  if (is_there) return std::string("/problem/") + name;
  std::vector<std::string> sections;
  if (problem.diffuse) sections.emplace_back("diffuse");
  if (problem.navierstokes) sections.emplace_back("navierstokes");
  for (const auto& extra : problem.extra) sections.push_back(extra.first);
  throw InputError("/problem", std::string("lacks the section \"") + name + "\"" +
                                   (sections.empty() ? "" : "; its other members are " + quote_names(sections)));
}

void refuse_below(const Coefficient& coefficient, bool zero_is_allowed, const std::string& place, const char* what) {
  const std::optional<double>& value = coefficient.constant();
  if (!value || *value > 0 || (zero_is_allowed && *value == 0)) return;
  throw InputError(place, std::string(what) + " is " + describe_number(*value) + ", but " +
                              (zero_is_allowed ? "should not be negative" : "should be above zero"));
}

std::string describe_sides(const BoundaryComplex& boundary, const Curve& curve) {
  const auto quoted = [&boundary](int face) { return "'" + boundary.faces[index(face)].name + "'"; };
  if (curve.left == outside && curve.right == outside) return "beside no face";
  if (is_outer(curve)) return "outer boundary of " + quoted(std::max(curve.left, curve.right));
  if (curve.left == curve.right) return "in " + quoted(curve.left);
  return "between " + quoted(curve.left) + " and " + quoted(curve.right);
}

std::size_t face_at(const BoundaryComplex& boundary, const std::string& name, const std::string& place) {
  const int face = find_face(boundary, name);
  if (face != outside) return index(face);
  std::vector<std::string> names;
  for (const Face& each : boundary.faces) names.push_back(each.name);
  throw InputError(place, "there is no face \"" + name + "\"" + known_names(name, "faces", names));
}

void refuse_bare(const std::vector<std::string>& bare, const std::string& place) {
  if (bare.empty()) return;
  const bool is_one = bare.size() == 1;
  throw InputError(place, (is_one ? "the face " : "the faces ") + quote_names(bare) + (is_one ? " has" : " have") +
                              " no material; \"*\" stands for all that are not named");
}

CurveNames::CurveNames(const BoundaryComplex& boundary) {
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const std::string& name = boundary.curves[c].name;
    const auto [entry, is_new] = curves_.try_emplace(name);
    if (is_new) names_.push_back(name);
    entry->second.push_back(c);
  }
}

const std::vector<std::size_t>& CurveNames::at(const std::string& name, const std::string& place) const {
  const auto found = curves_.find(name);
  if (found == curves_.end())
    throw InputError(place, "there is no curve \"" + name + "\"" + known_names(name, "curves", names_));
  return found->second;
}

void CurveConditions::add(const std::vector<std::string>& curves) {
  const std::size_t k = count_++;
  for (std::size_t n = 0; n < curves.size(); ++n) {
    const std::string place = place_of(k) + "/curve" + (curves.size() > 1 ? "/" + std::to_string(n) : "");
    if (curves[n] == "*") {
      if (others_)
        throw InputError(place, "\"*\" has a condition already, that of conditions/" + std::to_string(others_->first));
      others_.emplace(k, place);
      continue;
    }
    for (const std::size_t c : names_.at(curves[n], place)) set(c, k, place);
  }
}

std::vector<int> CurveConditions::finish() {
  for (std::size_t c = 0; others_ && c < condition_of_curve_.size(); ++c)
    if (condition_of_curve_[c] == none && is_outer(boundary_.curves[c])) set(c, others_->first, others_->second);
  return std::move(condition_of_curve_);
}

void CurveConditions::set(std::size_t c, std::size_t condition, const std::string& place) {
  const int curve = static_cast<int>(c);
  int& known = condition_of_curve_[c];
  if (known != none)
    throw InputError(place, describe_curve(boundary_, curve) +
                                (index(known) == condition
                                     ? " is named twice here"
                                     : " has a condition already, that of conditions/" + std::to_string(known)));
  check_(condition, curve, place);
  known = static_cast<int>(condition);
}

}  // namespace pliant

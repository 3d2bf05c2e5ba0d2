// tools/problem/on_mesh.h: what any section of a problem says of faces and curves, as those of one mesh.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/problem/names.h"
#include "formats/problem/problem_document.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/fem/coefficient.h"

namespace pliant {

/// The place of a section: "/problem/NAME". An error that the document has no such section lists what it has.
/// Throws      InputError where `is_there` is false
std::string require_section(const ProblemDocument& problem, const char* name, bool is_there);

/// Refuses a constant below 0, and 0 unless that is allowed; `what` it is, with its article.   Throws InputError
void refuse_below(const Coefficient& coefficient, bool zero_is_allowed, const std::string& place, const char* what);

/// Is the curve part of the outer boundary?
inline bool is_outer(const Curve& curve) { return curve.left == outside || curve.right == outside; }

/// The faces or the curve beside which it lies: "outer boundary of 'a'", "in 'a'", "between 'a' and 'b'".
std::string describe_sides(const BoundaryComplex& boundary, const Curve& curve);

// -- faces

/// The index of a face that the problem names.   Throws InputError at `place`
std::size_t face_at(const BoundaryComplex& boundary, const std::string& name, const std::string& place);
/// Refuses faces that have no material.
/// Throws      InputError at `place`, unless `bare`, their names, is empty
void refuse_bare(const std::vector<std::string>& bare, const std::string& place);

/// For each face what the entry of its name becomes, or else that of "*"; none where neither is there.
/// `make(value, entry's place)` is called for each entry, in order, `place_of(name)` gives the place.
template <class Value, class PlaceOf, class Make>
auto by_face(const BoundaryComplex& boundary, const std::vector<std::pair<std::string, Value>>& entries,
             const PlaceOf& place_of, const Make& make) {
  using Made = std::optional<decltype(make(entries.front().second, std::string()))>;
  std::vector<Made> made(boundary.faces.size());
  Made others;
  for (const auto& [name, value] : entries) {
    const std::string place = place_of(name);
    if (name == "*") {
      others = make(value, place);
    } else {
      const std::size_t face = face_at(boundary, name, place);
      made[face] = make(value, place);
    }
  }
  for (Made& each : made)
    if (!each) each = others;
  return made;
}

/// The materials of all faces, from the section's member `materials`.
/// Throws      InputError for unknown faces, and for faces without a material
template <class Value, class Make>
auto materials_of(const BoundaryComplex& boundary, const std::vector<std::pair<std::string, Value>>& entries,
                  const std::string& section, const Make& make) {
  const std::string place = section + "/materials";
  auto made = by_face(
      boundary, entries, [&place](const std::string& name) { return place + pointer_step(name); }, make);
  std::vector<decltype(make(entries.front().second, place))> materials;
  std::vector<std::string> bare;
  for (std::size_t f = 0; f < made.size(); ++f) {
    if (made[f])
      materials.push_back(std::move(*made[f]));
    else
      bare.push_back(boundary.faces[f].name);
  }
  refuse_bare(bare, place);
  return materials;
}

// -- curves

/// The curves of a boundary by their names, which several may share.
class CurveNames {
 public:
  explicit CurveNames(const BoundaryComplex& boundary);
  /// All curves of that name.   Throws InputError at `place` where there is none
  const std::vector<std::size_t>& at(const std::string& name, const std::string& place) const;

 private:
  std::vector<std::string> names_;  ///< each once, in the order of the curves
  std::map<std::string, std::vector<std::size_t>> curves_;
};

/// Which condition each curve has, from what conditions name one after the other.
class CurveConditions {
 public:
  /// Throws InputError at `place` where a condition cannot stand on a curve.
  using Check = std::function<void(std::size_t condition, int curve, const std::string& place)>;

  CurveConditions(const BoundaryComplex& boundary, const std::string& section, Check check)
      : boundary_(boundary), names_(boundary), section_(section), check_(std::move(check)) {
    condition_of_curve_.assign(boundary.curves.size(), none);
  }

  /// Where the next condition stands.
  std::string place() const { return place_of(count_); }
  /// Sets the next condition on the curves of these names.
  /// Throws      InputError for an unknown curve, or one that has a condition
  void add(const std::vector<std::string>& curves);
  /// Sets the condition of "*" on outer curves that have none. The result: for each curve its condition, or none.
  std::vector<int> finish();

 private:
  std::string place_of(std::size_t condition) const { return section_ + "/conditions/" + std::to_string(condition); }
  void set(std::size_t c, std::size_t condition, const std::string& place);

  const BoundaryComplex& boundary_;
  CurveNames names_;
  std::string section_;
  Check check_;
  std::size_t count_ = 0;
  std::vector<int> condition_of_curve_;
  std::optional<std::pair<std::size_t, std::string>> others_;  ///< which condition "*" has, and where it stands
};

}  // namespace pliant

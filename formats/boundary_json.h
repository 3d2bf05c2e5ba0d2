#pragma once  // formats/boundary_json.h: the boundary as a member of other documents
#include "formats/read_json.h"
#include "formats/write_json.h"

namespace pliant {

/// Reads the boundary's object where it stands. Without `alone`, `format` and `version` may be missing.
BoundaryComplex read_boundary_object(JsonReader& in, bool alone);
void write_boundary_object(JsonWriter& out, const BoundaryComplex& boundary, bool alone);

/// Checks a `format` or `version` member where it stands.
void read_format(JsonReader& in, std::string_view format);
void read_version(JsonReader& in);

/// Which members of an object were there.
class Presence {
 public:
  explicit Presence(JsonReader& in) : in_(in) {}
  /// True, noted, if `name` is `member`.
  bool is(std::string_view name, const char* member) {
    if (name != member) return false;
    seen_.push_back(member);
    return true;
  }
  bool has(std::string_view member) const;
  /// Refuses an object that lacks one of these, beside the one of its unknown members that looks like it.
  void require(std::initializer_list<const char*> members, const ExtraMembers& unknown = {}) const;

 private:
  JsonReader& in_;
  std::vector<std::string_view> seen_;
};

}  // namespace pliant

// formats/document/presence.h: which members of an object were there, and which others were meant to be one.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_reader.h"

namespace pliant {

/// Which members of an object were there.
class Presence {
 public:
  explicit Presence(DocumentReader& in) : in_(in) {}
  /// True, noted, if `name` is `member`.
  bool is(std::string_view name, const char* member) {
    if (name != member) return false;
    seen_.push_back(member);
    return true;
  }
  bool has(std::string_view member) const;
  /// Refuses an object that lacks one of these, beside the one of its unknown members that looks like it.
  void require(std::initializer_list<const char*> members, const ExtraMembers& unknown = {}) const;
  /// Doubts each unknown member whose name is a misspelling of a missing one of these.
  void doubt(std::initializer_list<const char*> members, const ExtraMembers& unknown) const;
  /// The same, and doubts the other unknown members too, with this text: nothing acts on them.
  void doubt_all(std::initializer_list<const char*> members, const ExtraMembers& unknown,
                 const std::string& text) const;
  /// "; is \"strat\" meant to be it?", if an unknown member is a misspelling of `member`; else empty.
  static std::string suggest(std::string_view member, const ExtraMembers& unknown);

 private:
  /// The one of `members` that is missing and that `name` misspells; empty if there is none.
  std::string_view meant_by(std::string_view name, std::initializer_list<const char*> members) const;

  DocumentReader& in_;
  std::vector<std::string_view> seen_;
};

/// Is `name` a misspelling of `member`? One that differs only in case, underscores and hyphens is; so is one with a
/// typing error, or with two in a longer name. Short words differ by one letter that mean different things ("end",
/// "and"): of these only the exchange of two letters counts.
bool is_misspelling(std::string_view name, std::string_view member);

}  // namespace pliant

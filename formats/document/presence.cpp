// formats/document/presence.cpp: members compared by how their names are typed.
#include "formats/document/presence.h"

#include <algorithm>
#include <cctype>

#include "formats/document/recognize.h"

namespace pliant {
namespace {

/// Names in one style of writing: max_area, maxArea and max-area are the same.
std::string in_one_style(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (c != '_' && c != '-' && c != ' ') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

bool is_misspelling(std::string_view name, std::string_view member) {
  if (name == member) return false;
  const std::string typed = in_one_style(name), known = in_one_style(member);
  if (typed == known) return true;
  const int errors = typing_errors(typed, known);
  if (known.size() <= 3)
    return errors == 1 && std::is_permutation(typed.begin(), typed.end(), known.begin(), known.end());
  return errors <= (known.size() < 8 ? 1 : 2);
}

bool Presence::has(std::string_view member) const {
  return std::find(seen_.begin(), seen_.end(), member) != seen_.end();
}

std::string Presence::suggest(std::string_view member, const ExtraMembers& unknown) {
  for (const auto& [name, value] : unknown)
    if (is_misspelling(name, member)) return "; is \"" + name + "\" meant to be it?";
  return {};
}

void Presence::require(std::initializer_list<const char*> members, const ExtraMembers& unknown) const {
  for (const char* member : members) {
    if (has(member)) continue;
    std::vector<std::string> names;
    for (const auto& [name, value] : unknown) names.push_back(name);
    const std::string similar = nearest_word(member, names);
    in_.fail(std::string("lacks the member \"") + member + "\"" +
             (similar.empty() ? suggest(member, unknown) : "; is \"" + similar + "\" meant to be it?"));
  }
}

std::string_view Presence::meant_by(std::string_view name, std::initializer_list<const char*> members) const {
  for (const char* member : members)
    if (!has(member) && is_misspelling(name, member)) return member;
  return {};
}

void Presence::doubt(std::initializer_list<const char*> members, const ExtraMembers& unknown) const {
  doubt_all(members, unknown, {});
}

void Presence::doubt_all(std::initializer_list<const char*> members, const ExtraMembers& unknown,
                         const std::string& text) const {
  for (const auto& [name, value] : unknown) {
    const std::string_view member = meant_by(name, members);
    if (!member.empty())
      in_.doubt(name, "is kept, but not known; is \"" + std::string(member) + "\" meant?");
    else if (!text.empty())
      in_.doubt(name, text);
  }
}

}  // namespace pliant

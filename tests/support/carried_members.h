// tests/support/carried_members.h: unknown members of documents, made from JSON and shown as JSON.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "formats/document/mesh_document.h"

namespace pliant::samples {

using MemberTexts = std::vector<std::pair<std::string, std::string>>;

inline ExtraMembers carried(const MemberTexts& members) {
  ExtraMembers extra;
  for (const auto& [name, json] : members) extra.emplace_back(name, read_value(json));
  return extra;
}

inline MemberTexts texts_of(const ExtraMembers& extra) {
  MemberTexts members;
  for (const auto& [name, value] : extra) members.emplace_back(name, write_value(*value));
  return members;
}

}  // namespace pliant::samples

// formats/document/history.cpp: reads and writes the member `history`.
#include "formats/document/history.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/document/document_value.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr const char* history_member = "history";

template <class Extra>
auto find_history(Extra& extra) {
  return std::ranges::find(extra, history_member, &ExtraMembers::value_type::first);
}

bool is_entry(const Json& value) {
  const auto is_text = [&value](const char* name) { return value.contains(name) && value[name].is_string(); };
  return value.is_object() && is_text("tool") && is_text("version") && value.contains("options") &&
         value["options"].is_array() &&
         std::ranges::all_of(value["options"], [](const Json& option) { return option.is_string(); });
}

}  // namespace

void require_history(const ExtraMembers& extra) {
  const auto found = find_history(extra);
  if (found != extra.end() && !to_json(*found->second).is_array())
    throw InputError(std::string("/") + history_member, "is no array of tools, so that none can be added to it");
}

void add_history(ExtraMembers& extra, const HistoryEntry& entry) {
  require_history(extra);
  const auto found = find_history(extra);
  Json entries = found == extra.end() ? Json::array() : to_json(*found->second);
  entries.push_back({{"tool", entry.tool}, {"version", entry.version}, {"options", entry.options}});
  if (found == extra.end())
    extra.emplace_back(history_member, to_document(std::move(entries)));
  else
    found->second = to_document(std::move(entries));
}

std::vector<HistoryEntry> history_of(const ExtraMembers& extra) {
  std::vector<HistoryEntry> entries;
  const auto found = find_history(extra);
  if (found == extra.end() || !to_json(*found->second).is_array()) return entries;
  for (const Json& value : to_json(*found->second))
    if (is_entry(value))
      entries.push_back({value["tool"], value["version"], value["options"].get<std::vector<std::string>>()});
  return entries;
}

void inherit_history(ExtraMembers& from, ExtraMembers& to) {
  const auto found = find_history(from);
  if (found == from.end() || !to_json(*found->second).is_array()) return;
  Json entries = to_json(*found->second);
  const auto own = find_history(to);
  if (own == to.end()) {
    to.emplace_back(history_member, found->second);
  } else if (const Json& later = to_json(*own->second); later.is_array()) {
    entries.insert(entries.end(), later.begin(), later.end());
    own->second = to_document(std::move(entries));
  } else {
    return;
  }
  from.erase(found);
}

}  // namespace pliant

// formats/document/history.h: the member `history` of a document, the tools that have made it (formats/mesh.md).
#pragma once
#include <string>
#include <vector>

#include "pliant/boundary/extra_members.h"

namespace pliant {

/// One tool that has worked on a document.
struct HistoryEntry {
  std::string tool, version;
  std::vector<std::string> options;  ///< as they stand on a command line, names and values in turn
};

/// Throws      InputError if there is a member `history` that is no array, so that no entry can be added to it
void require_history(const ExtraMembers& extra);

/// Adds the entry behind the others, in a member of its own if there are none.
///
/// Throws      as require_history
void add_history(ExtraMembers& extra, const HistoryEntry& entry);

/// The entries, in their order; those of another form than `add_history` gives them are left out.
std::vector<HistoryEntry> history_of(const ExtraMembers& extra);

/// Moves the history of one document in front of that of another, which is made from it. A member `history` that is no
/// array stays where it is.
void inherit_history(ExtraMembers& from, ExtraMembers& to);

}  // namespace pliant

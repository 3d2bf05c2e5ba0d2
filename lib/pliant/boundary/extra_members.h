// lib/pliant/boundary/extra_members.h: members of a document that Pliant does not know, and carries along.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// A value of a document that nothing in the library looks into. Only formats/ makes and writes it.
class DocumentValue;

/// Members of a document object that Pliant does not know: names and values, in their order. They are kept and written
/// back. A value is never null and never changes, so that copies of a mesh share it.
using ExtraMembers = std::vector<std::pair<std::string, std::shared_ptr<const DocumentValue>>>;

}  // namespace pliant

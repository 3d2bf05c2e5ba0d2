// formats/problem/section_json.h: what the sections of a problem document have in common, read and written.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/document/document_reader.h"
#include "formats/document/document_writer.h"
#include "formats/document/presence.h"
#include "formats/problem/problem_document.h"

namespace pliant {

// -- reading; each fails at the place that is now being read

/// Refuses the member now being read: whoever wrote it meant something by it, and nothing would act on it.
[[noreturn]] void refuse_member(const DocumentReader& in, std::string_view name, const std::vector<std::string>& known);

std::string read_name(DocumentReader& in);
ProblemExpression read_expression(DocumentReader& in);
/// An array of expressions, as many as `count`; `what` they are.
std::vector<ProblemExpression> read_expressions(DocumentReader& in, std::size_t count, const char* what);

/// The member `curve` of a condition: one name or some.
std::vector<std::string> read_curves(DocumentReader& in);

/// An object whose members have names that the document chooses, such as faces; `read` takes the value of one.
template <class Read>
auto read_by_name(DocumentReader& in, const Read& read) {
  std::vector<std::pair<std::string, decltype(read(in))>> entries;
  in.object([&](std::string_view name) {
    entries.emplace_back(std::string(name), read(in));
    return true;
  });
  return entries;
}

/// Which kind a condition is of: the one member that says so.
class ConditionKind {
 public:
  explicit ConditionKind(DocumentReader& in) : in_(in) {}
  /// Takes note of the member now being read, which says it; refuses a second one.
  void set(std::string_view member);
  /// Refuses a condition that has none of these members.
  void require(const std::vector<std::string>& members) const;

 private:
  DocumentReader& in_;
  std::string member_;
};

// -- writing

void write_expression(DocumentWriter& out, const ProblemExpression& expression);
/// One expression as such, several as an array.
void write_expressions(DocumentWriter& out, const std::vector<ProblemExpression>& expressions);
void write_curves(DocumentWriter& out, const std::vector<std::string>& curves);

/// The opposite of read_by_name; `write` writes one value.
template <class Value, class Write>
void write_by_name(DocumentWriter& out, const std::vector<std::pair<std::string, Value>>& entries, const Write& write) {
  out.begin_object();
  for (const auto& [name, value] : entries) write(out.name(name), value);
  out.end_object();
}

}  // namespace pliant

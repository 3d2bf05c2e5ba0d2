// formats/problem/section_json.cpp: expressions, names of curves and kinds of conditions, read and written.
#include "formats/problem/section_json.h"

#include "formats/problem/names.h"

namespace pliant {

void refuse_member(const DocumentReader& in, std::string_view name, const std::vector<std::string>& known) {
  in.fail("is not known here" + known_names(name, "members", known));
}

std::string read_name(DocumentReader& in) {
  if (in.kind() != DocumentReader::Kind::string) in.fail("should be a name in quotes");
  return in.string();
}

ProblemExpression read_expression(DocumentReader& in) {
  const DocumentReader::Kind kind = in.kind();
  if (kind == DocumentReader::Kind::string) return in.string();
  if (kind != DocumentReader::Kind::number) in.fail("should be a number, or an expression in quotes");
  return in.number();
}

std::vector<ProblemExpression> read_expressions(DocumentReader& in, std::size_t count, const char* what) {
  std::vector<ProblemExpression> parts;
  in.array([&] {
    if (parts.size() == count) in.fail(std::string("is one too many: ") + what);
    parts.push_back(read_expression(in));
  });
  if (parts.size() != count) in.fail(std::string("has too few: ") + what);
  return parts;
}

std::vector<std::string> read_curves(DocumentReader& in) {
  if (in.kind() != DocumentReader::Kind::array) return {read_name(in)};
  std::vector<std::string> names;
  in.array([&] { names.push_back(read_name(in)); });
  if (names.empty()) in.fail("should name a curve");
  return names;
}

void ConditionKind::set(std::string_view member) {
  if (!member_.empty()) in_.fail("stands beside \"" + member_ + "\": a condition has one of them");
  member_ = member;
}

void ConditionKind::require(const std::vector<std::string>& members) const {
  if (!member_.empty()) return;
  std::string text;
  for (std::size_t k = 0; k < members.size(); ++k)
    text += (k == 0 ? "\"" : k + 1 == members.size() ? " or \"" : ", \"") + members[k] + "\"";
  in_.fail("says nothing of its curve: " + text + " is wanted");
}

void write_expression(DocumentWriter& out, const ProblemExpression& expression) {
  if (const double* number = std::get_if<double>(&expression))
    out.value(*number);
  else
    out.value(std::get<std::string>(expression));
}

void write_expressions(DocumentWriter& out, const std::vector<ProblemExpression>& expressions) {
  if (expressions.size() == 1) return write_expression(out, expressions.front());
  out.begin_array();
  for (const ProblemExpression& each : expressions) write_expression(out, each);
  out.end_array();
}

void write_curves(DocumentWriter& out, const std::vector<std::string>& curves) {
  if (curves.size() == 1) {
    out.value(curves.front());
    return;
  }
  out.begin_array();
  for (const std::string& name : curves) out.value(name);
  out.end_array();
}

}  // namespace pliant

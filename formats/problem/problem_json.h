// formats/problem/problem_json.h: the problem document, read as JSON or CBOR and written as JSON (formats/problem.md).
#pragma once
#include <string>
#include <string_view>

#include "formats/problem/problem_document.h"

namespace pliant {

/// Reads one problem document: its grammar, types and members, and the names of its parameters. What its texts say, and
/// whether faces and curves exist, is known only beside a mesh.
/// Throws      DocumentError with a JSON pointer and the place
ProblemDocument read_problem(std::string_view document);
/// The same where the document is the member `problem` of a mesh.
/// Throws      InputError with a pointer from the root of the mesh document
ProblemDocument read_problem(const DocumentValue& value);

/// Appends the document, one line with its newline. What was written, read and written again is the same, byte for
/// byte.
void write_problem(const ProblemDocument& problem, std::string& out);
/// The document as a value that a mesh carries.
std::shared_ptr<const DocumentValue> problem_value(const ProblemDocument& problem);

}  // namespace pliant

// formats/document/document_place.h: the line and column of the value that a JSON pointer names.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

/// Counted from 1, from the start of the document; columns are bytes.
struct DocumentPlace {
  long line = 1, column = 1;
};

/// A member that a document may have, but that is probably not what was meant.
struct Doubt {
  std::string pointer, text;
  long more = 0;  ///< others of this kind
};

/// "TEXT (column 12)": messages begin with the line, for editors, and end with the column.
std::string with_column(const std::string& text, const DocumentPlace& place);

/// Where `at` stands in the document.
DocumentPlace place_of_byte(std::string_view json, std::size_t at);

/// Where the value starts that `pointer` (RFC 6901) names, or the innermost value around it that is there: a check
/// that blames "/points/7" need not keep the positions of all numbers, since they are found again once it has failed.
///
/// Requires    that the text is JSON, or the start of some; of any other text the place is somewhere in it
/// Complexity  one pass over the text before the value, no memory
DocumentPlace find_place(std::string_view json, std::string_view pointer);

}  // namespace pliant

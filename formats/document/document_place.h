// formats/document/document_place.h: where in a document the value stands that a JSON pointer names.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// A place in a document, from its start. In JSON: line and column, counted from 1; columns are bytes. In CBOR, which
/// has no lines: the byte, counted from 0.
struct DocumentPlace {
  long line = 1, column = 1;
  std::int64_t byte = -1;  ///< of CBOR; negative in JSON
};

/// A member that a document may have, but that is probably not what was meant.
struct Doubt {
  std::string pointer, text;
  long more = 0;  ///< others of this kind
};

/// A long array of numbers in a document: its bytes from `begin` to `end`; where its numbers all have the same `width`,
/// they start at `first`.
struct NumberArray {
  std::size_t begin = 0, end = 0, first = 0, width = 0;
};

/// "TEXT (column 12)", for messages, which begin with the line; "TEXT (byte 345)" of CBOR.
std::string with_offset(const std::string& text, const DocumentPlace& place);

/// Where `at` stands in a JSON document.
DocumentPlace place_of_byte(std::string_view json, std::size_t at);

/// Where the value starts that `pointer` (RFC 6901) names, or the innermost value around it that is there: a check
/// that blames "/points/7" need not keep the positions of all numbers, since they are found again once it has failed.
///
/// Requires    that the bytes are a document, or the start of some; of others the place is somewhere in them
/// Complexity  one pass over the bytes before the value, no memory
DocumentPlace find_place(std::string_view document, std::string_view pointer);

/// A document without its long arrays of numbers: it finds places when the bytes are gone.
class DocumentOutline {
 public:
  DocumentOutline() = default;
  /// `arrays`: those of its reader.
  DocumentOutline(std::string_view document, const std::vector<NumberArray>& arrays);
  /// As find_place of the whole document. The places of single numbers in long arrays of JSON are those of their array.
  DocumentPlace find(std::string_view pointer) const;

 private:
  struct Cut {
    NumberArray array;
    std::size_t at = 0;          // where what stands for the array begins in the outline
    long lines = 0;              // line breaks in the document before the array's end
    std::size_t line_start = 0;  // of the document's line in which the array ends
  };
  std::string text_;
  std::vector<Cut> cuts_;
};

}  // namespace pliant

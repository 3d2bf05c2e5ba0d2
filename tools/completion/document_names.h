// tools/completion/document_names.h: the names in a document, found without reading its numbers.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct DocumentNames {
  struct Field {
    std::string name;
    int components = 1;
  };
  std::vector<std::string> faces, curves;
  std::vector<Field> fields;
  std::vector<std::string> parameters;  ///< of a problem, or of the problem that a mesh carries
};

/// The names in the text of a JSON document: a mesh, a boundary or a problem. Nothing is checked: what is not as it
/// should be has no names, and a text that ends too soon has those that came before.
///
/// Complexity  one pass, which takes apart only the objects that hold names
DocumentNames names_in_json(std::string_view text);

/// The names in the first document of a file of any kind that tools read meshes, boundaries and problems from. A file
/// that is not a regular one is not opened; one that cannot be read has no names.
DocumentNames names_in_file(const std::string& path);

}  // namespace pliant

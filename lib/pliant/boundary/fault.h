// lib/pliant/boundary/fault.h: one breach of an invariant, in words.
#pragma once
#include <stdexcept>
#include <string>

namespace pliant {

/// A breach of an invariant of the boundary complex or of the mesh.
struct Fault {
  std::string invariant;  ///< "M1" .. "M6", "boundary", "contact" (curves that meet where they must not), "document"
  std::string place;      ///< a JSON pointer into the document, for example "/triangles/42"
  std::string text;       ///< what is wrong, and what would be right
};

/// Bad input, thrown by readers with the place in the document. The tools end with status 3.
class InputError : public std::runtime_error {
 public:
  InputError(std::string pointer, const std::string& text) : std::runtime_error(text), pointer_(std::move(pointer)) {}
  const std::string& pointer() const { return pointer_; }

 private:
  std::string pointer_;
};

}  // namespace pliant

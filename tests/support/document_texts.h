// tests/support/document_texts.h: documents as texts, the same texts with a fault, and the place that the reader names.
#pragma once
#include <catch2/catch.hpp>
#include <string>

#include "formats/document/mesh_document.h"

namespace pliant::samples {

inline std::string text_of(const MeshData& mesh) {
  std::string text;
  write_mesh(mesh, text);
  return text;
}

inline std::string text_of(const BoundaryComplex& boundary) {
  std::string text;
  write_boundary(boundary, text);
  return text;
}

/// The text with the first occurrence of `from` replaced.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The pointer of the fault that `read` ends in; "accepted" if it ends well.
template <class Read>
std::string fault_place(const Read& read) {
  try {
    read();
  } catch (const InputError& e) {
    CHECK(std::string(e.what()).size() > 10);
    return e.pointer();
  }
  return "accepted";
}

}  // namespace pliant::samples

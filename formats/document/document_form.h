// formats/document/document_form.h: the two forms of a document, JSON and CBOR, told apart by the first bytes.
#pragma once
#include <functional>
#include <string_view>

namespace pliant {

enum class DocumentForm { json, cbor };

/// Does CBOR begin with this byte, that of an array, a map or a tag? All else is for the reader of JSON.
inline bool begins_cbor(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte >= 0x80 && byte < 0xE0;
}
inline DocumentForm form_of(std::string_view document) {
  return !document.empty() && begins_cbor(document.front()) ? DocumentForm::cbor : DocumentForm::json;
}

/// Takes the bytes of a document piece by piece.
using DocumentSink = std::function<void(std::string_view)>;

}  // namespace pliant

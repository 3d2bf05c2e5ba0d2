// tools/completion/document_names.cpp: looks for names in a document, passing over everything else by its brackets.
#include "completion/document_names.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "formats/document/cbor/read_cbor.h"
#include "formats/document/document_stream.h"
#include "formats/document/mesh_document.h"
#include "formats/document/read_json.h"
#include "formats/msh/msh.h"

namespace pliant {
namespace {

constexpr int max_depth = 64;  // as deep as readers go

/// Passes over values of a JSON text. At the end of the text everything is empty.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  /// Calls member(name) for each member of the object that stands next; it may read the value.
  template <class F>
  void object(F member) {
    if (!take('{')) return skip();
    while (peek() == '"') {
      const std::string name = string();
      if (!take(':')) return stop();
      const std::size_t before = at_;
      member(name);
      if (at_ == before) skip();
      if (!take(',')) break;
    }
    if (!take('}')) stop();
  }

  /// Calls element() for each, which must read it.
  template <class F>
  void array(F element) {
    if (!take('[')) return skip();
    while (peek() != ']' && peek() != '\0') {
      element();
      if (!take(',')) break;
    }
    if (!take(']')) stop();
  }

  /// The string that stands next; another value is passed over, and gives an empty one.
  std::string string() {
    const std::size_t from = (peek(), at_);
    const bool is_string = peek() == '"';
    skip();
    if (!is_string) return {};
    try {
      return JsonReader(text_.substr(from, at_ - from)).string();
    } catch (const InputError&) {
      return {};
    }
  }

  int integer() {
    peek();
    const std::string digits(text_.substr(at_, 12));
    skip();
    return std::atoi(digits.c_str());
  }

  /// Passes over the next value.
  void skip() {
    int depth = 0;
    do {
      const char c = peek();
      if (c == '"') {
        skip_string();
      } else if (c == '{' || c == '[') {
        ++at_;
        if (++depth > max_depth) return stop();
      } else if (c == '}' || c == ']') {
        ++at_;
        --depth;
      } else if (depth == 0) {
        skip_word();
      }
      if (depth > 0) skip_to_bracket();
    } while (depth > 0 && at_ < text_.size());
    if (depth < 0) stop();
  }

 private:
  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' || text_[at_] == '\r'))
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) { return peek() == c && (++at_, true); }
  void stop() { at_ = text_.size(); }

  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    at_ = std::min(at_ + 1, text_.size());
  }

  void skip_word() { at_ = std::min(text_.find_first_of("\"{}[],: \t\r\n", at_ + 1), text_.size()); }

  /// Passes over numbers, words and what separates values: to the next bracket or string.
  void skip_to_bracket() {
    static const auto stops = [] {
      std::array<bool, 256> table{};
      for (const char c : {'"', '{', '}', '[', ']'}) table[static_cast<unsigned char>(c)] = true;
      return table;
    }();
    while (at_ < text_.size() && !stops[static_cast<unsigned char>(text_[at_])]) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void add_new(std::vector<std::string>& names, std::string name) {
  if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
}

void find_names(Scanner& in, std::vector<std::string>& names) {
  in.array([&] {
    in.object([&](const std::string& member) {
      if (member == "name") add_new(names, in.string());
    });
  });
}

void find_fields(Scanner& in, DocumentNames& found) {
  in.array([&] {
    DocumentNames::Field field;
    in.object([&](const std::string& member) {
      if (member == "name") field.name = in.string();
      if (member == "components") field.components = in.integer();
    });
    if (!field.name.empty()) found.fields.push_back(std::move(field));
  });
}

/// The members of a mesh, a boundary or a problem: each name stands for the same in all three.
void find_members(Scanner& in, DocumentNames& found, int depth) {
  in.object([&](const std::string& member) {
    if (member == "faces") find_names(in, found.faces);
    if (member == "curves") find_names(in, found.curves);
    if (member == "fields") find_fields(in, found);
    if (member == "parameters") in.object([&](const std::string& name) { add_new(found.parameters, name); });
    if ((member == "boundary" || member == "problem") && depth == 0) find_members(in, found, depth + 1);
  });
}

DocumentNames names_of(const MeshData& mesh) {
  DocumentNames found;
  for (const Face& face : mesh.boundary.faces) add_new(found.faces, face.name);
  for (const Curve& curve : mesh.boundary.curves) add_new(found.curves, curve.name);
  for (const auto& field : mesh.fields) found.fields.push_back({field.name, field.components});
  for (const auto& [name, value] : mesh.extra)
    if (name == "problem") found.parameters = names_in_json(write_value(*value)).parameters;
  return found;
}

DocumentNames names_in_cbor(std::string_view document) {
  try {
    return names_of(read_mesh(document));
  } catch (const InputError&) {  // a boundary or a problem, which are short
    return names_in_json(write_value(*CborReader(document).value()));
  }
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

DocumentNames names_in_json(std::string_view text) {
  DocumentNames found;
  Scanner in(text);
  find_members(in, found, 0);
  return found;
}

DocumentNames names_in_file(const std::string& path) {
  try {
    if (!std::filesystem::is_regular_file(path)) return {};
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) return {};
    DocumentStream stream(file.get(), path);
    if (const std::string_view bytes = stream.all_if("$"); !bytes.empty()) return names_of(read_msh(bytes, {}).mesh);
    std::string_view document;
    if (!stream.next(document)) return {};
    return document.starts_with('{') ? names_in_json(document) : names_in_cbor(document);
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace pliant

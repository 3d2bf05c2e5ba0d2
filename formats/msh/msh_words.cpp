// formats/msh/msh_words.cpp: faults of a mesh in the words of the MSH file it came from.
#include <charconv>
#include <optional>

#include "formats/msh/msh.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// Goes through a text and writes it with other numbers: tags for indices.
class Rewriter {
 public:
  explicit Rewriter(std::string_view text) : rest_(text) {}

  /// Passes `word` and the number behind it if both stand here.
  std::optional<std::size_t> number_behind(std::string_view word) {
    if (rest_.substr(0, word.size()) != word) return std::nullopt;
    std::size_t value = 0;
    const char* first = rest_.data() + word.size();
    const auto [stop, error] = std::from_chars(first, rest_.data() + rest_.size(), value);
    if (error != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
    return value;
  }
  bool at_end() const { return rest_.empty(); }
  void copy_one() {
    out += rest_.front();
    rest_.remove_prefix(1);
  }

  std::string out;

 private:
  std::string_view rest_;
};

std::string tag_text(const TagRuns& tags, std::size_t index) {
  return index < tags.size() ? std::to_string(tags.tag_of(index)) : "(none)";
}

}  // namespace

Fault in_msh_words(const MshImport& import, const Fault& fault) {
  Fault result = fault;
  const auto size = static_cast<std::size_t>(net_size(import.mesh.degree));
  Rewriter place(fault.place);
  if (const auto k = place.number_behind("/triangles/"))
    result.place = "element " + tag_text(import.elements, *k / size);
  else if (const auto t = place.number_behind("/triangle_faces/"))
    result.place = "element " + tag_text(import.elements, *t);
  else if (const auto x = place.number_behind("/points/"))
    result.place = "node " + tag_text(import.nodes, *x / 2);

  Rewriter text(fault.text);
  while (!text.at_end()) {
    if (const auto t = text.number_behind("triangle "))
      text.out += "element " + tag_text(import.elements, *t);
    else if (const auto p = text.number_behind("point "))
      text.out += "node " + tag_text(import.nodes, *p);
    else if (const auto a = text.number_behind("points ")) {
      text.out += "nodes " + tag_text(import.nodes, *a);
      if (const auto b = text.number_behind(" and ")) text.out += " and " + tag_text(import.nodes, *b);
    } else
      text.copy_one();
  }
  result.text = text.out;
  return result;
}

}  // namespace pliant

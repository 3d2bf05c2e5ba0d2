// formats/document/recognize.cpp: by the first bytes, as `file` does.
#include "formats/document/recognize.h"

#include <algorithm>

namespace pliant {
namespace {

/// What the bytes are, and which tool reads them; "" for what is not known.
struct Kind {
  std::string_view name, advice;
  bool is_document = false;
  std::string_view format = {};
};

constexpr Kind svg_drawing{"an SVG drawing", "which import-svg reads"};
constexpr Kind msh_file{"a Gmsh MSH file", "which import-msh reads"};

Kind recognize_xml(std::string_view head) {
  const auto holds = [head](std::string_view tag) { return head.find(tag) != std::string_view::npos; };
  if (holds("<svg") || holds(":svg")) return svg_drawing;
  if (holds("<VTKFile")) return {"a VTK file", "which no tool of Pliant reads"};
  if (holds("<html") || holds("<!DOCTYPE html") || holds("<!doctype html"))
    return {"an HTML page", "perhaps of a failed download"};
  return {"an XML file", "which is no document of Pliant"};
}

Kind recognize_json(std::string_view head) {
  const auto holds = [head](std::string_view text) { return head.find(text) != std::string_view::npos; };
  if (holds("\"pliant-mesh\"")) return {"a mesh", "", true, "pliant-mesh"};
  if (holds("\"pliant-boundary\"")) return {"a boundary", "", true, "pliant-boundary"};
  if (holds("\"pliant-problem\"")) return {"a problem", "", true, "pliant-problem"};
  if (holds("\"asset\"") && holds("\"version\"")) return {"a glTF file", "which no tool of Pliant reads"};
  if (holds("\"FeatureCollection\"") || holds("\"Feature\""))
    return {"a GeoJSON file", "which no tool of Pliant reads"};
  return {"a JSON document", "", true};
}

Kind recognize(std::string_view bytes) {
  std::string_view head = bytes.substr(0, recognized_by);
  const auto starts = [&head](std::string_view magic) { return head.substr(0, magic.size()) == magic; };
  if (starts("\x1F\x8B")) return {"a file that gzip compressed", "gzip -d < FILE | TOOL reads it"};
  if (starts("glTF")) return {"a binary glTF file", "which no tool of Pliant reads"};
  if (starts("\x89PNG") || starts("\xFF\xD8\xFF") || starts("GIF8")) return {"a picture of pixels", "not of curves"};
  if (starts("%PDF")) return {"a PDF file", "which a drawing program can save as SVG"};
  if (starts("%!PS")) return {"a PostScript file", "which a drawing program can save as SVG"};
  if (starts("\xFF\xFE") || starts("\xFE\xFF")) return {"a text in UTF-16", "while UTF-8 is read"};
  if (starts("# vtk DataFile")) return {"a VTK file", "which no tool of Pliant reads"};
  if (starts("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  head.remove_prefix(first);
  if (head.find("$MeshFormat") != std::string_view::npos || starts("$NOD") || starts("$Comments")) return msh_file;
  if (head.front() == '<') return recognize_xml(head);
  if (head.front() == '{') return recognize_json(head);
  return {};
}

}  // namespace

std::string describe_other_format(std::string_view format) {
  if (format == "pliant-mesh") return "this is a mesh, which all tools but bspline2mesh and import-* read";
  if (format == "pliant-boundary") return "this is a boundary, of which bspline2mesh makes a mesh";
  if (format == "pliant-problem")
    return "this is a problem, which diffuse and navierstokes read with --problem beside a mesh";
  return {};
}

std::string describe_other_kind(std::string_view bytes, FileKind wanted) {
  const Kind kind = recognize(bytes);
  if (kind.name.empty()) return {};
  const bool wants_document = wanted != FileKind::svg && wanted != FileKind::msh;
  if ((wanted == FileKind::svg && kind.name == svg_drawing.name) ||
      (wanted == FileKind::msh && kind.name == msh_file.name))
    return {};
  if (kind.is_document && wants_document) return {};  // its reader says more
  if (!kind.format.empty()) return describe_other_format(kind.format);
  std::string text = "this is " + std::string(kind.name);
  if (!kind.advice.empty()) text += ", " + std::string(kind.advice);
  return text;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string nearest;
  int least = static_cast<int>(word.size() + 2) / 3 + 1;
  for (const std::string& candidate : candidates) {
    const int errors = typing_errors(word, candidate);
    if (errors >= least) continue;
    least = errors;
    nearest = candidate;
  }
  return nearest;
}

int typing_errors(std::string_view a, std::string_view b) {
  constexpr std::size_t longest = 64;  // longer words are not typed
  if (a.size() > longest || b.size() > longest) return a == b ? 0 : static_cast<int>(longest);
  std::vector<int> older(b.size() + 1), old(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    older = old;
    old = row;
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({old[j] + 1, row[j - 1] + 1, old[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], older[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace pliant

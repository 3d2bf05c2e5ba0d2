// formats/document/recognize.cpp: by the first bytes, as `file` does.
#include "formats/document/recognize.h"

#include <algorithm>
#include <iterator>

#include "formats/document/document_form.h"

namespace pliant {
namespace {

/// What the bytes are, and what to do with them; "" for what is not known.
struct DocumentKind {
  std::string_view name, advice;
  bool is_document = false;
  std::string_view format = {};
};

constexpr std::string_view of_no_tool = ", which no tool of Pliant reads";
constexpr DocumentKind svg_drawing{"an SVG drawing",
                                   ": import-svg makes a boundary of it, bspline2mesh a mesh of that"};
constexpr DocumentKind msh_file{"a Gmsh MSH file",
                                ": import-msh makes a mesh of it, and tools that read meshes take it as it is"};
constexpr DocumentKind vtk_file{"a VTK file", of_no_tool};
constexpr DocumentKind gltf_file{"a glTF file", ", a picture that export-gltf makes of a mesh; no tool reads it"};
constexpr DocumentKind quality_report{"a report of qualityreport's", ": give the mesh that it is about"};
constexpr DocumentKind pass_report{"a report of what a tool did (--report)", ": give the mesh that the tool wrote"};
constexpr DocumentKind evolve_log{"a log of evolve's", ": give the frames that evolve wrote (-o)"};

DocumentKind recognize_xml(std::string_view head) {
  const auto holds = [head](std::string_view tag) { return head.find(tag) != std::string_view::npos; };
  if (holds("<svg") || holds(":svg")) return svg_drawing;
  if (holds("<VTKFile")) return vtk_file;
  if (holds("<html") || holds("<!DOCTYPE html") || holds("<!doctype html"))
    return {"an HTML page", ": a report for reading, or what a failed download has left"};
  return {"an XML file", ", which is no document of Pliant"};
}

/// JSON or CBOR: the names of members look the same in both.
DocumentKind recognize_document(std::string_view head) {
  const auto holds = [head](std::string_view text) { return head.find(text) != std::string_view::npos; };
  for (const std::string_view format : {"pliant-mesh", "pliant-boundary", "pliant-problem"})
    if (holds(format)) return {"a document", "", true, format};
  if (holds("asset") && holds("version") && !holds("\"format\"")) return gltf_file;
  if (holds("\"FeatureCollection\"") || holds("\"Feature\"")) return {"a GeoJSON file", of_no_tool};
  if (holds("\"tool\":") && holds("\"frame\":")) return pass_report;
  if (holds("\"step\":") && holds("\"part\":") && holds("\"dt\":")) return evolve_log;
  if (holds("\"control_points\":") && holds("\"overlaps\":")) return quality_report;
  if (head.front() != '{') return {"CBOR, but no document of Pliant's", "", true};
  return {"a JSON document", "", true};
}

/// A header of tar's, of any age: 512 bytes with the sum of all in it, for which its own digits count as spaces.
bool begins_tar(std::string_view head) {
  constexpr std::size_t header = 512, sum_at = 148, sum_digits = 8;
  if (head.size() < header) return false;
  long sum = 0, stated = 0;
  int digits = 0;
  for (std::size_t k = 0; k < header; ++k) {
    const bool is_in_sum = k >= sum_at && k < sum_at + sum_digits;
    sum += is_in_sum ? ' ' : static_cast<unsigned char>(head[k]);
    if (!is_in_sum || head[k] < '0' || head[k] > '7') continue;
    stated = 8 * stated + (head[k] - '0');
    ++digits;
  }
  return digits > 0 && stated == sum;
}

/// Archives, and what is compressed by other programs than those that are decompressed on the way here. Bytes of gzip
/// or zstd have come out of others, so that the file was compressed twice.
DocumentKind recognize_packed(std::string_view head) {
  using namespace std::string_view_literals;
  struct Magic {
    std::string_view bytes;
    DocumentKind kind;
  };
  constexpr DocumentKind xz{"a file that xz compressed",
                            ": xz -dc FILE | TOOL reads it (gzip and zstd need no such help)"};
  constexpr DocumentKind bzip2{"a file that bzip2 compressed",
                               ": bzip2 -dc FILE | TOOL reads it (gzip and zstd need no such help)"};
  constexpr DocumentKind lzma{"a file that lzma compressed",
                              ": xz -dc FILE | TOOL reads it (gzip and zstd need no such help)"};
  constexpr DocumentKind lzip{"a file that lzip compressed",
                              ": lzip -dc FILE | TOOL reads it (gzip and zstd need no such help)"};
  constexpr DocumentKind lz4{"a file that lz4 compressed",
                             ": lz4 -dc FILE | TOOL reads it (gzip and zstd need no such help)"};
  constexpr DocumentKind compress{"a file that compress made (.Z)", ": gzip -dc FILE | TOOL reads it"};
  constexpr DocumentKind twice{"a file that was compressed twice",
                               ": decompress it once, by gzip -dc FILE or zstd -dc FILE, and give that to the tool"};
  static constexpr Magic magics[] = {
      {"PK\x03\x04", {"a zip archive", ": extract its files first, by unzip FILE"}},
      {"PK\x05\x06", {"a zip archive without files", ": give a document"}},
      {"7z\xBC\xAF\x27\x1C", {"a 7z archive", ": extract its files first, by 7z x FILE"}},
      {"Rar!\x1A\x07", {"a rar archive", ": extract its files first, by unrar x FILE"}},
      {"\xFD\x37zXZ", xz},
      {"BZh", bzip2},
      {"LZIP", lzip},
      {"\x5D\x00\x00"sv, lzma},
      {"\x04\x22\x4D\x18", lz4},
      {"\x02\x21\x4C\x18", lz4},
      {"\x1F\x9D", compress},
      {"\x1F\x8B", twice},
      {"\x28\xB5\x2F\xFD", twice}};
  if (begins_tar(head)) return {"a tar archive", ": extract its files first, by tar -xf FILE"};
  const auto* const found =
      std::ranges::find_if(magics, [&](const Magic& each) { return head.starts_with(each.bytes); });
  return found == std::end(magics) ? DocumentKind{} : found->kind;
}

/// What is known by its first bytes.
DocumentKind recognize_magic(std::string_view head) {
  struct Magic {
    std::string_view bytes;
    DocumentKind kind;
  };
  constexpr DocumentKind pixels{"a picture of pixels", ", not of curves"};
  constexpr DocumentKind page{"a PDF file",
                              ": a drawing program can save it as SVG, of which import-svg makes a boundary"};
  constexpr DocumentKind script{"a PostScript file",
                                ": a drawing program can save it as SVG, of which import-svg makes a boundary"};
  constexpr DocumentKind utf16{"a text in UTF-16", ", while UTF-8 is read"};
  const Magic magics[] = {{"glTF", gltf_file},
                          {"\x89PNG", pixels},
                          {"\xFF\xD8\xFF", pixels},
                          {"GIF8", pixels},
                          {"BM", pixels},
                          {"II*", pixels},
                          {"%PDF", page},
                          {"%!PS", script},
                          {"\xFF\xFE", utf16},
                          {"\xFE\xFF", utf16},
                          {"# vtk DataFile", vtk_file}};
  const auto* const found =
      std::ranges::find_if(magics, [&](const Magic& each) { return head.starts_with(each.bytes); });
  return found == std::end(magics) ? DocumentKind{} : found->kind;
}

DocumentKind recognize(std::string_view bytes) {
  std::string_view head = bytes.substr(0, recognized_by);
  const auto starts = [&head](std::string_view magic) { return head.starts_with(magic); };
  if (const DocumentKind kind = recognize_packed(head); !kind.name.empty()) return kind;
  if (const DocumentKind kind = recognize_magic(head); !kind.name.empty()) return kind;
  if (form_of(head) == DocumentForm::cbor) return recognize_document(head);
  if (starts("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  head.remove_prefix(first);
  if (head.find("$MeshFormat") != std::string_view::npos || starts("$NOD") || starts("$Comments")) return msh_file;
  if (starts("# evolve")) return {"the note that evolve keeps beside its frames", ": give the frames (-o)"};
  if (starts("solid ")) return {"an STL file", of_no_tool};
  if (starts("frame,") || starts("time,") || starts("step,"))
    return {"a table (CSV)", ": give the mesh that it is about"};
  if (head.front() == '<') return recognize_xml(head);
  if (head.front() == '{') return recognize_document(head);
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
  const DocumentKind kind = recognize(bytes);
  if (kind.name.empty()) return {};
  const bool wants_document = wanted != FileKind::svg && wanted != FileKind::msh;
  if ((wanted == FileKind::svg && kind.name == svg_drawing.name) ||
      (wanted == FileKind::msh && kind.name == msh_file.name))
    return {};
  if (kind.is_document && wants_document) return {};  // its reader says more
  if (!kind.format.empty()) return describe_other_format(kind.format);
  std::string text = "this is " + std::string(kind.name) + std::string(kind.advice);
  if (kind.is_document) text += wanted == FileKind::svg ? "; an SVG drawing is wanted" : "; a Gmsh MSH file is wanted";
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

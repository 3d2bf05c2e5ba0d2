// tests/formats/recognize_test.cpp: files of other kinds, and typing errors.
#include "formats/document/recognize.h"

#include <catch2/catch.hpp>

using namespace pliant;

TEST_CASE("a file of another kind is named with the tool that reads it", "[formats]") {
  const auto says = [](std::string_view bytes, FileKind wanted) { return describe_other_kind(bytes, wanted); };
  using Catch::Contains;
  CHECK_THAT(says("<?xml version='1.0'?>\n<!-- x -->\n<svg>", FileKind::mesh), Contains("import-svg"));
  CHECK_THAT(says("<s:svg xmlns:s='...'>", FileKind::boundary), Contains("import-svg"));
  CHECK_THAT(says("\xEF\xBB\xBF<svg>", FileKind::msh), Contains("import-svg"));
  CHECK_THAT(says("$Comments\nx\n$EndComments\n$MeshFormat", FileKind::boundary), Contains("import-msh"));
  CHECK_THAT(says("$NOD\n3\n", FileKind::mesh), Contains("import-msh"));
  CHECK_THAT(says("{\"format\":\"pliant-mesh\"}", FileKind::svg), Contains("a mesh, which all tools but bspline2mesh"));
  CHECK_THAT(says("{\"format\":\"pliant-boundary\"}", FileKind::msh), Contains("bspline2mesh"));
  CHECK_THAT(says("{\"asset\":{\"version\":\"2.0\"}}", FileKind::svg), Contains("JSON") || Contains("glTF"));
  CHECK_THAT(says("glTF\2", FileKind::mesh), Contains("glTF"));
  CHECK_THAT(says("<VTKFile type='UnstructuredGrid'>", FileKind::mesh), Contains("VTK"));
  CHECK_THAT(says("\xFD"
                  "7zXZ",
                  FileKind::mesh),
             Contains("xz -dc"));
  CHECK_THAT(says("{\"tool\":\"refine\",\"frame\":0", FileKind::mesh), Contains("--report"));
  CHECK_THAT(says("{\"step\":1,\"part\":1,\"time\":0.1,\"dt\":0.1,", FileKind::mesh), Contains("log of evolve"));
  CHECK_THAT(says("\xBF\x66"
                  "format\x6Bpliant-mesh",
                  FileKind::svg),
             Contains("this is a mesh"));
  CHECK_THAT(says("\xA1\x61"
                  "a\x01",
                  FileKind::svg),
             Contains("CBOR"));
  CHECK_THAT(says("<svg>", FileKind::mesh), Contains("import-svg makes a boundary of it, bspline2mesh a mesh of that"));
  CHECK_THAT(says("\x89PNG\r\n", FileKind::svg), Contains("pixels"));
  CHECK_THAT(says("\xFF\xFE{", FileKind::mesh), Contains("UTF-16"));
  CHECK_THAT(says("<!DOCTYPE html><html>", FileKind::svg), Contains("HTML"));
}

TEST_CASE("archives and what other programs compressed are named with what unpacks them", "[formats]") {
  using Catch::Contains;
  std::string tar(1024, '\0');  // of the old kind, without the word ustar
  tar.replace(0, 9, "mesh.json");
  tar.replace(100, 7, "0000644");
  tar.replace(148, 8, "        ");
  long sum = 0;
  for (const char c : tar) sum += static_cast<unsigned char>(c);
  std::string digits;
  for (int place = 5; place >= 0; --place) digits += static_cast<char>('0' + (sum >> 3 * place) % 8);
  tar.replace(148, 6, digits);
  tar[154] = '\0';
  for (const FileKind kind : {FileKind::mesh, FileKind::svg, FileKind::msh, FileKind::problem}) {
    const auto says = [kind](std::string_view bytes) { return describe_other_kind(bytes, kind); };
    CHECK_THAT(says(tar), Contains("a tar archive: extract"));
    CHECK_THAT(says("7z\xBC\xAF\x27\x1C rest"), Contains("a 7z archive: extract"));
    CHECK_THAT(says("PK\x03\x04"), Contains("a zip archive: extract"));
    CHECK_THAT(says("BZh91AY"), Contains("bzip2 -dc"));
    CHECK_THAT(says(std::string_view("\x5D\x00\x00\x80\x00", 5)), Contains("lzma compressed: xz -dc"));
    CHECK_THAT(says("\x04\x22\x4D\x18"), Contains("lz4 -dc"));
    CHECK_THAT(says("\x1F\x9D\x90"), Contains("gzip -dc"));
    CHECK_THAT(says("\x1F\x8B\x08"), Contains("compressed twice: decompress it once"));
    CHECK_THAT(says("\x28\xB5\x2F\xFD"), Contains("compressed twice: decompress it once"));
  }
  tar[0] = 'n';
  CHECK(describe_other_kind(tar, FileKind::mesh).empty());
}

TEST_CASE("a faulty file of the right kind is left to its reader", "[formats]") {
  CHECK(describe_other_kind("<svg", FileKind::svg).empty());
  CHECK(describe_other_kind("$MeshFormat\n9 9 9", FileKind::msh).empty());
  for (const FileKind kind : {FileKind::mesh, FileKind::boundary}) {
    CHECK(describe_other_kind("{\"format\": 1", kind).empty());
    CHECK(describe_other_kind("", kind).empty());
    CHECK(describe_other_kind(" \n", kind).empty());
    CHECK(describe_other_kind("not json", kind).empty());
  }
}

TEST_CASE("typing errors are counted, and the nearest word found", "[formats]") {
  CHECK(typing_errors("degree", "degree") == 0);
  CHECK(typing_errors("degre", "degree") == 1);
  CHECK(typing_errors("dergee", "degree") == 1);
  CHECK(typing_errors("", "abc") == 3);
  CHECK(typing_errors("kitten", "sitting") == 3);
  CHECK(typing_errors("abcd", "dcba") == typing_errors("dcba", "abcd"));
  const std::vector<std::string> options{"--max-area", "--min-angle", "--max-turning", "--until"};
  CHECK(nearest_word("--max-aera", options) == "--max-area");
  CHECK(nearest_word("--maxarea", options) == "--max-area");
  CHECK(nearest_word("--untill", options) == "--until");
  CHECK(nearest_word("--colour", options).empty());
  CHECK(nearest_word("x", {}).empty());
}

// tests/formats/document_stream_test.cpp: a stream falls into documents as people and programs write them.
#include "formats/document/document_stream.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace pliant;

namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File file_of(const std::string& text) {
  File file(std::tmpfile());
  std::fwrite(text.data(), 1, text.size(), file.get());
  std::rewind(file.get());
  return file;
}

struct Document {
  std::string text;
  long line;
};

std::vector<Document> documents_of(std::FILE* file) {
  DocumentStream stream(file, "test");
  std::vector<Document> documents;
  std::string_view text;
  while (stream.next(text)) {
    CHECK(stream.frame() == static_cast<long>(documents.size()));
    documents.push_back({std::string(text), stream.first_line()});
  }
  return documents;
}

std::vector<Document> documents_of(const std::string& text) { return documents_of(file_of(text).get()); }

}  // namespace

TEST_CASE("each line of a series is a document, with its line number", "[formats]") {
  const auto found = documents_of("{\"a\":1}\n{\"a\":2}\n\n \t\n{\"a\":3}");
  REQUIRE(found.size() == 3);
  CHECK(found[0].text == "{\"a\":1}");
  CHECK(found[0].line == 1);
  CHECK(found[1].text == "{\"a\":2}");
  CHECK(found[1].line == 2);
  CHECK(found[2].text == "{\"a\":3}");
  CHECK(found[2].line == 5);
}

TEST_CASE("a document may spread over lines, and another may follow", "[formats]") {
  const auto found = documents_of("\n{\n  \"a\": [1,\r\n 2]\n}\n{\"b\":{}}\n");
  REQUIRE(found.size() == 2);
  CHECK(found[0].text == "{\n  \"a\": [1,\r\n 2]\n}");
  CHECK(found[0].line == 2);
  CHECK(found[1].text == "{\"b\":{}}");
  CHECK(found[1].line == 6);
}

TEST_CASE("braces, quotes and backslashes in strings do not end a document", "[formats]") {
  const std::string first = R"({"a}":"}\"}{\\","b":{"c":"\\\""}})";
  const auto found = documents_of(first + "\n{}\n");
  REQUIRE(found.size() == 2);
  CHECK(found[0].text == first);
  CHECK(found[1].text == "{}");
}

TEST_CASE("an empty stream has no documents", "[formats]") {
  CHECK(documents_of("").empty());
  CHECK(documents_of("\n \r\n\t\n").empty());
}

TEST_CASE("what is no object comes as its line, and garbage stays with its document", "[formats]") {
  const auto found = documents_of("nonsense { \n{\"a\":1} x {}\n}\n{\"open\":[\n1");
  REQUIRE(found.size() == 4);
  CHECK(found[0].text == "nonsense { ");
  CHECK(found[1].text == "{\"a\":1} x {}");
  CHECK(found[2].text == "}");
  CHECK(found[3].text == "{\"open\":[\n1");
  CHECK(found[3].line == 4);
}

TEST_CASE("documents come out whole wherever the reading buffer ends", "[formats]") {
  const int extra = GENERATE(range(-70, 8));
  // A long first document puts the second one across the end of the buffer, its string and escapes included.
  const std::string second = "{\"name\":\"a}b\\\\\\\"{c\"}";
  const std::string first = "{\"n\":[" + std::string(static_cast<std::size_t>((1 << 16) - 10 + extra), '1') + "]}";
  const auto found = documents_of(first + "\n" + second + "\n" + first + "\n" + second);
  REQUIRE(found.size() == 4);
  CHECK(found[0].text == first);
  CHECK(found[1].text == second);
  CHECK(found[2].text == first);
  CHECK(found[3].text == second);
}

TEST_CASE("streams in memory have documents too", "[formats]") {
  std::string text = "{\"a\":1}\n{\"a\":2}\n";
  const File file(fmemopen(text.data(), text.size(), "r"));
  CHECK(documents_of(file.get()).size() == 2);
}

TEST_CASE("a frame is there before the next one is made", "[formats]") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const File in(fdopen(ends[0], "r"));
  DocumentStream stream(in.get(), "pipe");
  std::string_view document;
  for (int frame = 0; frame < 3; ++frame) {
    const std::string text = "{\"frame\":" + std::to_string(frame) + "}\n";
    REQUIRE(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    REQUIRE(stream.next(document));  // would wait for ever if it read ahead
    CHECK(document == text.substr(0, text.size() - 1));
  }
  close(ends[1]);
  CHECK_FALSE(stream.next(document));
}

TEST_CASE("documents come whole through a pipe that is written in small pieces", "[formats]") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const std::string text = "{\"a\":\"x}\\\"y\",\"b\":[1,2,{\"c\":3}]}\n{\n}\n";
  std::thread writer([&] {
    for (const char c : text)
      if (write(ends[1], &c, 1) != 1) break;
    close(ends[1]);
  });
  const File in(fdopen(ends[0], "r"));
  const auto found = documents_of(in.get());
  writer.join();
  REQUIRE(found.size() == 2);
  CHECK(found[0].text + "\n" + found[1].text + "\n" == text);
}

TEST_CASE("a stream that cannot be read says so", "[formats]") {
  const File directory(std::fopen("/", "r"));
  REQUIRE(directory != nullptr);
  DocumentStream stream(directory.get(), "/");
  std::string_view document;
  CHECK_THROWS_AS(stream.next(document), std::system_error);
}

TEST_CASE("a document that does not end within its memory is refused with its place", "[formats]") {
  constexpr std::size_t most = 1 << 21;
  const auto fault_of = [](const std::string& text) {
    const File file = file_of(text);
    DocumentStream stream(file.get(), "name", most);
    std::string_view document;
    try {
      if (const std::string_view bytes = stream.all_if("$"); !bytes.empty()) return std::string(bytes);
      while (stream.next(document)) continue;
    } catch (const DocumentTooLong& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string much(2 * most, ' ');
  using Catch::StartsWith;
  CHECK_THAT(fault_of("{}\n\n{\"a\":[" + much),
             StartsWith("name:3: frame 1: the document that begins here has not ended after 2 MB, and "));
  CHECK_THAT(fault_of("{}\n\xBF\x7A\x7F\xFF\xFF\xFF" + much), StartsWith("name: frame 1: the document that begins "));
  CHECK(fault_of("{\"a\":\"" + much.substr(0, most - 100) + "\"}") == "none");
}

TEST_CASE("what is no document takes no memory, nor does white space", "[formats]") {
  constexpr std::size_t most = 1 << 17;
  for (const char c : {'\0', 'x', ' ', '\n'}) {
    CAPTURE(c);
    const std::string much(1 << 20, c);
    const File file = file_of("{}" + much + "\n{\"b\":1}\n");
    DocumentStream stream(file.get(), "name", most);
    std::string_view document;
    REQUIRE(stream.next(document));
    CHECK(document.substr(0, 2) == "{}");
    bool has_found = false;
    while (stream.next(document)) {
      CHECK(document.size() <= most);
      has_found = document == "{\"b\":1}";
    }
    CHECK(has_found);
    CHECK(stream.first_line() == (c == '\n' ? (1 << 20) + 2 : 2));
  }
}

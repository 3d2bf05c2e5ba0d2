// tests/formats/problem/problem_texts.h: problem documents as texts, and what is said of faulty ones.
#pragma once
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <string>

#include "formats/document/mesh_document.h"
#include "formats/document/read_json.h"
#include "formats/problem/problem_json.h"

namespace pliant::testing {

inline std::string page() {
  std::ifstream in(std::string(PLIANT_FORMAT_PAGES) + "/problem.md");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A document that the page shows, counted from 0.
inline std::string example(int which) {
  const std::string text = page(), fence = "```json\n";
  std::size_t start = text.find(fence) + fence.size();
  for (; which > 0; --which) start = text.find(fence, start) + fence.size();
  return text.substr(start, text.find("\n```", start) - start);
}

inline std::string written(const ProblemDocument& problem) {
  std::string text;
  write_problem(problem, text);
  return text;
}

/// A document that has this member.
inline std::string with_section(const std::string& name, const std::string& section) {
  return R"({"format": "pliant-problem", "version": 1, ")" + name + "\": " + section + "}";
}

struct Refusal {
  std::string pointer = "accepted", text;
};

inline Refusal refusal_of(const std::string& document) {
  try {
    read_problem(document);
  } catch (const DocumentError& e) {
    CHECK(e.line() >= 1);
    CHECK(e.column() >= 1);
    return {e.pointer(), e.what()};
  }
  return {};
}

inline void check_refused(const std::string& document, const std::string& pointer, const std::string& text) {
  CAPTURE(document);
  const Refusal refusal = refusal_of(document);
  CHECK(refusal.pointer == pointer);
  CHECK_THAT(refusal.text, Catch::Matchers::Contains(text));
}

}  // namespace pliant::testing

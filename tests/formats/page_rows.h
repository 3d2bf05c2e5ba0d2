// tests/formats/page_rows.h: rows of the tables of the formats' pages, and the cases that show what a row says.
#pragma once
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>
#include <vector>

/// The row is named by its first cell. The text `expected` must be found in what comes of reading `input`.
struct Case {
  std::string row, input, expected;
};

/// The first cells of all rows of the page's tables, without the heads.
inline std::set<std::string> rows_of(const std::string& page) {
  std::ifstream in(std::string(PLIANT_FORMAT_PAGES) + "/" + page);
  REQUIRE(in);
  std::set<std::string> rows;
  bool is_body = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("|")) is_body = false;
    if (is_body) rows.insert(line.substr(2, line.find(" |", 2) - 2));
    if (line.starts_with("|--")) is_body = true;
  }
  return rows;
}

inline std::set<std::string> rows_with_a_case(const std::vector<Case>& cases) {
  std::set<std::string> rows;
  for (const Case& c : cases) rows.insert(c.row);
  return rows;
}

inline std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value == 0 ? 0 : value);
  return digits;
}

// tests/tools/table_file_test.cpp: tables grow by whole records, whoever appends them.
#include "measure/table_file.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "run/exit_status.h"

using namespace pliant;

namespace {

class TablePath {
 public:
  TablePath() : path_(std::filesystem::temp_directory_path() / ("pliant-table-" + std::to_string(getpid()))) {}
  ~TablePath() { std::filesystem::remove(path_); }
  TablePath(const TablePath&) = delete;
  TablePath& operator=(const TablePath&) = delete;
  std::string name() const { return path_.string(); }
  std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
  /// As a process of its own would.
  void append(double time, const std::string& rows) const { TableFile("--csv", name()).append("time,a\n", time, rows); }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a table gets its header once, then record after record", "[tools]") {
  const TablePath table;
  table.append(0, "0,1\n");
  table.append(0.5, "0.5,2\n0.5,3\n");
  table.append(0.5, "0.5,4\n");
  CHECK(table.text() == "time,a\n0,1\n0.5,2\n0.5,3\n0.5,4\n");
  table.put("");
  table.append(1, "1,1\n");
  CHECK(table.text() == "time,a\n1,1\n");
}

TEST_CASE("rows from a later time go, and with them those of the time itself", "[tools]") {
  const TablePath table;
  const std::string rows = "0,1\n1,2\n1,3\n2,4\n1e1,5\n";
  table.put("time,a\n" + rows);
  table.append(1, "1,9\n");
  CHECK(table.text() == "time,a\n0,1\n1,9\n");
  table.append(-1, "-1,8\n");
  CHECK(table.text() == "time,a\n-1,8\n");
  table.put("time,a\n0,1\n2,4");  // half a row
  table.append(3, "3,5\n");
  CHECK(table.text() == "time,a\n0,1\n3,5\n");
  table.put("time,a\n0");
  table.append(3, "3,5\n");
  CHECK(table.text() == "time,a\n3,5\n");
}

TEST_CASE("rows that a table ends with are not repeated, and only whole rows count", "[tools]") {
  const TablePath table;
  table.put("time,a\n-5,1\n");
  table.append(5, "5,1\n");
  CHECK(table.text() == "time,a\n-5,1\n5,1\n");
  table.append(5, "5,1\n");
  CHECK(table.text() == "time,a\n-5,1\n5,1\n");
  table.put("time,a\n5,1\n5,2\n");
  table.append(5, "5,1\n5,2\n");
  CHECK(table.text() == "time,a\n5,1\n5,2\n");
}

TEST_CASE("going back passes over more rows than one block holds", "[tools]") {
  const TablePath table;
  std::string text = "time,a\n";
  for (int k = 0; k < 30000; ++k) text += std::to_string(k) + "," + std::string(10, '7') + "\n";
  const std::string kept = text.substr(0, text.find("\n3,") + 1);
  table.put(text);
  table.append(3, "3,1\n");
  CHECK(table.text() == kept + "3,1\n");
  table.put("time,a\n1," + std::string(200000, '7') + "\n2," + std::string(200000, '8') + "\n");
  table.append(2, "2,1\n");
  table.append(1.5, "1.5,1\n");
  CHECK(table.text() == "time,a\n1," + std::string(200000, '7') + "\n1.5,1\n");
}

TEST_CASE("a file that is no table of these columns stays as it is", "[tools]") {
  const TablePath table;
  for (const std::string text : {"time,b\n0,1\n", "time,a", "{}", "time,ab\n0,1\n"}) {
    CAPTURE(text);
    table.put(text);
    CHECK_THROWS_AS(table.append(1, "1,1\n"), UsageError);
    CHECK(table.text() == text);
  }
}

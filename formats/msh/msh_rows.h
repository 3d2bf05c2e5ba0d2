// formats/msh/msh_rows.h: rows of numbers in an MSH file.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include "formats/document/write_json.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// Writes numbers as text, or as bytes in this machine's order, which the header tells.
class MshRows {
 public:
  MshRows(std::string& out, bool binary) : out_(out), binary_(binary) {}
  template <class T>
  MshRows& put(T value) {
    if (binary_) {
      const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
      out_.append(bytes.data(), bytes.size());
      return *this;
    }
    if (!starts_row_) out_ += ' ';
    starts_row_ = false;
    if constexpr (std::is_floating_point_v<T>)
      append_number(out_, value);
    else
      append_integer(out_, static_cast<std::int64_t>(value));
    return *this;
  }
  MshRows& put(const Point& p) { return put(p.x).put(p.y).put(0.0); }
  MshRows& size(std::size_t value) { return put(static_cast<std::uint64_t>(value)); }
  void end_row() {
    if (!binary_) out_ += '\n';
    starts_row_ = true;
  }
  void line(const std::string& text) { out_ += text + "\n"; }
  /// Starts a new line behind binary numbers, where the section's end must stand on a line of its own.
  void end_section(const char* name) { line((binary_ ? "\n$End" : "$End") + std::string(name)); }

 private:
  std::string& out_;
  bool binary_;
  bool starts_row_ = true;
};

}  // namespace pliant

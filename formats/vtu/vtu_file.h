// formats/vtu/vtu_file.h: the frame of a VTK XML file: tags before, arrays behind, each where its tag says.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/vtu/vtu_array.h"

namespace pliant {

/// Collects the tags and the compressed arrays of a file.
class VtuFile {
 public:
  BlockCompressor& compressor() { return compressor_; }
  /// Appends tags.
  void tag(std::string_view text) { (head_ += text) += '\n'; }
  /// Appends the tag of an array (`type`: Float64, Int32 ...), and keeps its bytes. `name` may have any characters.
  void array(std::string_view type, std::string_view name, int components, VtuArray&& numbers);
  /// The same for an array of FieldData, which has to say how many tuples it has.
  void field_array(std::string_view type, std::string_view name, std::size_t tuples, VtuArray&& numbers);

  /// Calls `write` with the file, part by part.
  void write(const std::function<void(std::string_view)>& write) const;

 private:
  void place(std::vector<std::string> parts);

  BlockCompressor compressor_;
  std::string head_;
  std::vector<std::string> parts_;
  std::size_t size_ = 0;  // of all parts, in bytes
};

/// The names in a form that a reader of XML gets back, apart from control characters, which become U+FFFD. Equal names
/// get a number, " (2)" and so on, and an empty one becomes "field".
std::vector<std::string> distinct_names(const std::vector<std::string>& names);

}  // namespace pliant

// formats/vtu/vtu_file.cpp: tags and appended arrays of a VTK XML file.
#include "formats/vtu/vtu_file.h"

#include <set>
#include <utility>

#include "formats/vtu/xml_text.h"

namespace pliant {

void VtuFile::place(std::vector<std::string> parts) {
  head_ += " format=\"appended\" offset=\"" + std::to_string(size_) + "\"/>\n";
  for (std::string& part : parts) {
    size_ += part.size();
    parts_.push_back(std::move(part));
  }
}

void VtuFile::array(std::string_view type, std::string_view name, int components, VtuArray&& numbers) {
  head_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + escape_attribute(name) + "\"";
  if (components != 1) head_ += " NumberOfComponents=\"" + std::to_string(components) + "\"";
  place(numbers.finish());
}

void VtuFile::field_array(std::string_view type, std::string_view name, std::size_t tuples, VtuArray&& numbers) {
  const std::string tag = type == "String" ? "Array" : "DataArray";
  head_ += "<" + tag + " type=\"" + std::string(type) + "\" Name=\"" + escape_attribute(name) + "\" NumberOfTuples=\"" +
           std::to_string(tuples) + "\"";
  place(numbers.finish());
}

void VtuFile::write(const std::function<void(std::string_view)>& write) const {
  write(R"(<?xml version="1.0" encoding="UTF-8"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">
)");
  write(head_);
  write("<AppendedData encoding=\"raw\">\n_");
  for (const std::string& part : parts_) write(part);
  write("\n</AppendedData>\n</VTKFile>\n");
}

std::vector<std::string> distinct_names(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const std::string base = name.empty() ? "field" : name;
    std::string candidate = base;
    // Names that differ in control characters alone look the same once these are replaced.
    for (int k = 2; !taken.insert(escape_attribute(candidate)).second; ++k)
      candidate = base + " (" + std::to_string(k) + ")";
    result.push_back(candidate);
  }
  return result;
}

}  // namespace pliant

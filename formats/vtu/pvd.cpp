// formats/vtu/pvd.cpp: the list of the files of a series.
#include <array>
#include <charconv>

#include "formats/vtu/vtu_writer.h"
#include "formats/vtu/xml_text.h"

namespace pliant {

std::string write_pvd(const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const PvdEntry& entry : entries) {
    std::array<char, 32> time;
    const auto end = std::to_chars(time.data(), time.data() + time.size(), entry.time).ptr;
    text += "<DataSet timestep=\"" + std::string(time.data(), end) + "\" part=\"0\" file=\"" +
            escape_attribute(entry.file) + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace pliant

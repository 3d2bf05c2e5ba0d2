// tests/support/msh_texts.h: meshes as the bytes of MSH files, in all kinds that are written.
#pragma once
#include <string>
#include <vector>

#include "formats/msh/msh.h"
#include "formats/msh/msh_writer.h"

namespace pliant::samples {

inline const std::vector<MshWriteOptions> written_kinds = {{MshWriteOptions::Version::v4_1, false},
                                                           {MshWriteOptions::Version::v4_1, true},
                                                           {MshWriteOptions::Version::v2_2, false},
                                                           {MshWriteOptions::Version::v2_2, true}};

inline std::string msh_file(const MeshData& mesh, const MshWriteOptions& options) {
  std::string bytes;
  write_msh(mesh, options, bytes);
  return bytes;
}

/// Why an MSH file is refused: "PLACE: TEXT", or the text alone if it has no place; "none" if it is read.
inline std::string complaint(const std::string& file) {
  try {
    read_msh(file);
  } catch (const InputError& e) {
    return e.pointer().empty() ? e.what() : e.pointer() + ": " + e.what();
  }
  return "none";
}

}  // namespace pliant::samples

// tests/support/msh_texts.h: meshes as the bytes of MSH files, in all kinds that are written.
#pragma once
#include <string>
#include <vector>

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

}  // namespace pliant::samples

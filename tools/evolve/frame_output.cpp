// tools/evolve/frame_output.cpp: what series and numbered files have in common.
#include "evolve/frame_output.h"

#include <filesystem>
#include <system_error>

#include "run/documents.h"
#include "run/exit_status.h"

namespace pliant {

bool begins_as_frame(std::string_view text) {
  return text.starts_with("{\"format\":\"pliant-mesh\",") || text.starts_with("\xBF\x66\x66ormat\x6Bpliant-mesh");
}

void refuse_frame(const EarlierFrames& frames, long k, const std::string& fault) {
  throw Placed(status::bad_input, frames.name(k) + ": " + fault +
                                      "; evolve wrote no such frame, so that --resume cannot " +
                                      "go on: " + frames.remedy(k));
}

void make_folders(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::system_error(error, path);
}

}  // namespace pliant

// tools/options/frame_option.cpp: which mesh of a series a tool takes that writes only one.
#include "options/frame_option.h"

#include <CLI/CLI.hpp>
#include <deque>

#include "run/documents.h"
#include "run/exit_status.h"
#include "run/require_mesh.h"

namespace pliant {

void FrameOption::add(CLI::App& app) {
  app.add_option("--frame", wanted_, "which mesh of a series, from 0; -1 is the last one")
      ->type_name("N")
      ->capture_default_str();
}

MeshData FrameOption::read(const ToolOptions& options) const {
  // A negative number counts from the end, which is known only there: the last -N meshes are kept.
  std::deque<MeshData> kept;
  long frames = 0;
  for_each_mesh(options, [&](MeshData&& mesh, const Frame& frame) {
    ++frames;
    if (wanted_ >= 0 && frame.index != wanted_) return;
    require_mesh(mesh, true);
    kept.push_back(std::move(mesh));
    if (wanted_ < 0 && static_cast<long>(kept.size()) > -wanted_) kept.pop_front();
  });
  if (kept.empty() || (wanted_ < 0 && static_cast<long>(kept.size()) < -wanted_))
    throw UsageError("--frame " + std::to_string(wanted_) + ": the series has " + std::to_string(frames) +
                     (frames == 1 ? " mesh" : " meshes"));
  return std::move(kept.front());
}

}  // namespace pliant

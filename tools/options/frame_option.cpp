// tools/options/frame_option.cpp: which mesh of a series a tool takes that writes only one.
#include "options/frame_option.h"

#include <CLI/CLI.hpp>
#include <deque>

#include "options/numbers.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/require_mesh.h"

namespace pliant {
namespace {
/// No series has more; it keeps the number and its negative within the range of every integer.
constexpr long most_frames = 1'000'000'000;
}  // namespace

void FrameOption::add(CLI::App& app) {
  app.add_option("--frame", wanted_, "which mesh of a series, from 0; -1 is the last one")
      ->type_name("N")
      ->check([](const std::string& text) { return fault_of_whole_number(text, -most_frames, most_frames); })
      ->capture_default_str();
}

MeshData FrameOption::read(const ToolOptions& options) const {
  const long wanted = parse_whole_number("--frame", wanted_);
  // A negative number counts from the end, which is known only there: the last -N meshes are kept.
  std::deque<MeshData> kept;
  long frames = 0;
  find_mesh(options, [&](MeshData&& mesh, const Frame& frame) {
    ++frames;
    if (wanted >= 0 && frame.index != wanted) return false;
    require_mesh(mesh, true);
    kept.push_back(std::move(mesh));
    if (wanted < 0 && static_cast<long>(kept.size()) > -wanted) kept.pop_front();
    return wanted >= 0;
  });
  if (kept.empty() || (wanted < 0 && static_cast<long>(kept.size()) < -wanted))
    throw UsageError("--frame " + wanted_ + ": the series has " + std::to_string(frames) +
                     (frames == 1 ? " mesh" : " meshes"));
  return std::move(kept.front());
}

}  // namespace pliant

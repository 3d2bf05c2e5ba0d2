// tools/evolve/start.cpp: reads the input, or the frames and the step of an earlier run.
#include "evolve/start.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include "formats/document/mesh_json.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/require_mesh.h"

namespace pliant {
namespace {

void prepare(MeshData& data) {
  normalize_unit(data);
  in_unit(data.boundary.unit, [&data] { require_mesh(data, false); });
}

MeshData read_input(const EvolveOptions& options) {
  std::optional<MeshData> mesh;
  for_each_mesh(options.tool, [&mesh](MeshData&& data, const Frame&) {
    if (mesh)
      throw InputError("", "evolve begins with one mesh, and the input has several; `tail -n 1` takes the last");
    prepare(data);
    mesh = std::move(data);
  });
  return std::move(*mesh);
}

/// A frame that an earlier run has written.
MeshData read_frame(const std::string& text, const std::string& name) {
  try {
    return read_mesh(text);
  } catch (const InputError& error) {
    throw Placed(status::bad_input, name + ": " + (error.pointer().empty() ? "" : error.pointer() + ": ") +
                                        error.what() + "; evolve wrote no such frame, so that --resume cannot go on");
  }
}

std::string step_file(const EvolveOptions& options) {
  return options.is_numbered() ? beside_numbered(options.frames, "step") : options.tool.output + ".step";
}

/// Standard output and devices keep nothing that could be continued.
bool has_step_file(const EvolveOptions& options) {
  if (options.is_numbered()) return true;
  std::error_code error;
  return options.tool.output != "-" && (!std::filesystem::exists(options.tool.output, error) ||
                                        std::filesystem::is_regular_file(options.tool.output, error));
}

std::string describe(const EvolveOptions& options, const Step& step) {
  return "# evolve" + options.frame_options() + "\n" + text_of(step.commands) + "\n";
}

void compare_step(const EvolveOptions& options, const Step& step) {
  const std::string path = step_file(options);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    say(options.tool,
        "there is no " + path + ", which tells the step that made the frames; it is taken to be this one");
    return;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.find('\n', text.find('\n') + 1) == std::string::npos)
    throw UsageError("--resume: " + path + " is cut off; remove it to go on with this step");
  const std::string now = describe(options, step);
  if (text == now) return;
  const auto second = [](const std::string& lines) { return lines.substr(lines.find('\n') + 1); };
  if (second(text) != second(now))
    throw UsageError("--resume: the step is another than that of the frames, which " + path +
                     " tells: " + second(text).substr(0, second(text).find('\n')));
  throw UsageError("--resume: the options that choose frames differ from those before, which " + path +
                   " tells: " + text.substr(2, text.find('\n') - 2));
}

}  // namespace

Start find_start(const EvolveOptions& options, const Step& step) {
  Start start;
  if (options.resumes) {
    std::optional<ResumedOutput> resumed =
        options.is_numbered() ? resume_numbered(options.frames) : resume_series(options.tool.output);
    if (resumed) {
      compare_step(options, step);
      start.first_time = read_frame(resumed->frames.first, resumed->frames.last_name).time;
      start.mesh = read_frame(resumed->frames.last, resumed->frames.last_name);
      prepare(start.mesh);
      start.text = std::move(resumed->frames.last);
      start.output = std::move(resumed->output);
      start.is_resumed = true;
      return start;
    }
  }
  start.output = options.is_numbered() ? create_numbered(options.frames) : create_series(options.tool.output);
  start.mesh = read_input(options);
  start.first_time = start.mesh.time;
  return start;
}

void forget_step(const EvolveOptions& options) {
  std::error_code error;  // where it cannot be removed, the first frame cannot be written either
  if (has_step_file(options)) std::filesystem::remove(step_file(options), error);
}

void note_step(const EvolveOptions& options, const Step& step) {
  if (!has_step_file(options)) return;
  const std::string path = step_file(options);
  if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty()) make_folders(folder.string());
  OutputFile file(path);
  file.write(describe(options, step));
  file.commit();
}

}  // namespace pliant

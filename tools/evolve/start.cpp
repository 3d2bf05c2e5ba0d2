// tools/evolve/start.cpp: reads the input, or the frames of an earlier run, as far as this run has them too.
#include "evolve/start.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "evolve/step_count.h"
#include "evolve/step_note.h"
#include "formats/document/mesh_document.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/history.h"
#include "run/in_unit.h"
#include "run/require_mesh.h"

namespace pliant {

std::string text_of(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.12g", value);
  return digits;
}

namespace {

void prepare(MeshData& data) {
  normalize_unit(data);
  in_unit(data.boundary.unit, [&data] { require_mesh(data, false); });
}

MeshData read_input(const EvolveOptions& options, DocumentForm& form) {
  std::optional<MeshData> mesh;
  for_each_mesh(options.tool, [&](MeshData&& data, const Frame& frame) {
    if (mesh)
      throw InputError("", "evolve begins with one mesh, and the input has several; of JSON that is not " +
                               std::string("compressed `tail -n 1` takes the last"));
    prepare(data);
    record(options.tool, data.extra);
    form = frame.form;
    mesh = std::move(data);
  });
  return std::move(*mesh);
}

/// Finds the last of the earlier frames that this run has too.
class Resumption {
 public:
  Resumption(const EvolveOptions& options, const Step& step, std::unique_ptr<EarlierFrames> earlier)
      : options_(options), step_(step) {
    start_.earlier = std::move(earlier);
  }

  Start find() {
    const std::optional<EarlierRun> noted = read_note(options_, step_);
    start_.is_resumed = true;
    start_.kept = start_.earlier->count();
    start_.first_time = read(0).time;
    load(start_.kept - 1);
    if (options_.tool.output_form(start_.form) != start_.form)
      throw UsageError("--to " + options_.tool.to + ": the frames that --resume goes on from have the other form");
    if (!noted)
      say(options_.tool, "there is no " + step_file(options_) +
                             ", which tells the step that made the frames; it is taken to be this one");
    go_back(noted ? schedule_of(noted->schedule) : any_end());
    start_.is_steady = noted && noted->steady_at == start_.mesh.time && options_.steady >= noted->steady;
    try {
      prepare(start_.mesh);
    } catch (const BadMesh& error) {
      const Fault& fault = error.faults().front();
      refuse_frame(*start_.earlier, start_.kept - 1, fault.place + ": " + fault.text);
    } catch (const InputError& error) {
      refuse_frame(*start_.earlier, start_.kept - 1, error.what());
    }
    return std::move(start_);
  }

 private:
  MeshData read(long k) {
    start_.text = start_.earlier->read(k);
    start_.form = form_of(start_.text);
    try {
      return read_mesh(start_.text);
    } catch (const InputError& error) {
      refuse_frame(*start_.earlier, k, (error.pointer().empty() ? "" : error.pointer() + ": ") + error.what());
    }
  }
  void load(long k) { start_.mesh = read(k); }

  Schedule schedule_of(ScheduleOptions options) const {
    options.dt = step_.mover().time_step();
    return {start_.first_time, std::move(options)};
  }
  /// For a run that has left no note: the last frame may be at an end to which a step was shortened.
  Schedule any_end() const {
    ScheduleOptions options = options_.schedule;
    options.until = start_.mesh.time;
    return schedule_of(std::move(options));
  }

  /// The last frame may be none of this run, as at the end of a run that shortened its last step for that. All frames
  /// before it are chosen by the options, and must be those of this run.
  void go_back(const Schedule& earlier) {
    const Schedule schedule = schedule_of(options_.schedule);
    start_.is_past_end = schedule.is_past_end(start_.mesh.time, noted_steps(start_.mesh));
    if (start_.is_past_end) return;
    const auto has_state = [&] { return schedule.agrees(earlier, start_.mesh.time, noted_steps(start_.mesh)); };
    if (has_state()) return;
    const double last = start_.mesh.time;
    const bool is_chosen = std::ranges::binary_search(earlier.options().at, last);
    if (start_.kept == 1 || (is_chosen && !schedule.has_same_frames(earlier, last))) refuse_other_frames(options_);
    --start_.kept;
    load(start_.kept - 1);
    if (!has_state()) refuse_other_frames(options_);
    say(options_.tool, "goes on from the frame at time " + text_of(start_.mesh.time) + ": a run with these options " +
                           "does not come to the last one, at time " + text_of(last) + ", where the one before ended");
  }

  const EvolveOptions& options_;
  const Step& step_;
  Start start_;
};

}  // namespace

Start find_start(const EvolveOptions& options, const Step& step) {
  if (options.resumes) {
    std::unique_ptr<EarlierFrames> earlier =
        options.is_numbered() ? find_numbered(options.frames) : find_series(options.tool.output);
    if (earlier) return Resumption(options, step, std::move(earlier)).find();
  }
  Start start;
  start.mesh = read_input(options, start.form);
  start.first_time = start.mesh.time;
  return start;
}

}  // namespace pliant

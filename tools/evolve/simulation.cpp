// tools/evolve/simulation.cpp: one command of evolve: reads, runs the loop, writes frames and logs.
#include "evolve/simulation.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>

#include "evolve/interrupt.h"
#include "evolve/print_pipe.h"
#include "evolve/start.h"
#include "evolve/step.h"
#include "evolve/step_count.h"
#include "evolve/step_logs.h"
#include "evolve/step_note.h"
#include "formats/document/mesh_document.h"
#include "pliant/evolve/courant.h"
#include "pliant/evolve/evolution.h"
#include "pliant/evolve/steadiness.h"
#include "pliant/mesh/documents/document_unit.h"
#include "pliant/quality/least_quality.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/progress_line.h"
#include "run/same_file.h"

namespace pliant {
namespace {

class Simulation {
 public:
  Simulation(const EvolveOptions& options, Step step)
      : options_(options), step_(std::move(step)), logs_(options.log, options.history), line_(options.tool) {
    context_.say = [this](const std::string& warning) { say(options_.tool, warning); };
    context_.wants_details = logs_.is_wanted() || options.tool.verbose;
  }

  int run() {
    begin();
    if (start_.is_past_end) {
      say(options_.tool, "the last frame, at time " + text_of(mesh_->time) + " after " +
                             std::to_string(evolution_->steps_done()) +
                             " steps, lies beyond the end that is asked for: nothing is done");
      return status::done;
    }
    if (start_.is_steady) return status::done;
    while (!evolution_->is_done() && !is_steady_) {
      advance();
      if (interrupted_by() != 0) break;
    }
    write_last();
    logs_.finish();
    if (interrupted_by() == 0 || evolution_->is_done()) return status::done;
    say_failure(options_.tool,
                "stopped at time " + text_of(mesh_->time) + " by a signal" +
                    (options_.tool.output == "-" && !options_.is_numbered() ? "; the last frame is that state"
                                                                            : "; --resume goes on from there"));
    constexpr int killed = 128;  // the exit status of a shell for what a signal has ended
    return killed + interrupted_by();
  }

 private:
  void begin() {
    line_.stage("read");
    start_ = find_start(options_, step_);
    catch_interrupts();
    const long steps = start_.is_resumed ? noted_steps(start_.mesh) : 0;
    mesh_.emplace(std::move(start_.mesh));
    evolution_.emplace(make_evolution(*mesh_, steps));
    if (options_.courant > 0) find_velocity(*mesh_, "--cfl");
    if (options_.steady > 0) find_velocity(*mesh_, "--until-steady");
    begun_at_ = mesh_->time;
    if (start_.is_resumed)
      go_on();
    else
      begin_anew();
  }

  void begin_anew() {
    if (evolution_->schedule().is_past_end(mesh_->time, 0))
      say(options_.tool, "the mesh is at time " + text_of(mesh_->time) + ", later than --until " +
                             text_of(*options_.schedule.until) + ": no step is made, and it is the only frame");
    const std::vector<double>& at = evolution_->schedule().options().at;
    if (!at.empty() && at.front() < mesh_->time)
      say(options_.tool, "--at " + text_of(at.front()) + " lies before the first frame, at time " +
                             text_of(mesh_->time) + ", and gives none");
    output_ = options_.is_numbered() ? create_numbered(options_.frames) : create_series(options_.tool.output);
    forget_step(options_);
    logs_.create();
    write_frame();
    note_step(options_, step_);
  }

  void go_on() {
    text_ = std::move(start_.text);
    written_time_ = mesh_->time;
    if (start_.is_past_end || start_.is_steady) return;
    for (const std::string& path : logs_.find_kept(mesh_->time, start_.first_time))
      say(options_.tool, path + " ends before time " + text_of(mesh_->time) + ": the steps between are missing in it");
    output_ = start_.earlier->go_on(start_.kept);
    if (!evolution_->is_frame() && !evolution_->is_done()) output_->replace_last();
    logs_.reopen();
    // Only now: a frame that these options do not lead to is gone.
    note_step(options_, step_);
  }

  Evolution make_evolution(Mesh& mesh, long steps) {
    EvolutionOptions options;
    options.schedule = options_.schedule;
    options.schedule.dt = step_.mover().time_step();
    if (options_.courant > 0)
      options.longest_step = [this](const Mesh& now) {
        return options_.courant * crossing_time(now, find_velocity(now, "--cfl"));
      };
    return {mesh, start_.first_time, passes_of(step_, context_, running_), std::move(options), steps};
  }

  /// The velocity that the mesh carries.
  int find_velocity(const Mesh& mesh, const std::string& option) const {
    if (const int field = step_.mover().velocity_field(mesh); field != none) return field;
    const auto named = std::ranges::find(mesh.fields(), "velocity", &Field::name);
    if (named == mesh.fields().end() || named->components != 2 || named->by_face)
      throw UsageError(option +
                       " needs a velocity that the mesh carries: --velocity-field in the step, or a continuous " +
                       "field \"velocity\" of two components; navierstokes --steps 0 makes one");
    return static_cast<int>(named - mesh.fields().begin());
  }

  void advance() {
    std::optional<Steadiness> before;
    if (options_.steady > 0) before.emplace(*mesh_, find_velocity(*mesh_, "--until-steady"));
    StepRecord record;
    try {
      record = evolution_->advance();
    } catch (const StepBlocked& blocked) {
      fail(blocked.what(), true);
    } catch (const NoResult& error) {
      fail(place() + error.what(), running_ == 0 && step_.stages.front()->keeps_refused_mesh());
    } catch (const InputError& error) {
      throw Placed(status::bad_input, options_.tool.input + ": " + error.pointer() + ": " + place() + error.what());
    } catch (const std::bad_alloc&) {
      fail(place() + std::string(out_of_memory), false);
    } catch (const std::length_error&) {
      fail(place() + std::string(out_of_memory), false);
    }
    ++runs_since_frame_;
    tell(record);
    if (before) is_steady_ = before->rate(*mesh_, find_velocity(*mesh_, "--until-steady")) <= options_.steady;
    // Noted before the frame is there: a note without its frame does no harm, a frame without it would be gone on from.
    if (is_steady_) note_step(options_, step_, mesh_->time);
    if (evolution_->is_frame()) write_frame();
  }

  std::string place() const {
    return "at time " + text_of(mesh_->time) + ", in step " + std::to_string(evolution_->steps_done() + 1) + ": ";
  }

  /// Writes the last valid state, which the mesh is if it `is_kept`, and ends.
  [[noreturn]] void fail(const std::string& text, bool is_kept) {
    if (!is_kept) replay();
    write_last();
    logs_.finish();
    throw NoResult(text + "; the output ends with the last valid state, at time " + text_of(written_time_));
  }

  /// Where a pass has left the mesh halfway: runs the steps since the last frame again, but for the last one.
  void replay() {
    MeshData data = read_mesh(text_);
    const long steps = noted_steps(data);
    normalize_unit(data);
    evolution_.reset();
    mesh_.emplace(std::move(data));
    evolution_.emplace(make_evolution(*mesh_, steps));
    context_.say = [](const std::string&) {};
    for (long k = 0; k < runs_since_frame_; ++k) evolution_->advance();
  }

  void write_last() {
    if (written_time_ != mesh_->time) write_frame();
  }

  void write_frame() {
    MeshData data = mesh_->to_data();
    if (!options_.schedule.even_steps) note_steps(data, evolution_->steps_done());
    restore_unit(data);
    text_.clear();
    write_mesh(data, text_, options_.tool.output_form(start_.form));
    output_->write(text_);
    written_time_ = mesh_->time;
    runs_since_frame_ = 0;
  }

  void tell(const StepRecord& record) {
    ++runs_;
    if (logs_.is_wanted() || options_.tool.verbose) {
      StepLine line = line_of(record);
      logs_.add(line);
      if (options_.tool.verbose) print(line);
    }
    show_progress();
  }

  StepLine line_of(const StepRecord& record) const {
    StepLine line{record.step,
                  record.part,
                  record.time,
                  record.dt,
                  mesh_->triangle_count(),
                  least_quality_of_mesh(*mesh_).scaled_jacobian,
                  least_logical_angle(*mesh_),
                  {}};
    for (std::size_t k = 0; k < record.work.size(); ++k)
      line.stages.push_back({step_.stages[k]->name(), record.work[k].report, record.work[k].seconds});
    return line;
  }

  void print(const StepLine& line) const {
    std::string text = "step " + std::to_string(line.step) +
                       (line.part > 1 ? " (part " + std::to_string(line.part) + ")" : "") + ", time " +
                       text_of(line.time) + ": dt " + text_of(line.dt) + ", " + std::to_string(line.triangles) +
                       " triangles, least scaled Jacobian " + text_of(line.min_scaled_jacobian) + ", logical angle " +
                       text_of(line.min_logical_angle);
    for (const StageWork& work : line.stages) {
      char seconds[40];
      std::snprintf(seconds, sizeof seconds, " %.3f s", work.seconds);
      text += ", " + work.stage + seconds;
    }
    say(options_.tool, text);
  }

  void show_progress() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - clock_;
    const std::optional<double> end = evolution_->schedule().end();
    const double now = mesh_->time;
    char text[160];
    int size = std::snprintf(text, sizeof text, "time %.6g, %ld triangles, %.3g steps/s", now,
                             static_cast<long>(mesh_->triangle_count()), static_cast<double>(runs_) / passed.count());
    double part = -1;
    if (end && *end > start_.first_time) {
      part = (now - start_.first_time) / (*end - start_.first_time);
      const double left = passed.count() * (*end - now) / (now - begun_at_);
      std::snprintf(text + size, sizeof text - static_cast<std::size_t>(size), ", %d %%, %.0f s left",
                    static_cast<int>(100 * part), left);
    }
    line_.show(part, text);
  }

  const EvolveOptions& options_;
  Step step_;
  StepLogs logs_;
  ProgressLine line_;
  StageContext context_;
  std::size_t running_ = 0;  // the stage that works
  Start start_;
  std::unique_ptr<FrameOutput> output_;
  std::optional<Mesh> mesh_;
  std::optional<Evolution> evolution_;
  std::string text_;  // of the last frame
  double written_time_ = std::numeric_limits<double>::quiet_NaN();
  long runs_since_frame_ = 0, runs_ = 0;
  bool is_steady_ = false;
  std::chrono::steady_clock::time_point clock_ = std::chrono::steady_clock::now();
  double begun_at_ = 0;
};

/// A file that the step reads must not be one that evolve writes.
void refuse_overwriting(const EvolveOptions& options, const Step& step) {
  const auto refuse = [](const std::string& path) {
    throw UsageError("'" + path + "' is read by the step, and would be overwritten; write to another file");
  };
  for (const StepCommand& command : step.commands)
    for (std::size_t k = 1; k < command.size(); ++k) {
      const std::string& word = command[k].text;
      const std::string path = word.starts_with("--") ? word.substr(word.find('=') + 1) : word;
      for (const std::string* const written : {&options.tool.output, &options.log, &options.history})
        if (!written->empty() && *written != "-" && std::filesystem::is_regular_file(path) &&
            is_same_file(path, *written))
          refuse(path);
      if (!options.is_numbered() || !std::filesystem::is_regular_file(path)) continue;
      for (const std::string& frame : list_numbered(options.frames))
        if (is_same_file(path, frame)) refuse(path);
    }
}

}  // namespace

int simulate(const EvolveOptions& options) {
  Step step = parse_step(options.step_text);
  if (options.prints_pipe) {
    const std::string script = pipe_of(options, step);
    if (std::fwrite(script.data(), 1, script.size(), stdout) != script.size() || std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "standard output");
    return status::done;
  }
  refuse_overwriting(options, step);
  return Simulation(options, std::move(step)).run();
}

}  // namespace pliant

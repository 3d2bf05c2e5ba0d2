// tools/evolve/step_note.cpp: a comment with the options that choose frames and the end, then the step.
#include "evolve/step_note.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "evolve/frame_output.h"
#include "run/exit_status.h"
#include "run/output_file.h"

namespace pliant {
namespace {

constexpr std::string_view heading = "# evolve";
constexpr const char* steady_word = "steady-at";  // no option, but what --until-steady has led to

/// Standard output and devices keep nothing that could be continued.
bool has_step_file(const EvolveOptions& options) {
  if (options.is_numbered()) return true;
  std::error_code error;
  return options.tool.output != "-" && (!std::filesystem::exists(options.tool.output, error) ||
                                        std::filesystem::is_regular_file(options.tool.output, error));
}

/// The text of a note: its first line without the heading, and the step.
struct Note {
  std::string options, step;
};

[[noreturn]] void refuse_note(const EvolveOptions& options, const std::string& what) {
  throw UsageError("--resume: " + step_file(options) + " " + what + "; remove it to go on with this step");
}

std::optional<Note> find_note(const EvolveOptions& options) {
  std::ifstream file(step_file(options), std::ios::binary);
  if (!file) return {};
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t line_end = text.find('\n');
  if (line_end == std::string::npos || line_end + 1 == text.size() || text.back() != '\n')
    refuse_note(options, "is cut off");
  if (!text.starts_with(heading)) refuse_note(options, "does not tell what made the frames");
  return Note{text.substr(heading.size(), line_end - heading.size()),
              text.substr(line_end + 1, text.size() - line_end - 2)};
}

/// The options of a note.
struct NotedOptions {
  double every = 0, courant = 0, steady = 0;
  std::vector<double> at;
  std::optional<double> until, steady_at;
};

NotedOptions read_options(const EvolveOptions& options, const std::string& text) {
  NotedOptions noted;
  std::istringstream words(text);
  for (std::string option, digits; words >> option;) {
    double value = 0;
    const bool has_value = static_cast<bool>(words >> digits);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_number = has_value && error == std::errc() && end == digits.data() + digits.size();
    if (is_number && option == "--every")
      noted.every = value;
    else if (is_number && option == "--at")
      noted.at.push_back(value);
    else if (is_number && option == "--cfl")
      noted.courant = value;
    else if (is_number && option == "--until")
      noted.until = value;
    else if (is_number && option == "--until-steady")
      noted.steady = value;
    else if (is_number && option == steady_word)
      noted.steady_at = value;
    else
      refuse_note(options, "does not tell what made the frames");
  }
  return noted;
}

}  // namespace

std::string step_file(const EvolveOptions& options) {
  return options.is_numbered() ? beside_numbered(options.frames, "step") : options.tool.output + ".step";
}

void forget_step(const EvolveOptions& options) {
  std::error_code error;  // where it cannot be removed, the first frame cannot be written either
  if (has_step_file(options)) std::filesystem::remove(step_file(options), error);
}

void note_step(const EvolveOptions& options, const Step& step, std::optional<double> steady_at) {
  if (!has_step_file(options)) return;
  const std::string path = step_file(options);
  if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty()) make_folders(folder.string());
  OutputFile file(path);
  file.write(std::string(heading) + options.frame_options() + options.end_options() +
             (steady_at ? word_pair(steady_word, *steady_at) : "") + "\n" + text_of(step.commands) + "\n");
  file.commit();
}

std::optional<EarlierRun> read_note(const EvolveOptions& options, const Step& step) {
  const std::optional<Note> note = find_note(options);
  if (!note) return {};
  if (note->step != text_of(step.commands))
    throw UsageError("--resume: the step is another than that of the frames, which " + step_file(options) +
                     " tells: " + note->step);
  const NotedOptions noted = read_options(options, note->options);
  EarlierRun earlier{options.schedule, noted.steady, noted.steady_at};
  if (noted.every != static_cast<double>(options.schedule.every) || noted.courant != options.courant)
    refuse_other_frames(options);
  earlier.schedule.at = noted.at;
  earlier.schedule.until = noted.until;
  return earlier;
}

void refuse_other_frames(const EvolveOptions& options) {
  throw UsageError("--resume: the options that choose frames differ from those before, which " + step_file(options) +
                   " tells: evolve" + find_note(options).value_or(Note{}).options);
}

}  // namespace pliant

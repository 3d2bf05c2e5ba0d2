// tools/evolve/step_logs.cpp: --log and --history, a line for each run of the step, which a later run continues.
#include "evolve/step_logs.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <system_error>

#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

/// The size of the lines that stay: complete ones, as long as `stays` says so.
std::int64_t measure_kept(const std::string& path, const std::function<bool(const std::string& line)>& stays) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::system_error(errno, std::generic_category(), path);
  std::int64_t kept = 0;
  long number = 0;
  try {
    for (std::string line; ++number, std::getline(file, line) && !file.eof();) {  // at the end: half a line
      if (!stays(line)) break;
      kept += static_cast<std::int64_t>(line.size()) + 1;
    }
  } catch (const InputError& error) {
    throw InputError("", path + ":" + std::to_string(number) + ": " + error.what());
  }
  return kept;
}

/// The file, cut to what stays; a new one where nothing does.
GrowingFile continued(const std::string& path, std::int64_t kept) {
  return kept > 0 ? GrowingFile::reopen(path, kept) : GrowingFile::create(path);
}

}  // namespace

void StepLogs::create() {
  if (!log_path_.empty()) log_.emplace(GrowingFile::create(log_path_));
  if (!history_path_.empty()) history_.emplace(GrowingFile::create(history_path_));
}

std::vector<std::string> StepLogs::find_kept(double time, double first_time) {
  std::vector<std::string> short_files;
  double last = first_time;
  const auto keep = [time, &last](double line_time) {
    if (!(line_time <= time)) return false;
    last = line_time;
    return true;
  };
  const auto note = [&](const std::string& path) {
    if (last != time) short_files.push_back(path);
    last = first_time;
  };
  const auto is_there = [](const std::string& path) { return std::filesystem::is_regular_file(path); };
  if (!log_path_.empty()) {
    const auto stays = [&keep](const std::string& line) { return keep(read_step_time(line)); };
    if (is_there(log_path_)) kept_log_ = measure_kept(log_path_, stays);
    note(log_path_);
  }
  if (history_path_.empty()) return short_files;
  bool has_rows = false;
  const auto stays = [this, &keep, &has_rows](const std::string& line) {
    if (columns_.empty()) {
      columns_ = read_history_heading(line);
      return true;
    }
    const bool is_kept = keep(read_history_time(columns_, line));
    has_rows = has_rows || is_kept;
    return is_kept;
  };
  if (is_there(history_path_)) kept_history_ = measure_kept(history_path_, stays);
  if (!has_rows) columns_.clear();  // the heading comes with the first row
  if (!has_rows) kept_history_ = 0;
  note(history_path_);
  return short_files;
}

void StepLogs::reopen() {
  if (!log_path_.empty()) log_.emplace(continued(log_path_, kept_log_));
  if (!history_path_.empty()) history_.emplace(continued(history_path_, kept_history_));
}

void StepLogs::add(const StepLine& line) {
  std::string text;
  if (log_) {
    write_step_line(line, text);
    log_->append(text);
  }
  if (!history_) return;
  text.clear();
  if (columns_.empty()) {
    columns_ = history_columns(line);
    write_history_heading(columns_, text);
  }
  write_history_row(columns_, line, text);
  history_->append(text);
}

void StepLogs::finish() {
  for (std::optional<GrowingFile>* const file : {&log_, &history_})
    if (*file) (*file)->append("");
}

}  // namespace pliant

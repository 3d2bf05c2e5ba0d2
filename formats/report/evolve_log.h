// formats/report/evolve_log.h: what each step of a simulation did, as lines of JSON and as CSV (formats/evolve_log.md).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/mesh/pass_report.h"

namespace pliant {

/// What one stage did in one run of the step.
struct StageWork {
  std::string stage;
  PassReport report;
  double seconds = 0;
};

/// One run of the step: a whole step, or a part of one.
struct StepLine {
  std::int64_t step = 0, part = 1;
  double time = 0, dt = 0;
  std::int64_t triangles = 0;
  double min_scaled_jacobian = 0, min_logical_angle = 0;  ///< the angle in degrees
  std::vector<StageWork> stages;
};

/// Appends the line with its newline.
void write_step_line(const StepLine& line, std::string& out);
/// The time in such a line.   Throws InputError where it is none
double read_step_time(std::string_view line);

/// The columns of the table whose first row is this step: the figures of the step, then for each stage its seconds, its
/// values and its refusals, under "STAGE.NAME"; "STAGE-2.NAME" for a second stage of one name.
std::vector<std::string> history_columns(const StepLine& first);
/// Appends a heading, or the row of a step under given columns: a cell is empty where the step has no such value.
void write_history_heading(const std::vector<std::string>& columns, std::string& out);
void write_history_row(const std::vector<std::string>& columns, const StepLine& line, std::string& out);
/// The columns of a heading, and the time in a row.   Throws InputError where the text is none
std::vector<std::string> read_history_heading(std::string_view heading);
double read_history_time(const std::vector<std::string>& columns, std::string_view row);

}  // namespace pliant

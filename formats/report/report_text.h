// formats/report/report_text.h: the quality report for people, at most 80 columns wide.
#pragma once
#include <string>

#include "pliant/quality/quality_report.h"

namespace pliant {

/// Appends the report as text. `title` opens it (file and frame).
void write_report_text(const QualityReport& report, const std::string& title, std::string& out);

}  // namespace pliant

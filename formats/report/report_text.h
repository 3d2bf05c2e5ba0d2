// formats/report/report_text.h: the quality report for people, at most 80 columns wide.
#pragma once
#include <string>
#include <vector>

#include "formats/document/history.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Appends the report as text. `title` opens it (file and frame), a history that is not empty ends it.
void write_report_text(const QualityReport& report, const std::vector<HistoryEntry>& history, const std::string& title,
                       std::string& out);

}  // namespace pliant

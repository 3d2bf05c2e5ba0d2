// formats/report/report_json.h: the quality report as one line of JSON (formats/report.md).
#pragma once
#include <string>
#include <vector>

#include "formats/document/history.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Appends the report, one line with its newline. Numbers are in the shortest form that reads back to the same double;
/// values that do not exist are null. The members and their order are stable. A history that is not empty is a member.
void write_report(const QualityReport& report, const std::vector<HistoryEntry>& history, std::string& out);

}  // namespace pliant

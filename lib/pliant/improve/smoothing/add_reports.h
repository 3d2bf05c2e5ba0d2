// lib/pliant/improve/smoothing/add_reports.h: the report of two smoothings, one after the other.
#pragma once
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// Adds to the report of a second smoothing what the first one counted: its work is added, what was found at the
/// beginning is the first one's.
void add_first_smoothing(const PassReport& first, PassReport& second);

}  // namespace pliant

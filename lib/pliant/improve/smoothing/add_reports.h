// lib/pliant/improve/smoothing/add_reports.h: the report of two smoothings, one after the other.
#pragma once
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// Makes the report of a second smoothing that of both. Values that count work become the sums of both; values that
/// tell what was found at the beginning become those of the first; all others stay those of the second.
void add_first_smoothing(const PassReport& first, PassReport& second);

}  // namespace pliant

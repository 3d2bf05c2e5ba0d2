// tools/run/in_unit.h: what is said of a document that was brought to another unit of length.
#pragma once
#include <functional>
#include <string>

#include "pliant/mesh/pass_report.h"

namespace pliant {

/// Runs `work` on a document whose lengths are in `unit` (normalize_unit). Where that is not 1, what it throws says so:
/// places and lengths in its text are those of the normalised document.
void in_unit(double unit, const std::function<void()>& work);
/// Brings what a pass reports back into the units of the document; of notes, which are texts, it says that they are
/// not.
void report_in_document(PassReport& report, double unit);
/// That sentence; empty for 1.
std::string explain_unit(double unit);

}  // namespace pliant

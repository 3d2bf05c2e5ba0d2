// tools/run/in_unit.cpp: what is said of a document that was brought to another unit of length.
#include "run/in_unit.h"

#include <cmath>

#include "pliant/mesh/documents/document_unit.h"
#include "run/exit_status.h"

namespace pliant {

std::string explain_unit(double unit) {
  if (unit == 1) return {};
  return "places and lengths are given in units of 2^" + std::to_string(std::ilogb(unit));
}

void in_unit(double unit, const std::function<void()>& work) {
  if (unit == 1) return work();
  const std::string tail = " (" + explain_unit(unit) + ")";
  try {
    work();
  } catch (const BadMesh& e) {
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults) fault.text += tail;
    throw BadMesh(std::move(faults));
  } catch (const InputError& e) {
    throw InputError(e.pointer(), e.what() + tail);
  } catch (const NoResult& e) {
    throw NoResult(e.what() + tail);
  }
}

void report_in_document(PassReport& report, double unit) {
  restore_unit(report, unit);
  if (unit != 1 && !report.notes.empty()) report.notes.push_back("in these notes " + explain_unit(unit));
}

}  // namespace pliant

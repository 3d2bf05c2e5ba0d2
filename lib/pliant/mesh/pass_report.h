#pragma once  // lib/pliant/mesh/pass_report.h: what one pass did to one mesh, as numbers
#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// What a pass did: named counts and values in a fixed order, then refusals by reason. `--report` writes it as JSON, -v
/// as text.
struct PassReport {
  std::vector<std::pair<std::string, double>> values;  ///< whole numbers where they count something
  std::vector<std::pair<std::string, long>> refusals;  ///< reason -> how often; only those that occurred
  std::vector<std::string> notes;                      ///< sentences for -v: what blocks, what stays poor

  void add(std::string name, double value) { values.emplace_back(std::move(name), value); }
  void refuse(const std::string& reason, long times = 1) {
    for (auto& [name, count] : refusals)
      if (name == reason) {
        count += times;
        return;
      }
    refusals.emplace_back(reason, times);
  }
};

}  // namespace pliant

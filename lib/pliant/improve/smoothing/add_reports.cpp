// lib/pliant/improve/smoothing/add_reports.cpp: the report of two smoothings, one after the other.
#include "pliant/improve/smoothing/add_reports.h"

#include <string>

namespace pliant {
namespace {

double* find_value(PassReport& report, const std::string& name) {
  for (auto& [known, value] : report.values)
    if (known == name) return &value;
  return nullptr;
}

}  // namespace

void add_first_smoothing(const PassReport& first, PassReport& second) {
  for (const auto& [name, value] : first.values) {
    double* const now = find_value(second, name);
    if (now == nullptr) continue;
    if (name == "too_curved" || name == "not_good" || name == "energy_before") *now = value;
    for (const char* const work : {"edges_smoothed", "vertices_moved", "searches", "flips", "turned_back", "splits",
                                   "elements_smoothed", "points_moved", "iterations"})
      if (name == work) *now += value;
  }
}

}  // namespace pliant

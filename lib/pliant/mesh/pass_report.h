// lib/pliant/mesh/pass_report.h: what one pass did to one mesh, as numbers.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// One thing that a pass would have done but could not, and its place.
struct RefusedAt {
  std::string reason;
  Point place;  ///< in the mesh that the pass leaves: the middle of an edge, or a vertex
};

/// What a pass did: named counts and values in a fixed order, then refusals by reason. The option `--report` writes it
/// as JSON, `-v` as text.
struct PassReport {
  static constexpr long most_places = 1000;  ///< listed for one reason; further refusals are only counted

  std::vector<std::pair<std::string, double>> values;  ///< whole numbers where they count something
  std::vector<std::pair<std::string, long>> refusals;  ///< reason -> how often; only those that occurred
  std::vector<RefusedAt> refused_at;                   ///< those with a place, at most `most_places` a reason
  std::vector<std::size_t> lengths;                    ///< which of the values are lengths
  double resolution = 0;                               ///< places are printed to this length; 0: with all digits
  std::vector<std::string> notes;                      ///< sentences for -v: what blocks, what stays poor

  void add(std::string name, double value) { values.emplace_back(std::move(name), value); }
  void add_length(std::string name, double value) {
    lengths.push_back(values.size());
    add(std::move(name), value);
  }
  /// Appends the report of a pass that came after.
  void append(const PassReport& later) {
    for (const std::size_t k : later.lengths) lengths.push_back(values.size() + k);
    values.insert(values.end(), later.values.begin(), later.values.end());
    refusals.insert(refusals.end(), later.refusals.begin(), later.refusals.end());
    refused_at.insert(refused_at.end(), later.refused_at.begin(), later.refused_at.end());
    notes.insert(notes.end(), later.notes.begin(), later.notes.end());
  }
  /// Counts a refusal `times` times; returns how often its reason has been counted so far.
  long refuse(const std::string& reason, long times = 1) {
    for (auto& [name, count] : refusals)
      if (name == reason) return count += times;
    refusals.emplace_back(reason, times);
    return times;
  }
  /// Counts one refusal, and lists its place unless its reason has `most_places` already.
  void refuse(const std::string& reason, const Point& place) {
    if (refuse(reason) <= most_places) refused_at.push_back({reason, place});
  }
};

}  // namespace pliant

// tests/support/refusals.h: counts how much of what is damaged is still read, and how much is refused with words.
#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "pliant/boundary/fault.h"

namespace pliant::samples {

struct Outcomes {
  int taken = 0, refused = 0;

  /// Calls `read`, which may end in an InputError that says something.
  template <class Read>
  void count(const Read& read) {
    try {
      read();
      ++taken;
    } catch (const InputError& e) {
      if (std::string(e.what()).empty()) FAIL_CHECK("a refusal without a word");
      ++refused;
    }
  }
};

/// A check that prints only where it fails, since it is made thousands of times.
inline void check_none(const std::vector<Fault>& faults, const std::string& input = "") {
  if (!faults.empty()) FAIL_CHECK(faults.front().place << ": " << faults.front().text << "\n" << input);
}

}  // namespace pliant::samples

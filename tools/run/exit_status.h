// tools/run/exit_status.h: the exit statuses of the tools, and the errors that lead to them.
#pragma once
#include <stdexcept>
#include <utility>
#include <vector>

#include "pliant/boundary/fault.h"

namespace pliant {

/// Exit statuses of every tool.
namespace status {
inline constexpr int done = 0, check_failed = 1, wrong_usage = 2, bad_input = 3, no_result = 4, io_failed = 5,
                     internal_error = 6;
}

/// Wrong usage that the parser cannot see (status 2): options that exclude each other, a name that does not exist.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// No valid result (status 4): an unsafe step, contact, elements left invalid. The text says how far the tool came.
class NoResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A mesh that breaks what the tool needs (status 3), with every fault.
class BadMesh : public InputError {
 public:
  explicit BadMesh(std::vector<Fault> faults)
      : InputError(faults.front().place, faults.front().text), faults_(std::move(faults)) {}
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

}  // namespace pliant

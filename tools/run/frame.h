// tools/run/frame.h: which document of the input is at hand.
#pragma once
#include <string>

namespace pliant {

/// One document of the input.
struct Frame {
  std::string source;  ///< the file's name, or "standard input"
  long index = 0;      ///< number in the series, from 0
  long line = 1;       ///< on which it starts
};

}  // namespace pliant

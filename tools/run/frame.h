// tools/run/frame.h: which document of the input is at hand.
#pragma once
#include <cstdint>
#include <string>

#include "formats/document/document_form.h"

namespace pliant {

/// One document of the input.
struct Frame {
  std::string source;                      ///< the file's name, or "standard input"
  long index = 0;                          ///< number in the series, from 0
  long line = 1;                           ///< on which it starts
  std::int64_t byte = 0;                   ///< at which it starts, from 0
  DocumentForm form = DocumentForm::json;  ///< JSON for what is no document
};

}  // namespace pliant

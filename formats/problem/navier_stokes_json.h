// formats/problem/navier_stokes_json.h: the section `navierstokes` of a problem document, read and written.
#pragma once
#include "formats/document/document_reader.h"
#include "formats/document/document_writer.h"
#include "formats/problem/problem_document.h"

namespace pliant {

/// The value now being read as the section.   Throws DocumentError
NavierStokesSection read_navier_stokes(DocumentReader& in);
void write_navier_stokes(DocumentWriter& out, const NavierStokesSection& section);

}  // namespace pliant

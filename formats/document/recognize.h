// formats/document/recognize.h: what kind of file some bytes are, for the tool that was given the wrong one.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

inline constexpr std::size_t recognized_by = 4096;  ///< first bytes, or fewer

/// The kinds that tools read.
enum class FileKind { mesh, boundary, svg, msh, problem };

/// "this is an SVG drawing: import-svg makes a boundary of it ...", if the bytes look like a file of another kind than
/// `wanted`; empty if they look like nothing known.
std::string describe_other_kind(std::string_view bytes, FileKind wanted);

/// The same by the member `format` of a document; empty for one that is not Pliant's.
std::string describe_other_format(std::string_view format);

/// The candidate that `word` may be a misspelling of; empty if none is close.
///
/// An error is a character too many, too few, wrong, or exchanged with the next; about one in three may be wrong.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// How many typing errors lie between two words.
int typing_errors(std::string_view a, std::string_view b);

}  // namespace pliant

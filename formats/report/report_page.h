// formats/report/report_page.h: the fixed parts of the HTML report; the build makes them from page/.
#pragma once
#include <span>
#include <string_view>

namespace pliant {

/// All before the data: markup and style, in pieces, since compilers limit literals. "{{title}}" stands where the title
/// belongs.
std::span<const std::string_view> report_page_head();
/// All after the data: the script.
std::span<const std::string_view> report_page_tail();

}  // namespace pliant

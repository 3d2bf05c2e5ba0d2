// formats/vtu/xml_text.h: names as attributes of XML, which come back from its readers as they were.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

/// Is the text UTF-8, with characters only that XML 1.0 can hold?
bool is_xml_text(std::string_view text);
/// The text as the value of an attribute in double quotes. Bytes and characters that XML cannot hold become U+FFFD.
std::string escape_attribute(std::string_view text);

}  // namespace pliant

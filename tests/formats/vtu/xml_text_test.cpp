// tests/formats/vtu/xml_text_test.cpp: which texts XML can hold, and what becomes of the others.
#include "formats/vtu/xml_text.h"

#include <catch2/catch.hpp>

using namespace pliant;

TEST_CASE("texts that XML can hold are told from others", "[formats][vtu]") {
  for (const char* good : {"", "plain", "tab\tand\nline", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80",
                           "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBF\xBD", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    CHECK(is_xml_text(good));
  // Control characters, bytes that begin nothing, cut and overlong forms, surrogates, U+FFFE and U+FFFF, above
  // U+10FFFF.
  for (const char* bad : {"\x01", "\x1F", "\x80", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xE2\x82", "\xF0\x80\x80\x80",
                          "\xED\xA0\x80", "\xEF\xBF\xBE", "\xEF\xBF\xBF", "\xF4\x90\x80\x80", "\xFF", "a\xC3z"})
    CHECK_FALSE(is_xml_text(bad));
  CHECK_FALSE(is_xml_text(std::string_view("a\0b", 3)));
}

TEST_CASE("attributes escape what has a meaning in XML and replace what XML cannot hold", "[formats][vtu]") {
  CHECK(escape_attribute("<a & \"b\">") == "&lt;a &amp; &quot;b&quot;&gt;");
  CHECK(escape_attribute("a\tb\nc\rd") == "a&#9;b&#10;c&#13;d");
  CHECK(escape_attribute("Gr\xC3\xB6\xC3\x9F"
                         "e") ==
        "Gr\xC3\xB6\xC3\x9F"
        "e");
  CHECK(escape_attribute("a\x01z\xEF\xBF\xBFy\xFFx") == "a\xEF\xBF\xBDz\xEF\xBF\xBDy\xEF\xBF\xBDx");
  for (const char* any : {"\x01\x80\x80", "\xE2\x82", "\xF4\x90\x80\x80 end"})
    CHECK(is_xml_text(escape_attribute(any)));
}

# cmake -Dpage=DIR -Dscripts=a.js,b.js -Dout=FILE -P embed.cmake: writes FILE, the C++ source of what report_page.h
# declares. page.html says where style, data and script go; the scripts are joined in the order given.
file(READ ${page}/page.html html)
file(READ ${page}/page.css css)
set(script "")
string(REPLACE "," ";" scripts "${scripts}")
foreach(name IN LISTS scripts)
  # As text, not as a list: JavaScript is full of semicolons and brackets.
  file(READ ${page}/${name} part)
  string(APPEND script "${part}")
endforeach()

function(cut text mark before after)
  string(FIND "${text}" "${mark}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "page.html lacks ${mark}")
  endif()
  string(LENGTH "${mark}" length)
  math(EXPR rest "${at} + ${length}")
  string(SUBSTRING "${text}" 0 ${at} first)
  string(SUBSTRING "${text}" ${rest} -1 second)
  set(${before} "${first}" PARENT_SCOPE)
  set(${after} "${second}" PARENT_SCOPE)
endfunction()

# Compilers limit the length of one literal: the text goes in pieces of whole lines.
function(literal text result)
  set(pieces "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 4000 piece)
    string(FIND "${piece}" "\n" last REVERSE)
    math(EXPR step "${last} + 1")
    if(step GREATER 0)
      string(SUBSTRING "${piece}" 0 ${step} piece)
    endif()
    string(LENGTH "${piece}" step)
    string(APPEND pieces "    R\"page(${piece})page\",\n")
    math(EXPR at "${at} + ${step}")
  endwhile()
  set(${result} "${pieces}" PARENT_SCOPE)
endfunction()

cut("${html}" "/* page.css */" head html)
cut("${html}" "<!-- data -->" middle html)
cut("${html}" "/* page.js */" before_script after_script)
literal("${head}${css}${middle}" head_literal)
literal("${before_script}(() => {\n'use strict';\n${script}})();\n${after_script}" tail_literal)
file(WRITE ${out} "// Made from formats/report/page by embed.cmake.
#include \"formats/report/report_page.h\"

namespace pliant {

namespace {
constexpr std::string_view head[] = {
${head_literal}};
constexpr std::string_view tail[] = {
${tail_literal}};
}  // namespace

std::span<const std::string_view> report_page_head() { return head; }
std::span<const std::string_view> report_page_tail() { return tail; }

}  // namespace pliant
")

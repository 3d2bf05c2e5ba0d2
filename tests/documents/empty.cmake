# Empties the folder that is the last argument.
math(EXPR last "${CMAKE_ARGC} - 1")
set(folder "${CMAKE_ARGV${last}}")
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}")

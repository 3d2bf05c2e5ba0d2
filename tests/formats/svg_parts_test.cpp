// tests/formats/svg_parts_test.cpp: what stands around and above the mesh in a picture: axes, keys, arrows, isolines.
#include <catch2/catch.hpp>

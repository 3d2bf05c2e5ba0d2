// tests/documents/shape.h: what a document is made of, whatever its numbers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

/// The paths of the members, without the places in arrays, each with the kinds of its values (counts, integers, other
/// numbers, texts, ...) and the lengths of its arrays (none, one, two, more). What a schema can still tell apart in
/// documents of one shape are the words of texts, the limits of numbers and the lengths of longer arrays.
struct Shape {
  std::uint64_t hash = 0;
  std::size_t size = 0;  ///< bytes of the document; 0 where the text ends before it, or is none
};

/// The shape of the document that the text begins with.   Requires: nothing of the text
Shape shape_of_json(std::string_view text);
Shape shape_of_cbor(std::string_view text);

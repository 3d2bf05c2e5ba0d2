// tests/formats/byte_source_test.cpp: what gzip and zstd compressed is read as if it were not.
#include "formats/document/byte_source.h"

#include <zlib.h>
#include <zstd.h>

#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "pliant/boundary/fault.h"

using namespace pliant;

namespace {

std::string gzipped(const std::string& text) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&z, text.size()), '\0');
  std::string in = text;
  z.next_in = reinterpret_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

std::string zstd(const std::string& text) {
  std::string out(ZSTD_compressBound(text.size()), '\0');
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  out.resize(ZSTD_compress2(context, out.data(), out.size(), text.data(), text.size()));
  ZSTD_freeCCtx(context);
  return out;
}

std::string read(const std::string& bytes, std::size_t most = static_cast<std::size_t>(-1)) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  std::fwrite(bytes.data(), 1, bytes.size(), file.get());
  std::rewind(file.get());
  ByteSource source(file.get(), "name");
  return read_all(source, most);
}

std::string long_text() {
  std::string text;
  for (long k = 0; k < 100000; ++k) text += std::to_string(k * k) + ",";
  return text;
}

}  // namespace

TEST_CASE("compressed bytes are decompressed, in one piece or several", "[formats]") {
  const std::string text = long_text();
  for (const std::string& plain : {std::string(), std::string("{"), std::string("\x1F"), std::string("(\xB5"), text})
    CHECK(read(plain) == plain);
  for (const auto& pack : {gzipped, zstd}) {
    CHECK(read(pack(text)) == text);
    CHECK(read(pack("")).empty());
    CHECK(read(pack("a") + pack("") + pack(text)) == "a" + text);
  }
  CHECK(read(gzipped(text) + std::string(512, '\0')) == text);
}

TEST_CASE("compressed bytes that are damaged or cut off are refused with the file", "[formats]") {
  const std::string text = long_text();
  for (const auto& pack : {gzipped, zstd}) {
    const std::string packed = pack(text);
    for (const std::size_t kept : {std::size_t{5}, packed.size() / 2, packed.size() - 1})
      CHECK_THROWS_WITH(read(packed.substr(0, kept)), Catch::StartsWith("name: ") && Catch::Contains("ends early"));
    CHECK_THROWS_AS(read(packed + "rubbish"), InputError);
    std::string damaged = packed;
    for (std::size_t k = packed.size() / 2; k < packed.size() / 2 + 40; ++k)
      damaged[k] = static_cast<char>(~damaged[k]);
    CHECK_THROWS_AS(read(damaged), InputError);
  }
}

TEST_CASE("bytes of more than is wanted are refused with the file", "[formats]") {
  using Catch::Contains;
  using Catch::StartsWith;
  const std::string text(3'000'000, 'a');
  for (const auto& pack : {gzipped, zstd}) {
    CHECK(read(pack(text), text.size()) == text);
    CHECK_THROWS_WITH(read(pack(text), text.size() - 1), StartsWith("name: is longer than 2 MB once ") &&
                                                             Contains("decompresses it, and no more is read"));
  }
  CHECK_THROWS_WITH(read(text, text.size() - 1), "name: is longer than 2 MB, and no more is read of such a file");
}

TEST_CASE("bytes of zstd that take very much memory are refused with the way to read them", "[formats]") {
  const std::string window_of_256_mb("\x28\xB5\x2F\xFD\x00\x90\x01\x00\x00", 9);
  CHECK_THROWS_WITH(read(window_of_256_mb),
                    Catch::StartsWith("name: zstd compressed it with a window") && Catch::Contains("--long=31"));
  const std::string window_of_128_mb("\x28\xB5\x2F\xFD\x00\x88\x01\x00\x00", 9);
  CHECK(read(window_of_128_mb).empty());
}

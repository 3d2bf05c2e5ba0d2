// tests/bench/documents_bench.cpp: how fast mesh documents are read and written, in MB/s of their text.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "formats/document/document_stream.h"
#include "formats/document/mesh_document.h"
#include "pliant/geometry/net_layout.h"

namespace {

using namespace pliant;

/// The arrays of a quadratic mesh of n x n squares, each halved, its points off the lattice so that coordinates have
/// their full 16 or 17 digits; one field. It has no boundary: only the bulk counts here.
MeshData wavy_square(int n) {
  MeshData data;
  data.boundary.faces.push_back({"square", {}});
  const int side = 2 * n + 1;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = i / double(side), y = j / double(side);
      data.points.push_back({x + 0.01 * std::sin(9 * y + x), y + 0.01 * std::cos(7 * x - y)});
    }
  const auto id = [&](int i, int j) { return static_cast<PointId>(j * side + i); };
  for (int j = 0; j < 2 * n; j += 2)
    for (int i = 0; i < 2 * n; i += 2) {
      for (const PointId p : {id(i, j), id(i + 2, j), id(i, j + 2), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)})
        data.triangles.push_back(p);
      for (const PointId p :
           {id(i + 2, j), id(i + 2, j + 2), id(i, j + 2), id(i + 2, j + 1), id(i + 1, j + 2), id(i + 1, j + 1)})
        data.triangles.push_back(p);
      data.triangle_faces.insert(data.triangle_faces.end(), 2, 0);
    }
  Field field;
  field.name = "u";
  for (const Point& p : data.points) field.values.push_back(std::sin(3 * p.x) * std::exp(p.y));
  data.fields.push_back(std::move(field));
  return data;
}

struct Sample {
  MeshData data = wavy_square(650);  // about 100 MB
  std::string text, cbor;
  Sample() {
    write_mesh(data, text);
    write_mesh(data, cbor, DocumentForm::cbor);
  }
};

const Sample& sample() {
  static const Sample made;
  return made;
}

void count_bytes(benchmark::State& state, const std::string& text = sample().text) {
  const auto bytes = static_cast<double>(text.size());
  state.counters["MB"] = bytes / 1e6;
  state.counters["MB/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * bytes / 1e6, benchmark::Counter::kIsRate);
}

void write_document(benchmark::State& state) {
  std::string text;
  for (auto _ : state) {
    text.clear();
    write_mesh(sample().data, text);
    benchmark::DoNotOptimize(text.data());
  }
  count_bytes(state);
}

void read_document(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(sample().text).points.data());
  count_bytes(state);
}

/// From a file, as the tools read: cut from the stream, then read.
void stream_document(benchmark::State& state) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  std::fwrite(sample().text.data(), 1, sample().text.size(), file.get());
  std::fflush(file.get());
  for (auto _ : state) {
    std::rewind(file.get());
    DocumentStream stream(file.get(), "sample");
    std::string_view text;
    while (stream.next(text)) benchmark::DoNotOptimize(read_mesh(text).points.data());
  }
  count_bytes(state);
}

void write_cbor(benchmark::State& state) {
  std::string text;
  for (auto _ : state) {
    text.clear();
    write_mesh(sample().data, text, DocumentForm::cbor);
    benchmark::DoNotOptimize(text.data());
  }
  count_bytes(state, sample().cbor);
}

void read_cbor(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(sample().cbor).points.data());
  count_bytes(state, sample().cbor);
}

BENCHMARK(write_cbor)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_cbor)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write_document)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_document)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(stream_document)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

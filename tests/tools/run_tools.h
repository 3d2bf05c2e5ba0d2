// tests/tools/run_tools.h: runs the tools of this build, and their stages in this process.
#pragma once
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "formats/document/mesh_document.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/require_mesh.h"
#include "stages/run_stage.h"
#include "stages/table.h"

namespace pliant::testing {

using Words = std::vector<std::string>;
using Pipe = std::vector<Words>;  ///< the command lines of a pipe's tools

/// A file that is there as long as this.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / ("pliant-tools-test-" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

inline std::string quoted(const std::string& word) { return "'" + word + "'"; }

/// What the pipe writes for a document: standard output.   Throws std::runtime_error where a tool fails
inline std::string output_of(const Pipe& pipe, const std::string& document) {
  const TemporaryFile input(document);
  // The tools of this build, but behind those that collect documents (tests/documents), if there is a collection.
  std::string command =
      "PATH=${DOCUMENTS:+$DOCUMENTS/../bin:}" + quoted(PLIANT_BIN) + ":$PATH; cat " + quoted(input.path());
  for (const Words& words : pipe) {
    command += " | " + words.front();
    for (std::size_t k = 1; k < words.size(); ++k) command += " " + quoted(words[k]);
    command += " -q";
  }
  std::FILE* const in = popen(command.c_str(), "r");
  std::string output(1 << 16, '\0');
  std::size_t size = 0;
  for (std::size_t read = 1; read > 0; size += read) {
    if (output.size() - size < (1U << 16)) output.resize(2 * output.size());
    read = std::fread(output.data() + size, 1, output.size() - size, in);
  }
  output.resize(size);
  if (pclose(in) != 0) throw std::runtime_error("failed: " + command);
  return output;
}

inline Mesh mesh_of(const std::string& document) {
  MeshData data = read_mesh(document);
  normalize_unit(data);
  require_mesh(data, true);
  return Mesh(std::move(data));
}

inline std::string document_of(const Mesh& mesh) {
  MeshData data = mesh.to_data();
  restore_unit(data);
  std::string text;
  write_mesh(data, text);
  return text;
}

/// The stages of a pipe, parsed once, for any number of runs.
class Stages {
 public:
  explicit Stages(const Pipe& pipe) {
    for (const Words& words : pipe) stages_.push_back(parse_stage(words));
  }

  /// Sends the mesh so many times through the pipe.
  void run(Mesh& mesh, int times = 1) const {
    const Stage* before = nullptr;
    for (int k = 0; k < times; ++k)
      for (const std::unique_ptr<Stage>& stage : stages_) {
        if (before != nullptr) hand_over(mesh, *before, *stage);
        run_stage(*stage, mesh, {});
        before = stage.get();
      }
  }

  std::string output(const std::string& document, int times = 1) const {
    Mesh mesh = mesh_of(document);
    run(mesh, times);
    return document_of(mesh);
  }

 private:
  std::vector<std::unique_ptr<Stage>> stages_;
};

/// The pipe with itself behind it, so many times in all.
inline Pipe repeated(const Pipe& pipe, int times) {
  Pipe all;
  for (int k = 0; k < times; ++k) all.insert(all.end(), pipe.begin(), pipe.end());
  return all;
}

/// The text of a file in samples/.
inline std::string sample(const std::string& name) {
  std::ifstream file(std::string(PLIANT_SOURCE "/samples/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The meshed sample with three cells in a channel, of some degree.
inline std::string three_cells(int degree) {
  return output_of({{"bspline2mesh", "--degree", std::to_string(degree), "--max-turning", "40"}},
                   sample("three-cells/cells.json"));
}

}  // namespace pliant::testing

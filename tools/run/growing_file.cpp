// tools/run/growing_file.cpp: a file that grows by whole records, and that a later run can continue.
#include "run/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "run/output_file.h"

namespace pliant {

struct GrowingFile::State {
  explicit State(std::string path) : name(std::move(path)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (reopened >= 0) close(reopened);
  }

  std::string name;
  std::unique_ptr<OutputFile> created;  // either this
  int reopened = -1;                    // or this
  std::int64_t size = 0;

  int file() const { return created ? created->descriptor() : reopened; }
  [[noreturn]] void fail() const {
    throw std::system_error(errno, std::generic_category(), name == "-" ? "standard output" : name);
  }
};

GrowingFile::GrowingFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
GrowingFile::~GrowingFile() = default;
GrowingFile::GrowingFile(GrowingFile&&) noexcept = default;
GrowingFile& GrowingFile::operator=(GrowingFile&&) noexcept = default;

GrowingFile GrowingFile::create(const std::string& path) {
  auto state = std::make_unique<State>(path);
  state->created = std::make_unique<OutputFile>(path);
  return GrowingFile(std::move(state));
}

GrowingFile GrowingFile::reopen(const std::string& path, std::int64_t size) {
  auto state = std::make_unique<State>(path);
  state->reopened = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (state->reopened < 0) state->fail();
  GrowingFile file(std::move(state));
  file.cut(size);
  return file;
}

void GrowingFile::append(std::string_view record) {
  const auto take_back = [this] {
    const int error = errno;
    (void)!ftruncate(state_->file(), state_->size);
    (void)!lseek(state_->file(), state_->size, SEEK_SET);
    errno = error;
    state_->fail();
  };
  std::string_view left = record;
  while (!left.empty()) {
    const ssize_t written = ::write(state_->file(), left.data(), left.size());
    if (written >= 0)
      left.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      take_back();
  }
  if (state_->created && state_->size == 0) state_->created->publish();
  state_->size += static_cast<std::int64_t>(record.size());
}

void GrowingFile::cut(std::int64_t size) {
  if (ftruncate(state_->file(), size) != 0 || lseek(state_->file(), size, SEEK_SET) < 0) state_->fail();
  state_->size = size;
}

std::int64_t GrowingFile::size() const { return state_->size; }

}  // namespace pliant

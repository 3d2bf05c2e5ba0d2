// tools/run/output_file.cpp: a result that appears whole or not at all.
#include "run/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace pliant {
namespace {

/// A temporary file that a signal must not leave behind.
struct Unfinished {
  std::array<char, 4096> path;
  volatile std::sig_atomic_t is_used = 0;
};
/// As many as a tool ever has at once; a file that finds no place here stays if a signal ends the tool.
std::array<Unfinished, 8> unfinished;

void remove_and_end(int signal) {
  remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Unless a signal is ignored, as under nohup, or the tool handles it itself.
void remove_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    const auto before = std::signal(signal, remove_and_end);
    if (before != SIG_DFL && before != SIG_ERR) std::signal(signal, before);
  }
}

/// Its place among the unfinished; null if there is none.
Unfinished* remember(const std::string& path) {
  const auto free = std::ranges::find_if(unfinished, [](const Unfinished& each) { return each.is_used == 0; });
  if (free == unfinished.end() || path.size() >= free->path.size()) return nullptr;
  path.copy(free->path.data(), path.size());
  free->path[path.size()] = '\0';
  free->is_used = 1;
  remove_on_signals();
  return &*free;
}

/// The permissions that opening the file anew would give.
mode_t usual_mode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

/// What stands there after a tool was killed says by its name what it is.
std::string temporary_name(const std::string& path) {
  constexpr std::string_view mark = ".unfinished-XXXXXX";
  constexpr std::size_t longest = 255;  // of a name in a folder
  const std::size_t folder = path.rfind('/') + 1;
  const std::size_t kept = std::min(path.size() - folder, longest - mark.size());
  return path.substr(0, folder + kept) + std::string(mark);
}

}  // namespace

bool has_ending(std::string_view path, std::string_view ending) {
  const auto is_same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; };
  return path.size() >= ending.size() && std::ranges::equal(path.substr(path.size() - ending.size()), ending, is_same);
}

void remove_unfinished_files() {
  for (const Unfinished& each : unfinished)
    if (each.is_used != 0) unlink(each.path.data());
}

struct OutputFile::State {
  int file = STDOUT_FILENO;
  std::string name = "standard output";
  std::string target, temporary;  // temporary is empty where the file is written in place
  Unfinished* remembered = nullptr;

  [[noreturn]] void fail() const { throw std::system_error(errno, std::generic_category(), name); }

  void open_in_place(const std::string& path) {
    file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) fail();
  }

  void open_beside(const std::string& path, mode_t mode) {
    target = path;
    temporary = temporary_name(path);
    file = mkostemp(temporary.data(), O_CLOEXEC);
    if (file < 0) {
      temporary.clear();
      fail();
    }
    remembered = remember(temporary);
    if (fchmod(file, mode) != 0) fail();
  }

  void forget() {
    if (remembered != nullptr) remembered->is_used = 0;
    temporary.clear();
  }
};

OutputFile::OutputFile(const std::string& path) : state_(std::make_unique<State>()) {
  if (path == "-") return;
  state_->name = path;
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) {
    state_->open_beside(path, usual_mode());
  } else if (!S_ISREG(found.st_mode)) {
    state_->open_in_place(path);  // a directory refuses here
  } else {
    if (access(path.c_str(), W_OK) != 0) state_->fail();
    // A link stays a link: the file that it names is replaced.
    state_->open_beside(std::filesystem::canonical(path).string(), found.st_mode & 07777);
  }
}

OutputFile::~OutputFile() {
  if (state_->file >= 0 && state_->file != STDOUT_FILENO) close(state_->file);
  if (!state_->temporary.empty()) {
    unlink(state_->temporary.c_str());
    state_->forget();
  }
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(state_->file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      state_->fail();
  }
}

void OutputFile::publish() {
  if (state_->temporary.empty()) return;
  if (std::rename(state_->temporary.c_str(), state_->target.c_str()) != 0) state_->fail();
  state_->forget();
}

void OutputFile::commit() {
  // close tells of errors that the system held back, for example of a full disk.
  if (close(std::exchange(state_->file, -1)) != 0) state_->fail();
  publish();
}

int OutputFile::descriptor() const { return state_->file; }

}  // namespace pliant

// tests/documents/collect.cpp: stands in for a tool, runs it, and keeps a copy of the documents that it wrote.
//
// Links with the names of the tools lead here, in a folder in front of the tools' own. Each document goes to the folder
// that the environment names as DOCUMENTS; README.md beside this file says which ones. Without one, this becomes the
// tool.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "keep.h"
#include "outputs.h"

namespace {

namespace fs = std::filesystem;
pid_t child = 0;

void pass_on(int signal) { kill(child, signal); }

/// The tool that the name stands for: the next one on the PATH that is not this program.
std::string real_tool(const std::string& name) {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path candidate = fs::path(rest.substr(0, end)) / name;
    std::error_code none;
    if (access(candidate.c_str(), X_OK) == 0 && !fs::equivalent(candidate, self, none)) return candidate;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

/// A file from some place on, which may be open for writing alone.
Output read_file(const std::string& path, off_t from) {
  Output output;
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return output;
  struct stat file {};
  fstat(fd, &file);
  output.text.resize(
      std::min<std::size_t>(most_read, static_cast<std::size_t>(std::max<off_t>(file.st_size - from, 0))));
  const ssize_t size = pread(fd, output.text.data(), output.text.size(), from);
  output.text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  output.is_whole = output.text.size() < most_read;
  close(fd);
  return output;
}

/// Passes on what the tool writes into a pipe, until there is no more or nobody reads it; returns its beginning.
Output copy_through(int from) {
  Output output;
  std::string buffer(1 << 16, '\0');
  for (;;) {
    const ssize_t size = read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) break;
    const std::string_view part(buffer.data(), static_cast<std::size_t>(size));
    if (output.is_whole) output.text += part;
    output.is_whole = output.is_whole && output.text.size() < most_read;
    for (std::size_t done = 0; done < part.size();) {
      const ssize_t written = write(1, part.data() + done, part.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) {
        close(from);  // so that the tool ends as it would have
        output.is_whole = false;
        return output;
      }
      done += static_cast<std::size_t>(written);
    }
  }
  close(from);
  return output;
}

/// Where in a file the tool will begin to write.
off_t start_of(const struct stat& out) {
  if (!S_ISREG(out.st_mode)) return 0;
  return (fcntl(1, F_GETFL) & O_APPEND) != 0 ? out.st_size : lseek(1, 0, SEEK_CUR);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string tool = fs::path(argv[0]).filename();
  const std::string real = real_tool(tool);
  const char* const folder = std::getenv("DOCUMENTS");
  struct stat out {};
  const bool has_out = fstat(1, &out) == 0;
  if (real.empty()) return 127;
  if (!has_out || folder == nullptr || *folder == '\0' || tool.starts_with("export-")) {
    execv(real.c_str(), argv);
    return 127;
  }
  const off_t start = start_of(out);
  timespec now{};
  clock_gettime(CLOCK_REALTIME_COARSE, &now);  // the clock of the files
  int pipes[2] = {-1, -1};
  if ((S_ISFIFO(out.st_mode) || S_ISSOCK(out.st_mode)) && pipe2(pipes, O_CLOEXEC) != 0) return 127;
  child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (pipes[1] >= 0) dup2(pipes[1], 1);
    execv(real.c_str(), argv);
    _exit(127);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, pass_on);
  std::signal(SIGPIPE, SIG_IGN);
  Output output;
  if (pipes[1] >= 0) {
    close(pipes[1]);
    output = copy_through(pipes[0]);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool has_ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (S_ISREG(out.st_mode)) output = read_file("/proc/self/fd/1", start);
  output.is_whole = output.is_whole && has_ended_well;
  const std::string kind = tool == "qualityreport" ? "report" : "document";
  keep_documents({folder, kind, tool}, output);
  for (const NamedFile& file : files_written({argv + 1, argv + argc}, kind, now)) {
    output = read_file(file.path, 0);
    output.is_whole = output.is_whole && has_ended_well;
    keep_documents({folder, file.kind, tool}, output);
  }
  if (WIFSIGNALED(status)) {
    std::signal(WTERMSIG(status), SIG_DFL);
    raise(WTERMSIG(status));
  }
  return WEXITSTATUS(status);
}

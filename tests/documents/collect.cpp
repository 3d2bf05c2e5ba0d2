// tests/documents/collect.cpp: stands in for a tool, runs it, and keeps a copy of the documents that it wrote.
//
// Links with the names of the tools lead here, in a folder in front of the tools' own. Each document goes to the folder
// that the environment names as DOCUMENTS, as KIND-TOOL-HASH.json or .cbor; documents that differ in their numbers
// alone count as one.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
constexpr std::size_t longest = 1 << 18;  // of a document that is kept
constexpr int most_of_one = 4;            // documents of one file that are looked at
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

/// The same for texts that differ in numbers, and in how many there are in a row.
std::uint64_t hash_of_shape(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  bool in_numbers = false;
  for (const char c : text) {
    const bool is_of_number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e' || c == '+';
    if (in_numbers && (is_of_number || c == ',')) continue;
    in_numbers = c >= '0' && c <= '9';
    hash = (hash ^ static_cast<unsigned char>(in_numbers ? '0' : c)) * 1099511628211ULL;
  }
  return hash;
}

void keep(const std::string& kind, const std::string& tool, std::string_view text, const char* ending) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(hash_of_shape(text)));
  const std::string path = std::string(std::getenv("DOCUMENTS")) + "/" + kind + "-" + tool + "-" + hash + ending;
  if (access(path.c_str(), F_OK) == 0) return;
  const std::string whole = path + "." + std::to_string(getpid());  // so that no half of a document is ever there
  std::ofstream(whole, std::ios::binary) << text;
  std::rename(whole.c_str(), path.c_str());
}

void keep_documents(const std::string& kind, const std::string& tool, std::string_view text) {
  if (!text.empty() && (text[0] == '\xd9' || (text[0] & '\xe0') == '\xa0')) {
    if (text.size() <= longest) keep(kind, tool, text, ".cbor");
    return;
  }
  for (int k = 0; k < most_of_one && !text.empty(); ++k) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return;  // was cut, or is no document
    const std::string_view line = text.substr(0, end);
    if (line.starts_with('{') && line.size() <= longest) keep(kind, tool, line, ".json");
    text.remove_prefix(end + 1);
  }
}

std::string read_from(int fd, off_t from) {
  std::string text(longest * most_of_one, '\0');
  const ssize_t size = pread(fd, text.data(), text.size(), from);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

void keep_file(const std::string& kind, const std::string& tool, const std::string& path) {
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return;
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return;
  keep_documents(kind, tool, read_from(fd, 0));
  close(fd);
}

/// The files that the options of the command line name, each with the kind of its documents.
void keep_named_files(const std::string& tool, const std::string& kind, const std::vector<std::string>& words) {
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    if (words[k] == "-o" || words[k] == "--output") keep_file(kind, tool, words[k + 1]);
    if (words[k] == "--report") keep_file("pass_report", tool, words[k + 1]);
    if (words[k] == "--log") keep_file("evolve_log", tool, words[k + 1]);
  }
}

/// Passes on what the tool writes into a pipe, until there is no more or nobody reads it; returns its beginning.
std::string copy_through(int from) {
  std::string kept, buffer(1 << 16, '\0');
  for (;;) {
    const ssize_t size = read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) break;
    const std::string_view part(buffer.data(), static_cast<std::size_t>(size));
    if (kept.size() < longest * most_of_one) kept += part;
    for (std::size_t done = 0; done < part.size();) {
      const ssize_t written = write(1, part.data() + done, part.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) {
        close(from);  // so that the tool ends as it would have
        return {};
      }
      done += static_cast<std::size_t>(written);
    }
  }
  close(from);
  return kept;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string tool = fs::path(argv[0]).filename();
  const std::string real = real_tool(tool);
  struct stat out {};
  const bool has_out = fstat(1, &out) == 0;
  if (real.empty()) return 127;
  if (!has_out || std::getenv("DOCUMENTS") == nullptr || tool.starts_with("export-")) {
    execv(real.c_str(), argv);
    return 127;
  }
  const off_t start = !S_ISREG(out.st_mode)                 ? 0
                      : (fcntl(1, F_GETFL) & O_APPEND) != 0 ? out.st_size
                                                            : lseek(1, 0, SEEK_CUR);
  int pipes[2] = {-1, -1};
  if (S_ISFIFO(out.st_mode) && pipe2(pipes, O_CLOEXEC) != 0) return 127;
  child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (pipes[1] >= 0) dup2(pipes[1], 1);
    execv(real.c_str(), argv);
    _exit(127);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, pass_on);
  std::signal(SIGPIPE, SIG_IGN);
  std::string text;
  if (pipes[1] >= 0) {
    close(pipes[1]);
    text = copy_through(pipes[0]);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    std::signal(WTERMSIG(status), SIG_DFL);
    raise(WTERMSIG(status));
  }
  if (WEXITSTATUS(status) != 0) return WEXITSTATUS(status);
  const std::string kind = tool == "qualityreport" ? "report" : "document";
  if (S_ISREG(out.st_mode)) {
    const std::string path = "/proc/self/fd/1";  // which may be open for writing alone
    const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd >= 0) text = read_from(fd, start);
  }
  keep_documents(kind, tool, text);
  keep_named_files(tool, kind, {argv + 1, argv + argc});
  return 0;
}

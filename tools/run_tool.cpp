// tools/run_tool.cpp: from the command line to messages and an exit status.
#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <system_error>

#include "doubts.h"
#include "progress_line.h"
#include "series.h"

namespace pliant {
namespace {

/// A closed standard stream must not hand its descriptor to a file that is opened later.
void keep_standard_descriptors() {
  for (const int fd : {0, 1, 2})
    if (fcntl(fd, F_GETFD) < 0 && errno == EBADF) (void)!open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY);
}

/// Each line of the text is a message of its own.
void say_lines(const std::string& tool, const std::string& text) {
  std::string out;
  for (std::size_t first = 0, last = 0; first <= text.size() && last != std::string::npos; first = last + 1) {
    last = text.find('\n', first);
    out += tool + ": " + text.substr(first, last == std::string::npos ? last : last - first) + "\n";
  }
  std::fputs(out.c_str(), stderr);
}

}  // namespace

void add_common_options(CLI::App& app, ToolOptions& options, bool with_report) {
  options.tool = app.get_name();
  app.add_option("INPUT", options.input, "a file, or - for standard input")->capture_default_str();
  app.add_option("-o,--output", options.output, "write to this file, whole or not at all")->type_name("FILE");
  if (with_report)
    app.add_option("--report", options.report, "write what was done to this file, a line of JSON a frame")
        ->type_name("FILE");
  auto* quiet =
      app.add_flag("-q,--quiet", options.quiet, "no progress, no summary, no warnings; errors are said all the same");
  app.add_flag("-v,--verbose", options.verbose, "say what was done")->excludes(quiet);
  if (app.get_version_ptr() == nullptr)  // else the tool has more to say
    app.set_version_flag("--version", app.get_name() + " (Pliant) " PLIANT_VERSION);
}

int run_tool(CLI::App& app, int argc, char** argv, ToolOptions& options, const std::function<int()>& body) {
  std::signal(SIGPIPE, SIG_DFL);  // also where the parent ignores it
  keep_standard_descriptors();
  const auto stop = [&options](int exit_status, const std::string& text) {
    say_lines(options.tool, text);
    return exit_status;
  };
  options.tool = app.get_name();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
      return stop(status::wrong_usage,
                  explain_usage(app, e.what()) + "\n`" + options.tool + " --help` lists the options");
    app.exit(e);
    return std::fflush(stdout) == 0 && std::cout.flush() ? status::done : stop(status::io_failed, "cannot write");
  }
  try {
    return body();
  } catch (const Placed& e) {
    return stop(e.status(), e.what());
  } catch (const UsageError& e) {
    return stop(status::wrong_usage, e.what());
  } catch (const InputError& e) {
    return stop(status::bad_input, at_pointer(e.pointer(), e.what()));
  } catch (const NoResult& e) {
    return stop(status::no_result, e.what());
  } catch (const std::system_error& e) {
    return stop(status::io_failed, e.what());
  } catch (const std::bad_alloc&) {
    return stop(status::no_result, std::string(out_of_memory));
  } catch (const std::length_error&) {
    return stop(status::no_result, std::string(out_of_memory));
  } catch (const std::domain_error& e) {
    return stop(status::no_result, e.what());
  } catch (const std::exception& e) {
    return stop(status::internal_error, describe_internal_error(e.what()));
  } catch (...) {
    return stop(status::internal_error, describe_internal_error("an exception of an unknown kind"));
  }
}

void say(const ToolOptions& options, const std::string& text) {
  if (!options.quiet) say_failure(options, text);
}

void say_failure(const ToolOptions& options, const std::string& text) {
  const auto quiet_line = ProgressLine::give_way();
  std::fprintf(stderr, "%s: %s\n", options.tool.c_str(), text.c_str());
}

void say_written(const ToolOptions& options, std::size_t meshes, std::size_t triangles, std::size_t bytes) {
  if (!options.verbose) return;
  say(options, std::to_string(triangles) + " triangles" +
                   (meshes == 1 ? "" : " in " + std::to_string(meshes) + " meshes") + ", " + std::to_string(bytes) +
                   " bytes");
}

}  // namespace pliant

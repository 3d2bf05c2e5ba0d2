// tools/run/run_tool.cpp: from the command line to messages and an exit status.
#include "run/run_tool.h"

#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <system_error>

#include "completion/completion.h"
#include "options/usage.h"
#include "run/documents.h"
#include "run/doubts.h"
#include "run/exit_status.h"
#include "run/history.h"

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

int run_tool(CLI::App& app, int argc, char** argv, ToolOptions& options, const std::function<int()>& body) {
  std::signal(SIGPIPE, SIG_DFL);  // also where the parent ignores it
  keep_standard_descriptors();
  const auto stop = [&options](int exit_status, const std::string& text) {
    say_lines(options.tool, text);
    return exit_status;
  };
  options.tool = app.get_name();
  if (answer_completion(app, argc, argv)) return status::done;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
      return stop(status::wrong_usage,
                  explain_usage(app, e.what()) + "\n`" + options.tool + " --help` lists the options");
    app.exit(e);
    return std::fflush(stdout) == 0 && std::cout.flush() ? status::done : stop(status::io_failed, "cannot write");
  }
  if (options.history) options.given = options_that_count(app);
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

}  // namespace pliant

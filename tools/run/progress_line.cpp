// tools/run/progress_line.cpp: on a terminal, one line that tells how far a long run has come.
#include "run/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <thread>

namespace pliant {
namespace {

constexpr std::chrono::milliseconds patience{1000}, pause{100};
constexpr std::size_t least_bar = 5, widest_bar = 30;

ProgressLine* the_line = nullptr;

bool is_wanted(const ToolOptions& options) {
  const char* terminal = std::getenv("TERM");
  if (terminal != nullptr && std::string_view(terminal) == "dumb") return false;
  // A document that is written to the same terminal would be cut up.
  return !options.quiet && isatty(STDERR_FILENO) != 0 && (options.output != "-" || isatty(STDOUT_FILENO) == 0);
}

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string with_commas(long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) text += ',';
    text += digits[k];
  }
  return text;
}

/// A bar between head and tail, where there is room for one and the share is known (not below 0).
std::string with_bar(const std::string& head, double share, const std::string& tail, std::size_t width) {
  std::string bar;
  const std::size_t around = head.size() + tail.size() + 3;
  if (share >= 0 && around + least_bar <= width) {
    bar.assign(std::min(width - around, widest_bar), '.');
    std::fill_n(bar.begin(), static_cast<std::size_t>(share * static_cast<double>(bar.size())), '#');
    bar = " [" + bar + "]";
  }
  return (head + bar + tail).substr(0, width);
}

}  // namespace

struct ProgressLine::State {
  explicit State(const ToolOptions& options) : tool(options.tool) {}

  std::string tool;
  Progress counters;
  std::atomic<long> frames{0};
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::mutex mutex;  // guards what follows, and the terminal
  std::condition_variable wake;
  bool ends = false, drawn = false;
  std::thread thread;
  std::string words;  // instead of the counters
  double part = -1;

  /// At most `width` characters: the bar shrinks, then goes, and then the end is cut.
  std::string text(double seconds, std::size_t width) const {
    return words.empty() ? counted(seconds, width) : with_bar(tool + ":", part, " " + words, width);
  }

  std::string counted(double seconds, std::size_t width) const {
    const long done = counters.done.load(std::memory_order_relaxed), count = frames.load(std::memory_order_relaxed);
    const double expected = counters.expected.load(std::memory_order_relaxed);
    const std::string unit = counters.unit.load(std::memory_order_relaxed);
    std::string head = tool + ": ", tail;
    if (count > 0) head += with_commas(count) + (count == 1 ? " frame, " : " frames, ");
    head += counters.stage.load(std::memory_order_relaxed);
    const double share = expected > 0 ? std::min(static_cast<double>(done) / expected, 0.99) : 0;  // an estimate
    if (expected > 0) tail += " " + std::to_string(static_cast<int>(100 * share)) + " %";
    if (done > 0) tail += (expected > 0 ? ", " : " ") + with_commas(done) + " " + unit;
    tail += ", " + with_commas(static_cast<long>(seconds)) + " s";
    return with_bar(head, expected > 0 ? share : -1, tail, width);
  }

  void draw() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    // A full line would scroll.
    const std::string line = "\r" + text(passed.count(), terminal_width() - 1) + "\033[K";
    drawn = true;
    (void)!::write(STDERR_FILENO, line.data(), line.size());
  }

  void erase() {
    if (!drawn) return;
    drawn = false;
    constexpr std::string_view text = "\r\033[K";
    (void)!::write(STDERR_FILENO, text.data(), text.size());
  }

  void run() {
    std::unique_lock lock(mutex);
    auto next = start + patience;
    while (!wake.wait_until(lock, next, [this] { return ends; })) {
      draw();
      next = std::chrono::steady_clock::now() + pause;
    }
    erase();
  }
};

ProgressLine::ProgressLine(const ToolOptions& options) {
  if (!is_wanted(options)) return;
  state_ = std::make_unique<State>(options);
  the_line = this;
  state_->thread = std::thread([this] { state_->run(); });
}

ProgressLine::~ProgressLine() {
  if (!state_) return;
  the_line = nullptr;
  {
    const std::lock_guard lock(state_->mutex);
    state_->ends = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

Progress* ProgressLine::counters() { return state_ ? &state_->counters : nullptr; }

void ProgressLine::stage(const char* name) {
  if (state_) state_->counters.start(name);
}

void ProgressLine::frames_done(long count) {
  if (state_) state_->frames.store(count, std::memory_order_relaxed);
}

void ProgressLine::show(double part, const std::string& words) {
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  state_->part = std::min(part, 1.0);
  state_->words = words;
}

std::unique_lock<std::mutex> ProgressLine::give_way() {
  if (the_line == nullptr) return {};
  std::unique_lock lock(the_line->state_->mutex);
  the_line->state_->erase();
  return lock;
}

}  // namespace pliant

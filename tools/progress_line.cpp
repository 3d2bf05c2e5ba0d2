// tools/progress_line.cpp: on a terminal, one line that tells how far a long run has come.
#include "progress_line.h"

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
  std::string text = std::to_string(number);
  for (std::size_t k = text.size(); k > 3; k -= 3) text.insert(k - 3, ",");
  return text;
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

  /// At most `width` characters: the bar shrinks, then goes, and then the end is cut.
  std::string text(double seconds, std::size_t width) const {
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
    std::string bar;
    const std::size_t around = head.size() + tail.size() + 3;
    if (expected > 0 && around + least_bar <= width) {
      bar.assign(std::min(width - around, widest_bar), '.');
      std::fill_n(bar.begin(), static_cast<std::size_t>(share * static_cast<double>(bar.size())), '#');
      bar = " [" + bar + "]";
    }
    return (head + bar + tail).substr(0, width);
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

ProgressLine* ProgressLine::shown() { return the_line; }

std::unique_lock<std::mutex> ProgressLine::give_way() {
  if (the_line == nullptr) return {};
  std::unique_lock lock(the_line->state_->mutex);
  the_line->state_->erase();
  return lock;
}

Progress* start_refinement(const Mesh& mesh, const QualityGoals& goals) {
  ProgressLine* line = ProgressLine::shown();
  if (line == nullptr) return nullptr;
  // Measured: areas end at 1/1.75 of their bound on the average, and at size^2/2.57.
  double triangles = 0;
  constexpr long samples = 100'000;
  const int each = std::clamp(static_cast<int>(std::sqrt(samples / (1.0 + mesh.triangle_count()))), 1, 100);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
                &c = mesh.point(mesh.corner(t, 2));
    const double area = std::fabs(cross(b - a, c - a)) / 2, bound = goals.area_bound(mesh.face(t)) / 1.75;
    if (!goals.size) {
      triangles += std::max(1.0, area / bound);
      continue;
    }
    double inside = 0;
    for (int i = 0; i < each; ++i)
      for (int j = 0; i + j < each; ++j) {
        const double u = (i + 1.0 / 3) / each, v = (j + 1.0 / 3) / each;
        const double size = goals.size(a + u * (b - a) + v * (c - a), mesh.time);
        const double wanted = size > 0 ? std::min(bound, size * size / 2.57) : bound;
        inside += area / (0.5 * each * (each + 1)) / wanted;
      }
    triangles += std::max(1.0, inside);
  }
  const double points = (triangles - mesh.triangle_count()) / 2;
  line->counters()->start("refine", "points", points > 1000 && std::isfinite(points) ? points : 0);
  return line->counters();
}

}  // namespace pliant

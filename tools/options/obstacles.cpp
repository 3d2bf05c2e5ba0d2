// tools/options/obstacles.cpp: what stands beside a mesh in pictures and reports: disks and drawings.
#include "options/obstacles.h"

#include <cerrno>
#include <cstdio>
#include <map>
#include <memory>
#include <system_error>

#include "formats/document/byte_source.h"
#include "formats/document/recognize.h"
#include "formats/svg_import/svg_reader.h"
#include "options/picture_options.h"
#include "pliant/boundary/fault.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

constexpr int pieces = 8;  // of a span: chords of a smooth span are within a few thousandths of its length

/// Points along the curve, without its last one.
void append_points(const BSpline& spline, bool forward, std::vector<Point>& out) {
  std::vector<double> parameters;
  const std::vector<double> breaks = spline.breaks();
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
    for (int k = 0; k < (spline.degree() > 1 ? pieces : 1); ++k)
      parameters.push_back(breaks[s] + (breaks[s + 1] - breaks[s]) * k / pieces);
  if (!forward) {
    parameters.push_back(spline.last_parameter());
    parameters.erase(parameters.begin());
    parameters = {parameters.rbegin(), parameters.rend()};
  }
  for (const double t : parameters) out.push_back(spline.evaluate(t));
}

/// The outline of all faces together: closed curves, and open ones joined to loops. Where more than two meet any way to
/// join them fills the same area.
std::vector<std::vector<Point>> loops_of(const BoundaryComplex& boundary) {
  std::vector<std::vector<Point>> loops;
  std::vector<bool> is_used(boundary.curves.size(), false);
  for (std::size_t c = 0; c < boundary.curves.size(); ++c)
    is_used[c] = boundary.curves[c].left != outside && boundary.curves[c].right != outside;
  std::multimap<int, std::size_t> at_vertex;
  for (std::size_t c = 0; c < boundary.curves.size(); ++c)
    for (const int vertex : {boundary.curves[c].start, boundary.curves[c].end})
      if (vertex != no_vertex) at_vertex.emplace(vertex, c);
  for (std::size_t first = 0; first < boundary.curves.size(); ++first) {
    if (is_used[first]) continue;
    std::vector<Point>& loop = loops.emplace_back();
    std::size_t c = first;
    bool forward = true;
    while (!is_used[c]) {
      is_used[c] = true;
      const Curve& curve = boundary.curves[c];
      append_points(curve.spline, forward, loop);
      const int vertex = forward ? curve.end : curve.start;
      if (vertex == no_vertex) break;
      const auto [begin, end] = at_vertex.equal_range(vertex);
      for (auto next = begin; next != end; ++next)
        if (!is_used[next->second]) {
          c = next->second;
          forward = boundary.curves[c].start == vertex;
          break;
        }
    }
  }
  return loops;
}

}  // namespace

std::vector<Circle> parse_circles(const std::vector<std::string>& texts) {
  std::vector<Circle> circles;
  for (const std::string& text : texts) {
    const std::vector<double> numbers = parse_numbers("--circle", text, ',', 3, "X,Y,R");
    if (!(numbers[2] > 0)) throw UsageError("--circle " + text + ": the radius must be positive");
    circles.push_back({{numbers[0], numbers[1]}, numbers[2]});
  }
  return circles;
}

std::vector<std::vector<Point>> read_outlines(const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (stream == nullptr) throw std::system_error(errno, std::generic_category(), file);
  ByteSource source(stream.get(), file);
  const std::string bytes = read_all(source, most_svg_bytes);
  try {
    SvgReadOptions options;
    options.planar = true;  // shapes may lie over each other
    return loops_of(read_svg(bytes, options).boundary);
  } catch (const InputError& error) {
    if (const std::string other = describe_other_kind(bytes, FileKind::svg); !other.empty())
      throw InputError("", "--svg " + file + ": " + other);
    throw InputError("",
                     "--svg " + file + ": " + (error.pointer().empty() ? "" : error.pointer() + ": ") + error.what());
  }
}

}  // namespace pliant

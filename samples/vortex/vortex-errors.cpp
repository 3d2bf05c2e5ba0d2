// samples/vortex/vortex-errors.cpp: how far frames of the reversed vortex are from the exact motion, as a JSON line
// each.
//
// usage: vortex-errors FRAMES.jsonl [MARKERS [TIME,...]]
//
// The first frame is the start. Of each frame, or of those at the times given: `interface`, the greatest distance of
// markers (100,000 if not said), which start on the exact circle, from the interface; `drift`, the change of the
// enclosed area, relative to the start's; `circle`, the area of the symmetric difference to the exact circle (at the
// start and at the period, where the interface is back); `field`, the L2 norm of the error of the field f, which starts
// as sin 3x sin 3y.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats/document/document_stream.h"
#include "formats/document/mesh_document.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/quadrature.h"

namespace {
using namespace pliant;

constexpr double pi = std::numbers::pi;
constexpr double period = 8, radius = 0.15;
constexpr Point centre{0.5, 0.75};

/// Rider and Kothe's single vortex, reversed by cos(pi t / period).
Vector velocity(const Point& p, double t) {
  const double sx = std::sin(pi * p.x), cx = std::cos(pi * p.x), sy = std::sin(pi * p.y), cy = std::cos(pi * p.y);
  const double now = 2 * std::cos(pi * t / period);
  return {-now * sx * sx * sy * cy, now * sy * sy * sx * cx};
}

/// Is everything where it was at the start?
bool is_back(double time) { return std::abs(std::remainder(time, period)) < 1e-9; }

/// The steps of a marker and of a point of the field. Errors at T/2 grow with the fifth power of the step: from 3e-10
/// with steps of 0.01, as steps of 0.0025 show, so that they are about 1e-11 and 1e-8.
constexpr double marker_step = 0.005, field_step = 0.02;

/// Where the flow carries a point from one time to another, by Dormand and Prince's method of order 5.
Point carry(Point p, double from, double to, double longest_step) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / longest_step - 1e-9)));
  const double h = (to - from) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = from + i * h;
    const Vector k1 = velocity(p, t);
    const Vector k2 = velocity(p + h / 5 * k1, t + h / 5);
    const Vector k3 = velocity(p + h * (3.0 / 40 * k1 + 9.0 / 40 * k2), t + 0.3 * h);
    const Vector k4 = velocity(p + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3), t + 0.8 * h);
    const Vector k5 = velocity(
        p + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 - 212.0 / 729 * k4), t + 8 * h / 9);
    const Vector k6 = velocity(
        p + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 - 5103.0 / 18656 * k5),
        t + h);
    p = p + h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 + 11.0 / 84 * k6);
  }
  return p;
}

/// The interface: the constrained edges of curve 0, with samples along them in a grid, by which the nearest place is
/// found.
class Interface {
 public:
  explicit Interface(const MeshData& mesh) : degree_(mesh.degree) {
    for (const ConstrainedEdge& edge : mesh.constrained_edges) {
      if (edge.curve != 0) continue;
      std::vector<double> polygon;
      for (const PointId p : edge.points) {
        polygon.push_back(mesh.points[static_cast<std::size_t>(p)].x);
        polygon.push_back(mesh.points[static_cast<std::size_t>(p)].y);
      }
      for (int i = 0; i < samples; ++i) {
        const Point place = at(polygon, (i + 0.5) / samples);
        grid_[key(cell_of(place.x), cell_of(place.y))].push_back(
            {place, static_cast<int>(edges_.size()), (i + 0.5) / samples});
      }
      edges_.push_back(std::move(polygon));
    }
  }
  std::size_t spans() const { return edges_.size(); }

  /// The distance from a point. Newton's method goes on from the nearest samples; infinite if there is none nearby.
  double distance_to(const Point& p) const {
    struct Near {
      double distance;
      const Sample* sample;
    };
    std::vector<Near> near;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (const auto found = grid_.find(key(cell_of(p.x) + i, cell_of(p.y) + j)); found != grid_.end())
          for (const Sample& sample : found->second) near.push_back({distance(p, sample.place), &sample});
    const auto some = near.begin() + std::min<std::ptrdiff_t>(4, std::ssize(near));
    std::partial_sort(near.begin(), some, near.end(),
                      [](const Near& a, const Near& b) { return a.distance < b.distance; });
    double least = HUGE_VAL;
    for (auto each = near.begin(); each != some; ++each) least = std::min(least, from_edge(p, *each->sample));
    return least;
  }

  /// Calls visit(place, step) for pieces of the interface: their middle, and the vector along them times their length.
  template <typename Visit>
  void along(Visit visit) const {
    for (const std::vector<double>& polygon : edges_)
      for (int piece = 0; piece < 8; ++piece)
        for (const SegmentNode& node : segment_rule(8)) {
          const double s = (piece + node.s) / 8;
          visit(at(polygon, s), node.weight / 8 * slope(polygon, s));
        }
  }

 private:
  static constexpr int samples = 16;
  static constexpr double cell = 1.0 / 256;
  struct Sample {
    Point place;
    int edge;
    double s;
  };
  static int cell_of(double x) { return static_cast<int>(std::floor(x / cell)); }
  static int key(int i, int j) { return 4096 * i + j; }
  Point at(const std::vector<double>& polygon, double s) const {
    std::array<double, 2> value{};
    evaluate_polygon(degree_, 2, polygon, s, value);
    return {value[0], value[1]};
  }
  Vector slope(const std::vector<double>& polygon, double s) const {
    std::vector<double> differences;
    for (std::size_t i = 2; i < polygon.size(); ++i) differences.push_back(degree_ * (polygon[i] - polygon[i - 2]));
    std::array<double, 2> value{};
    evaluate_polygon(degree_ - 1, 2, differences, s, value);
    return {value[0], value[1]};
  }
  double from_edge(const Point& p, const Sample& start) const {
    const std::vector<double>& polygon = edges_[static_cast<std::size_t>(start.edge)];
    double s = start.s;
    for (int i = 0; i < 6; ++i) {
      const Vector along = slope(polygon, s);
      s = std::clamp(s + dot(p - at(polygon, s), along) / dot(along, along), 0.0, 1.0);
    }
    return distance(p, at(polygon, s));
  }

  int degree_;
  std::vector<std::vector<double>> edges_;
  std::unordered_map<int, std::vector<Sample>> grid_;
};

double enclosed_area(const Interface& interface) {
  double twice = 0;
  interface.along([&](const Point& p, const Vector& step) { twice += cross(p - centre, step); });
  return twice / 2;
}

/// The area between the interface and the exact circle; the interface must run once round the centre.
double off_circle(const Interface& interface) {
  double area = 0;
  interface.along([&](const Point& p, const Vector& step) {
    const Vector arm = p - centre;
    area += std::abs(dot(arm, arm) - radius * radius) / 2 * cross(arm, step) / dot(arm, arm);
  });
  return area;
}

double marker_error(const Interface& interface, double time, int markers) {
  double greatest = 0;
  for (int i = 0; i < markers; ++i) {
    const double angle = 2 * pi * i / markers;
    const Point start{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    greatest = std::max(greatest, interface.distance_to(is_back(time) ? start : carry(start, 0, time, marker_step)));
  }
  return greatest;
}

const Field* find_field(const MeshData& mesh) {
  const auto found = std::ranges::find_if(mesh.fields, [](const Field& each) { return each.name == "f"; });
  return found == mesh.fields.end() ? nullptr : &*found;
}

double field_error(const MeshData& mesh, const Field& field) {
  const std::size_t n = static_cast<std::size_t>((mesh.degree + 1) * (mesh.degree + 2) / 2);
  std::vector<double> net(3 * n);
  double squared = 0;
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto p = static_cast<std::size_t>(mesh.triangles[n * t + k]);
      net[3 * k] = mesh.points[p].x;
      net[3 * k + 1] = mesh.points[p].y;
      net[3 * k + 2] = field.values[p];
    }
    for (const TriangleNode& node : triangle_rule(6)) {
      std::array<double, 3> value{}, along_2{}, along_3{};
      evaluate_net(mesh.degree, 3, net, node.xi, value, along_2, along_3);
      const Point from =
          is_back(mesh.time) ? Point{value[0], value[1]} : carry({value[0], value[1]}, mesh.time, 0, field_step);
      const double off = value[2] - std::sin(3 * from.x) * std::sin(3 * from.y);
      squared += node.weight * (along_2[0] * along_3[1] - along_2[1] * along_3[0]) * off * off;
    }
  }
  return std::sqrt(squared);
}

std::vector<double> times_in(const char* text) {
  std::vector<double> times;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) times.push_back(std::stod(word));
  return times;
}

void measure(const char* path, int markers, const std::vector<double>& times) {
  std::FILE* file = std::fopen(path, "rb");
  if (file == nullptr) throw std::runtime_error(std::string(path) + ": cannot be read");
  DocumentStream stream(file, path);
  double first_area = 0;
  for (std::string_view document; stream.next(document);) {
    const MeshData mesh = read_mesh(document);
    const auto is_here = [&](double time) { return std::abs(time - mesh.time) < 1e-9; };
    if (first_area != 0 && !times.empty() && std::ranges::none_of(times, is_here)) continue;
    const Interface interface(mesh);
    const double area = enclosed_area(interface);
    if (first_area == 0) first_area = area;
    std::printf(R"({"time": %.10g, "degree": %d, "triangles": %zu, "spans": %zu, "interface": %.4g, "drift": %.4g)",
                mesh.time, mesh.degree, mesh.triangle_faces.size(), interface.spans(),
                marker_error(interface, mesh.time, markers), area / first_area - 1);
    if (is_back(mesh.time)) std::printf(R"(, "circle": %.4g)", off_circle(interface));
    if (const Field* field = find_field(mesh)) std::printf(R"(, "field": %.4g)", field_error(mesh, *field));
    std::printf("}\n");
    std::fflush(stdout);
  }
  std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::fputs("usage: vortex-errors FRAMES.jsonl [MARKERS [TIME,...]]\n", stderr);
    return 2;
  }
  try {
    measure(argv[1], argc > 2 ? std::stoi(argv[2]) : 100000, argc > 3 ? times_in(argv[3]) : std::vector<double>{});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vortex-errors: %s\n", error.what());
    return 3;
  }
  return 0;
}

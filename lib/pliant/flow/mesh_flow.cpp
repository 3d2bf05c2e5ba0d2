// lib/pliant/flow/mesh_flow.cpp: locates places in the meshes of frames, and interpolates between frames.
#include "pliant/flow/mesh_flow.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/describe.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/location/nearest_boundary.h"

namespace pliant {
namespace {

constexpr double boundary_tolerance = 1e-9;  // of a mesh's size: two meshes of one domain differ by rounding there
constexpr double time_tolerance = 1e-12;     // of the times: sums of steps miss the last frame by a few bits

}  // namespace

/// A mesh with its field, and what finds places in it.
struct MeshFlow::Frame {
  Frame(Mesh its_mesh, int its_field) : mesh(std::move(its_mesh)), field(its_field), locator(mesh) {}

  Vector evaluate(const Location& at) const {
    std::array<double, 2 * pliant::net_size(max_degree)> net;
    const auto points = mesh.net(at.triangle);
    const std::vector<double>& values = mesh.fields()[static_cast<std::size_t>(field)].values;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto i = static_cast<std::size_t>(mesh.value_index(field, points[k], mesh.face(at.triangle)));
      net[2 * k] = values[i];
      net[2 * k + 1] = values[i + 1];
    }
    std::array<double, 2> value;
    evaluate_net(mesh.degree(), 2, std::span(net).first(2 * points.size()), at.xi, value);
    return {value[0], value[1]};
  }

  Mesh mesh;
  int field;
  Locator locator;
  std::optional<NearestBoundary> boundary{};  // made when the first place is outside
  TriangleId last = none;                     // where the last place was found
};

MeshFlow::MeshFlow(std::string name, Outside policy) : name_(std::move(name)), outside_(policy) {}
MeshFlow::~MeshFlow() = default;

void MeshFlow::add(Mesh mesh, int field) {
  assert(frames_.empty() || mesh.time > last_time());
  frames_.push_back(std::make_unique<Frame>(std::move(mesh), field));
}

double MeshFlow::last_time() const { return frames_.back()->mesh.time; }

double MeshFlow::clamp_time(double time) const {
  const double first = frames_.front()->mesh.time, last = last_time();
  if (frames_.size() == 1) return first;
  const double inside = std::clamp(time, first, last);
  if (outside_ == Outside::refuse &&
      !(std::abs(time - inside) <= time_tolerance * std::max(std::abs(first), std::abs(last))))
    throw NoVelocity("time " + describe_number(time) + " is " +
                     (time < first ? "before the first frame of " + name_ + ", at time " + describe_number(first)
                                   : "after the last frame of " + name_ + ", at time " + describe_number(last)) +
                     "; --outside nearest takes that frame");
  return inside;
}

Vector MeshFlow::in_frame(Frame& frame, const Point& place, double time) {
  const double unit = frame.mesh.boundary().unit;
  const Point p = place / unit;
  if (const auto found = frame.locator.find(p, frame.last)) {
    frame.last = found->triangle;
    return frame.evaluate(*found);
  }
  if (!is_finite(p)) return {HUGE_VAL, HUGE_VAL};
  if (!frame.boundary) frame.boundary.emplace(frame.mesh);
  const NearestPlace nearest = frame.boundary->find(p);
  if (outside_ == Outside::refuse && !(nearest.distance <= boundary_tolerance * frame.mesh.size()))
    throw NoVelocity("the point " + describe_point(place) + ", at time " + describe_number(time) +
                     ", is outside the mesh of " + name_ +
                     (frames_.size() > 1 ? " at time " + describe_number(frame.mesh.time) : "") + ", by " +
                     describe_number(unit * nearest.distance) + "; --outside nearest takes the nearest point");
  return frame.evaluate(nearest.location);
}

Vector MeshFlow::velocity(const Point& place, double time) {
  assert(!frames_.empty());
  const double at = clamp_time(time);
  const auto after = std::lower_bound(frames_.begin(), frames_.end(), at,
                                      [](const auto& frame, double t) { return frame->mesh.time < t; });
  Frame& later = **after;
  if (later.mesh.time == at) return in_frame(later, place, time);
  Frame& earlier = **(after - 1);
  const double s = (at - earlier.mesh.time) / (later.mesh.time - earlier.mesh.time);
  const Vector before = in_frame(earlier, place, time), next = in_frame(later, place, time);
  return (1 - s) * before + s * next;
}

}  // namespace pliant

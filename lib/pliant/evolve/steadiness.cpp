// lib/pliant/evolve/steadiness.cpp: how fast a velocity that the mesh carries changes at fixed places.
#include "pliant/evolve/steadiness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/locate.h"

namespace pliant {
Steadiness::Steadiness(const Mesh& mesh, int field) : time_(mesh.time) {
  const std::vector<double>& values = mesh.fields()[index(field)].values;
  std::vector<char> is_vertex(index(mesh.point_slots()), 0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t))
      for (int k = 0; k < 3; ++k) is_vertex[index(mesh.corner(t, k))] = 1;
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    if (is_vertex[index(p)] == 0) continue;
    places_.push_back(mesh.boundary().unit * mesh.point(p));
    values_.push_back({values[2 * index(p)], values[2 * index(p) + 1]});
  }
}

double Steadiness::rate(const Mesh& mesh, int field) const {
  const Field& velocity = mesh.fields()[index(field)];
  std::vector<Point> places;
  places.reserve(places_.size());
  for (const Point& place : places_) places.push_back(place / mesh.boundary().unit);
  std::vector<std::optional<Location>> found(places.size());
  Locator(mesh).find_all(places, found);
  std::vector<double> net;
  double change = 0, speed = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!found[k]) continue;
    net.clear();
    for (const PointId p : mesh.net(found[k]->triangle))
      net.insert(net.end(), {velocity.values[2 * index(p)], velocity.values[2 * index(p) + 1]});
    std::array<double, 2> now{};
    evaluate_net(mesh.degree(), 2, net, found[k]->xi, now);
    change = std::max(change, length(Vector{now[0] - values_[k].x, now[1] - values_[k].y}));
    speed = std::max({speed, length(Vector{now[0], now[1]}), length(values_[k])});
  }
  return speed > 0 ? change / speed / (mesh.time - time_) : 0;
}

}  // namespace pliant

// tests/mesh/nearest_boundary_test.cpp: the nearest point of the boundary against a search among samples of it.
#include "pliant/mesh/location/nearest_boundary.h"

#include <random>

#include "mesh/curved_samples.h"

using namespace pliant;

TEST_CASE("no sample of the boundary is nearer than the nearest place, which lies on it", "[mesh][property]") {
  const int degree = GENERATE(1, 2, 3, 5);
  int number = 0;
  for (const auto& sample : samples::sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, number++);
    const NearestBoundary nearest(mesh);
    std::vector<Point> on_boundary;
    std::vector<Point> polygon(static_cast<std::size_t>(degree) + 1);
    double widest = 0;  // distance of neighbouring samples
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!mesh.is_alive(triangle_of(h)) || mesh.twin(h) != none) continue;
      for (int k = 0; k <= 200; ++k) {
        Barycentric xi{};
        xi[static_cast<std::size_t>(edge_of(h))] = 1 - k / 200.0;
        xi[static_cast<std::size_t>((edge_of(h) + 1) % 3)] = k / 200.0;
        on_boundary.push_back(samples::image(mesh, triangle_of(h), xi));
        if (k > 0) widest = std::max(widest, distance(on_boundary.back(), on_boundary[on_boundary.size() - 2]));
      }
    }
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> part(-0.5, 1.5);
    const Box box = mesh.box();
    for (int k = 0; k < 40; ++k) {
      const double u = part(random), v = part(random);
      const Point p{box.low.x + u * (box.high.x - box.low.x), box.low.y + v * (box.high.y - box.low.y)};
      const NearestPlace found = nearest.find(p);
      double least = HUGE_VAL;
      for (const Point& q : on_boundary) least = std::min(least, distance(p, q));
      CHECK(found.distance <= least * (1 + 1e-12) + 1e-14 * mesh.size());
      CHECK(found.distance >= least - widest);
      const Point foot = samples::image(mesh, found.location.triangle, found.location.xi);
      CHECK(std::abs(distance(p, foot) - found.distance) < 1e-12 * mesh.size());
    }
    // A place on the boundary is its own foot.
    for (std::size_t k = 0; k < on_boundary.size(); k += 37)
      CHECK(nearest.find(on_boundary[k]).distance < 1e-12 * mesh.size());
  }
}

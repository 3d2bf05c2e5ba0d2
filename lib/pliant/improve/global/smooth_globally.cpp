// lib/pliant/improve/global/smooth_globally.cpp: untangles parts, then minimises, and moves the points with the fields.
#include "pliant/improve/global/smooth_globally.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/improve/global/free_points.h"
#include "pliant/improve/global/minimize_deformation.h"
#include "pliant/improve/global/wanted_shapes.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/refit/move_and_refit.h"

namespace pliant {
namespace {

constexpr int untangling_rounds = 20;      // rounds of minimising the smoothed energy, each with less smoothing
constexpr int rounds_when_valid = 3;       // further rounds once all is valid, while det F is small somewhere
constexpr double least_wanted = 0.02;      // det F is small below this
constexpr int untangling_iterations = 12;  // steps in each round
constexpr double least_smoothing = 1e-6;   // the smoothing e where the least det F is not negative
constexpr double smoothing_share = 0.2;    // the smoothing e over the least det F, where that is negative
constexpr double smoothing_decay = 0.5;    // from round to round e falls at least by this factor
constexpr int most_rings = 12;             // rings of elements around what is tangled

class GlobalSmoother {
 public:
  GlobalSmoother(Mesh& mesh, const GlobalSmoothOptions& options)
      : mesh_(mesh), options_(options), stamps_(index(mesh.triangle_slots()), 0) {}

  GlobalSmoothOutcome run() {
    std::vector<TriangleId> poor, bad;
    const auto judge = [&](TriangleId t) {
      if (!mesh_.is_alive(t)) return;
      FreePoints::Net net;
      mesh_.gather_points(t, net);
      const std::span<const Point> points{net.data(), index(mesh_.net_size())};
      const bool is_valid = certify_element(mesh_.boundary(), mesh_.degree(), points) == Validity::valid;
      if (!is_valid) bad.push_back(t);
      if (!is_valid || evenness(points) < options_.good) poor.push_back(t);
    };
    for (TriangleId t = 0; options_.only.empty() && t < mesh_.triangle_slots(); ++t) judge(t);
    for (const TriangleId t : options_.only) judge(t);
    const std::vector<TriangleId> elements = grow(poor, options_.rings);
    if (!elements.empty()) {
      FreePoints points(mesh_);
      untangle(points, bad);
      if (options_.vertices) improve(points, elements, true);
      improve(points, elements, false);
      apply(points);
    }
    mesh_.compact();
    GlobalSmoothOutcome outcome;
    const InvalidElements left = find_invalid(mesh_);
    outcome.invalid = left.invalid;
    outcome.invalid.insert(outcome.invalid.end(), left.degenerate.begin(), left.degenerate.end());
    std::sort(outcome.invalid.begin(), outcome.invalid.end());
    outcome.elements = elements;
    PassReport& report = outcome.report;
    report.add("not_good", static_cast<double>(poor.size()));
    report.add("elements_smoothed", static_cast<double>(elements.size()));
    report.add("points_moved", static_cast<double>(moved_));
    report.add("iterations", static_cast<double>(iterations_));
    report.add("energy_before", energy_before_);
    report.add("energy_after", energy_after_);
    report.add("invalid", static_cast<double>(outcome.invalid.size()));
    report.add("triangles", mesh_.triangle_count());
    return outcome;
  }

 private:
  /// A lower bound of the scaled Jacobian, from the coefficients of det J.
  double evenness(std::span<const Point> net) const {
    std::array<double, net_size(jacobian_degree(max_degree))> coefficients;
    const std::span<double> used{coefficients.data(), index(net_size(jacobian_degree(mesh_.degree())))};
    jacobian_net(mesh_.degree(), net, used);
    const auto [least, greatest] = std::minmax_element(used.begin(), used.end());
    return *least / *greatest;
  }

  /// These elements and so many rings around them, ascending.
  std::vector<TriangleId> grow(std::span<const TriangleId> seeds, int rings) {
    std::vector<TriangleId> all(seeds.begin(), seeds.end());
    const int stamp = ++stamp_;
    for (const TriangleId t : all) stamps_[index(t)] = stamp;
    Star star;
    for (std::size_t first = 0; rings > 0 && first < all.size(); --rings) {
      const std::size_t end = all.size();
      for (; first < end; ++first)
        for (int c = 0; c < 3; ++c) {
          find_star(mesh_, mesh_.corner(all[first], c), star);
          for (const HalfEdgeId h : star.outgoing)
            if (auto& s = stamps_[index(triangle_of(h))]; s != stamp) s = stamp, all.push_back(triangle_of(h));
        }
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// The parts of these elements that are connected over edges.
  std::vector<std::vector<TriangleId>> parts_of(std::span<const TriangleId> elements) {
    const int stamp = ++stamp_;
    for (const TriangleId t : elements) stamps_[index(t)] = stamp;
    std::vector<std::vector<TriangleId>> parts;
    for (const TriangleId seed : elements) {
      if (stamps_[index(seed)] != stamp) continue;
      std::vector<TriangleId>& part = parts.emplace_back(1, seed);
      stamps_[index(seed)] = 0;
      for (std::size_t k = 0; k < part.size(); ++k)
        for (int e = 0; e < 3; ++e) {
          const HalfEdgeId g = mesh_.twin(half_edge(part[k], e));
          if (g == none || stamps_[index(triangle_of(g))] != stamp) continue;
          stamps_[index(triangle_of(g))] = 0;
          part.push_back(triangle_of(g));
        }
      std::sort(part.begin(), part.end());
    }
    return parts;
  }

  void untangle(FreePoints& points, std::vector<TriangleId> bad) {
    for (int rings = options_.vertices ? 3 : 1; rings <= most_rings && !bad.empty(); rings *= 2) {
      for (const std::vector<TriangleId>& part : parts_of(grow(bad, rings))) untangle_part(points, part);
      std::erase_if(bad, [&](TriangleId t) { return points.is_valid(t); });
    }
  }

  /// The least coefficient of det F, which tells how far the worst element is inverted.
  double least_determinant(const FreePoints& points, std::span<const TriangleId> elements,
                           std::span<const WantedShape> wanted) const {
    double least = 1;
    std::array<double, net_size(jacobian_degree(max_degree))> coefficients;
    const std::span<double> used{coefficients.data(), index(net_size(jacobian_degree(mesh_.degree())))};
    FreePoints::Net net;
    for (std::size_t k = 0; k < elements.size(); ++k) {
      jacobian_net(mesh_.degree(), points.gather(elements[k], net), used);
      least = std::min(least, *std::min_element(used.begin(), used.end()) *
                                  (wanted[k].xx * wanted[k].yy - wanted[k].xy * wanted[k].yx));
    }
    return least;
  }

  /// Moves the points of a part so that fewer of its elements are invalid, or leaves them where they were.
  void untangle_part(FreePoints& points, std::span<const TriangleId> part) {
    const auto count_invalid = [&] {
      return std::count_if(part.begin(), part.end(), [&](TriangleId t) { return !points.is_valid(t); });
    };
    std::vector<std::pair<int, Point>> best;
    const auto remember = [&] {
      best.clear();
      for (const TriangleId t : part)
        for (const PointId p : mesh_.net(t)) best.emplace_back(points.slot(p), points.place(p));
    };
    remember();
    MinimizeOptions options;
    options.vertices = options_.vertices;
    options.max_iterations = untangling_iterations;
    options.direct = true;
    const std::vector<WantedShape> wanted = wanted_shapes(points, part, options_.vertices);
    auto left = count_invalid(), fewest = left;
    for (int round = 0, more = rounds_when_valid; round < untangling_rounds; ++round) {
      const double least = least_determinant(points, part, wanted);
      if (left == 0 && (least > least_wanted || more-- == 0)) break;
      const double rule = std::hypot(least_smoothing, smoothing_share * std::min(0.0, least));
      options.smoothing = round == 0 ? rule : std::min(rule, smoothing_decay * options.smoothing);
      minimize(points, part, wanted, options);
      left = count_invalid();
      if (left < fewest || left == 0) fewest = left, remember();
    }
    for (const auto& [slot, place] : best) points.coordinates(slot)[0] = place.x, points.coordinates(slot)[1] = place.y;
  }

  void improve(FreePoints& points, std::vector<TriangleId> elements, bool vertices) {
    std::erase_if(elements, [&](TriangleId t) { return !points.is_valid(t); });
    MinimizeOptions options;
    options.vertices = vertices;
    options.any_area = !vertices;
    const MinimizeOutcome outcome = minimize(points, elements, wanted_shapes(points, elements, vertices), options);
    energy_before_ = outcome.energy_before;
    energy_after_ = outcome.energy_after;
  }

  MinimizeOutcome minimize(FreePoints& points, std::span<const TriangleId> elements,
                           std::span<const WantedShape> wanted, const MinimizeOptions& options) {
    const MinimizeOutcome outcome = minimize_deformation(points, elements, wanted, options);
    iterations_ += outcome.iterations;
    if (options_.progress != nullptr) options_.progress->count(iterations_);
    return outcome;
  }

  /// Points that move together, since fields are refitted for all of them at once, and the elements that contain them.
  struct Group {
    std::vector<PointId> points;
    std::vector<TriangleId> elements;
  };

  /// Moves the points of the mesh. Where there are fields it does so group by group, so that fields are refitted where
  /// the elements are valid before and after.
  void apply(FreePoints& points) {
    const auto has_moved = [&](PointId p) { return !(points.place_in_mesh(p) == mesh_.point(p)); };
    for (PointId p = 0; p < mesh_.point_slots(); ++p) moved_ += has_moved(p);
    if (mesh_.width() == 2) {
      for (PointId p = 0; p < mesh_.point_slots(); ++p)
        if (has_moved(p)) mesh_.set_point(p, points.place_in_mesh(p));
      return;
    }
    std::vector<Group> todo(points.blocks().size());
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
      if (!mesh_.is_alive(t)) continue;
      int last = none;
      for (const PointId p : mesh_.net(t))
        if (const int b = points.block_of(p); b != none && b != last) todo[index(last = b)].elements.push_back(t);
    }
    for (std::size_t b = 0; b < todo.size(); ++b)
      for (int j = 0; j < points.blocks()[b].count; ++j)
        todo[b].points.push_back(points.point_in(points.blocks()[b].first + j));
    std::erase_if(todo, [&](const Group& g) { return std::none_of(g.points.begin(), g.points.end(), has_moved); });
    const auto move = [&](const Group& group) {
      for (const PointId p : group.points) mesh_.set_point(p, points.place_in_mesh(p));
    };
    for (std::size_t before = todo.size() + 1; todo.size() < before;) {
      before = todo.size();
      std::erase_if(todo, [&](const Group& group) {
        return move_and_refit(mesh_, group.elements, group.points, options_.refit, [&] { move(group); }) ==
               Outcome::done;
      });
    }
    for (const Group& group : todo) {  // groups that can move only together with others
      thread_local Patch patch;
      patch.capture(mesh_, group.elements);
      move(group);
      patch.fit_fields(mesh_, group.elements, group.points, options_.refit, false);
    }
  }

  Mesh& mesh_;
  const GlobalSmoothOptions& options_;
  std::vector<int> stamps_;
  int stamp_ = 0;
  double energy_before_ = 0, energy_after_ = 0;
  long moved_ = 0, iterations_ = 0;
};

}  // namespace

GlobalSmoothOutcome smooth_globally(Mesh& mesh, const GlobalSmoothOptions& options) {
  return GlobalSmoother(mesh, options).run();
}

}  // namespace pliant

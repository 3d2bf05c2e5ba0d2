// lib/pliant/improve/smoothing/smoothing_moves.cpp: ratings of elements; moves of edges and vertices, flips.
#include "pliant/improve/smoothing/smoothing_moves.h"

#include <algorithm>
#include <array>
#include <functional>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/flip_edge.h"

namespace pliant {
namespace {

constexpr int turns = 3;         // times that points which make room for each other are placed in turn
constexpr double content = 0.8;  // lower excesses count as this one: an element so good may become worse

/// Bounds under which every excess is 1 / share times what it is under these.
CurvatureBounds scaled(const CurvatureBounds& bounds, double share) {
  return {1 + share * (bounds.max_distortion - 1), share * bounds.max_peak, bounds.min_shape_ratio / share,
          share * bounds.max_turning, bounds.min_scaled_jacobian / share};
}

void sort_down(std::vector<double>& excesses) { std::sort(excesses.begin(), excesses.end(), std::greater<>()); }

/// By how much an excess must fall to count. For a tangled element the share is taken of what lies above
/// 0.99 tangled_excess.
double margin_of(double excess, double gain) {
  return gain * (excess < tangled_excess ? excess : excess - 0.99 * tangled_excess);
}

}  // namespace

bool is_worth_it(std::span<const double> now, std::span<const double> before, double gain) {
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (now[k] < before[k] - margin_of(before[k], gain)) return true;
    if (now[k] > before[k]) return false;
  }
  return false;
}

std::ptrdiff_t count_tangled(std::span<const double> excesses) {
  return std::count_if(excesses.begin(), excesses.end(), [](double e) { return e >= tangled_excess; });
}

SmoothingMoves::SmoothingMoves(Mesh& mesh, const SmoothOptions& options)
    : mesh_(mesh),
      options_(options),
      test_(mesh.degree(), options.bounds),
      content_test_(mesh.degree(), scaled(options.bounds, content)) {}

double SmoothingMoves::excess(TriangleId t) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  return test_.excess({net.data(), index(mesh_.net_size())});
}

double SmoothingMoves::movable_excess(TriangleId t) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  return test_.excess({net.data(), index(mesh_.net_size())}, fixed_edges(t));
}

unsigned SmoothingMoves::fixed_edges(TriangleId t) const {
  unsigned fixed = 0;
  for (int e = 0; e < 3; ++e)
    if (mesh_.is_constrained(half_edge(t, e))) fixed |= 1u << e;
  return fixed;
}

bool SmoothingMoves::is_fine(TriangleId t) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  return test_.is_fine({net.data(), index(mesh_.net_size())});
}

double SmoothingMoves::rating_of(std::size_t e) const {
  const auto net = trial_.net(e);
  const unsigned fixed = fixed_edges(trial_.element(e));
  return content_test_.is_surely_fine(net, fixed) ? content : std::max(content, test_.excess(net, fixed));
}

void SmoothingMoves::rate_each(std::vector<double>& excesses) const {
  excesses.clear();
  for (std::size_t e = 0; e < trial_.count(); ++e) excesses.push_back(rating_of(e));
}

void SmoothingMoves::rate(std::vector<double>& excesses) const {
  rate_each(excesses);
  sort_down(excesses);
}

/// Rates the elements on trial into now_. As soon as one is above `most`, returns false and measures no more.
bool SmoothingMoves::rate_up_to(double most) {
  now_.clear();
  for (std::size_t e = 0; e < trial_.count(); ++e) {
    now_.push_back(rating_of(e));
    if (now_.back() > most) return false;
  }
  sort_down(now_);
  return true;
}

SmoothingMoves::PatchQuality SmoothingMoves::quality_of(std::span<const TriangleId> elements) const {
  if (!floor_) return {};
  PatchQuality quality{least_quality(mesh_, elements), 0};
  for (const TriangleId t : elements) quality.invalid += certify_element(mesh_, t) != Validity::valid;
  return quality;
}

bool SmoothingMoves::keeps(const PatchQuality& now, const PatchQuality& before) const {
  return !floor_ || (now.invalid <= before.invalid && now.least.is_at_least(least_of(before.least, *floor_)));
}

/// Does the guard allow the elements on trial in place of what the mesh has? Requires that now_ has their ratings.
bool SmoothingMoves::keeps_quality() {
  if (!floor_) return true;
  const bool some_tangled = now_.front() >= tangled_excess;
  PatchQuality now;
  for (std::size_t e = 0; e < trial_.count(); ++e) {
    now.least = least_of(now.least, element_quality(mesh_.degree(), trial_.net(e)));
    now.invalid += some_tangled && certify_element(mesh_.boundary(), mesh_.degree(), trial_.net(e)) != Validity::valid;
  }
  if (!some_tangled && now.least.is_at_least(*floor_)) return true;
  on_trial_.clear();
  for (std::size_t e = 0; e < trial_.count(); ++e) on_trial_.push_back(trial_.element(e));
  return keeps(now, quality_of(on_trial_));
}

/// Tries each way on a copy of the elements' nets, until one makes all of them as good as `content`, and takes the best
/// way if it is better than what the mesh has. A way changes `trial_`, or returns false where it has nothing to offer.
template <class... Ways>
bool SmoothingMoves::take_best(double gain, std::span<const TriangleId> elements, const Ways&... ways) {
  trial_.capture(mesh_, elements);
  rate(before_);
  if (before_.front() <= 1) return false;
  is_tangled_ = before_.front() >= tangled_excess;
  best_ = before_;
  bool found = false;
  const auto attempt = [&](const auto& way) {
    if (best_.front() <= content) return;
    trial_.reset();
    if (!way() || !rate_up_to(best_.front())) return;
    if (count_tangled(now_) > count_tangled(before_) || !is_worth_it(now_, best_, found ? least_gain : gain)) return;
    if (!keeps_quality()) return;
    best_ = now_;
    best_nets_ = trial_.nets();
    found = true;
  };
  (attempt(ways), ...);
  Outcome outcome = Outcome::would_invert;
  if (found) {
    trial_.set_nets(best_nets_);
    outcome = trial_.apply(mesh_, options_.refit, best_.front() < tangled_excess);
  }
  if (outcome != Outcome::done) {
    ++refusals[describe(outcome)];
    return false;
  }
  touched_.insert(touched_.end(), elements.begin(), elements.end());
  return true;
}

/// Optimal placement of the points in turn. SmoothGoal::improve has nothing to offer where elements are tangled: tau
/// says nothing about them.
bool SmoothingMoves::place(std::span<const PointId> points, SmoothGoal goal, int rounds) {
  if (goal == SmoothGoal::improve && is_tangled_) return false;
  bool moved = false;
  for (int round = 0; round < rounds; ++round) moved = trial_.place(points, goal, options_.measure) || moved;
  return moved;
}

bool SmoothingMoves::smooth_edges(TriangleId t) {
  bool changed = smooth_all_edges(t, true);
  changed = smooth_interior(t) || changed;
  for (int e = 0; e < 3; ++e)
    if (is_free(half_edge(t, e))) changed = smooth_edge(half_edge(t, e)) || changed;
  return (movable_excess(t) > 1 && smooth_all_edges(t, false)) || changed;
}

bool SmoothingMoves::is_free(HalfEdgeId h) const {
  return mesh_.degree() > 1 && mesh_.twin(h) != none && !mesh_.is_constrained(h);
}

bool SmoothingMoves::smooth_edge(HalfEdgeId h) {
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh_.twin(h))};
  const EdgePoints edge = side_of(mesh_, h).points;
  const std::span<const PointId> points{edge.ids.data() + 1, index(mesh_.degree() - 1)};
  const auto straight = [&](double keep) {
    trial_.straighten(mesh_, h, keep);
    return true;
  };
  const bool changed = take_best(
      least_gain, pair, [&] { return straight(0.5); }, [&] { return straight(0); },
      [&] { return place(points, SmoothGoal::improve); }, [&] { return place(points, SmoothGoal::untangle); });
  edges_smoothed += changed;
  return changed;
}

/// Moves the element's free edges at once, since one at a time they may be in each other's way: straightened, which
/// costs little, or by optimal placement.
bool SmoothingMoves::smooth_all_edges(TriangleId t, bool straighten) {
  around_.assign(1, t);
  points_.clear();
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    if (!is_free(h)) continue;
    around_.push_back(triangle_of(mesh_.twin(h)));
    for (int k = 1; k < mesh_.degree(); ++k) points_.push_back(mesh_.edge_point(h, k));
  }
  if (points_.empty()) return false;
  const auto straight = [&](double keep) {
    for (int e = 0; e < 3; ++e)
      if (is_free(half_edge(t, e))) trial_.straighten(mesh_, half_edge(t, e), keep);
    return true;
  };
  const bool changed = straighten ? take_best(
                                        least_gain, around_, [&] { return straight(0.5); }, [&] { return straight(0); })
                                  : take_best(
                                        least_gain, around_, [&] { return place(points_, SmoothGoal::improve, turns); },
                                        [&] { return place(points_, SmoothGoal::untangle, turns); });
  edges_smoothed += changed;
  return changed;
}

bool SmoothingMoves::smooth_interior(TriangleId t) {
  if (mesh_.degree() <= 2) return false;
  const std::array<TriangleId, 1> one{t};
  const InnerPoints inner = inner_points(mesh_, t);
  const std::span<const PointId> points{inner.data(), index(interior_size(mesh_.degree()))};
  const auto blended = [&] {
    trial_.blend(mesh_, t);
    return true;
  };
  const bool changed = take_best(
      least_gain, one, blended, [&] { return place(points, SmoothGoal::improve); },
      [&] { return place(points, SmoothGoal::untangle); });
  edges_smoothed += changed;
  return changed;
}

bool SmoothingMoves::flip_edges(TriangleId t) {
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    if (mesh_.twin(h) == none || mesh_.is_constrained(h)) continue;
    const TriangleId u = triangle_of(mesh_.twin(h));
    const auto rate_pair = [&](std::vector<double>& excesses) {
      excesses = {std::max(content, movable_excess(t)), std::max(content, movable_excess(u))};
      sort_down(excesses);
    };
    rate_pair(before_);
    const std::array<TriangleId, 2> pair{t, u};
    const PatchQuality quality = quality_of(pair);
    Transaction trial(mesh_);
    const Outcome outcome = flip_edge(mesh_, h, options_.refit);
    if (outcome != Outcome::done) {
      ++refusals[describe(outcome)];
      continue;
    }
    rate_pair(now_);
    if (count_tangled(now_) > count_tangled(before_) || !is_worth_it(now_, before_)) continue;
    if (!keeps(quality_of(pair), quality)) continue;
    trial.commit();
    touched_.insert(touched_.end(), pair.begin(), pair.end());
    ++flips;
    return true;
  }
  return false;
}

bool SmoothingMoves::move_vertices(TriangleId t) {
  bool changed = false;
  for (int c = 0; c < 3; ++c) {
    const PointId v = mesh_.corner(t, c);
    const Point middle = 0.5 * (mesh_.point(mesh_.corner(t, (c + 1) % 3)) + mesh_.point(mesh_.corner(t, (c + 2) % 3)));
    if (!move_vertex(v, mesh_.point(v) - middle)) continue;
    changed = true;
    ++vertices_moved;
  }
  return changed;
}

/// The way from a vertex to the best place that it has in its straight star (star_).
Vector SmoothingMoves::shift_of(PointId v) {
  triangles_.clear();
  straight_.clear();
  for (const HalfEdgeId h : star_.outgoing)
    triangles_.push_back({mesh_.point(v), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.apex(h))});
  for (const auto& triangle : triangles_) straight_.push_back({triangle, 0});
  const Placement best = improve_point(1, straight_, mesh_.point(v));
  return is_finite(best.place) ? best.place - mesh_.point(v) : Vector{};
}

/// Moves a vertex, and the edges around it. `away` leads away from the opposite edge of the element that is visited:
/// there may be too little room beside that edge.
bool SmoothingMoves::move_vertex(PointId v, const Vector& away) {
  find_star(mesh_, v, star_);
  if (!star_.is_closed || is_on_curve(mesh_, star_)) return false;
  around_.clear();
  points_.assign(1, v);  // then the points of the edges around it
  for (const HalfEdgeId h : star_.outgoing) {
    around_.push_back(triangle_of(h));
    for (int k = 1; k < mesh_.degree(); ++k) points_.push_back(mesh_.edge_point(h, k));
  }
  const std::span<const PointId> all = points_, vertex = all.first(1), spokes = all.subspan(1);
  const Vector best = shift_of(v);
  const auto dragged = [&](const Vector& shift) {
    return [&, shift] {
      trial_.drag(v, shift);
      return shift != Vector{};
    };
  };
  const auto straightened = [&](const Vector& shift) {
    return [&, shift] {
      trial_.drag(v, shift);
      for (const HalfEdgeId h : star_.outgoing) trial_.straighten(mesh_, h, 0);
      return true;
    };
  };
  const auto dragged_and_placed = [&](const Vector& shift) {
    return [&, shift] {
      trial_.drag(v, shift);
      return place(spokes, SmoothGoal::improve);
    };
  };
  const auto placed = [&](std::span<const PointId> points, SmoothGoal goal, int rounds) {
    return [&, points, goal, rounds] { return place(points, goal, rounds); };
  };
  // The ways that cost much are tried where the others do not help.
  return take_best(least_long_gain, around_, dragged(best), dragged(0.5 * best), dragged(0.2 * best),
                   straightened(best), straightened(0.5 * best), straightened(0.2 * best), straightened(Vector{}),
                   dragged(0.1 * away), dragged(0.3 * away), straightened(0.1 * away), straightened(0.3 * away),
                   placed(vertex, SmoothGoal::improve, 1), placed(vertex, SmoothGoal::untangle, 1)) ||
         take_best(least_long_gain, around_, dragged_and_placed(0.1 * away), dragged_and_placed(-0.1 * away),
                   dragged_and_placed(0.3 * away), placed(all, SmoothGoal::untangle, turns),
                   placed(all, SmoothGoal::improve, turns));
}

}  // namespace pliant

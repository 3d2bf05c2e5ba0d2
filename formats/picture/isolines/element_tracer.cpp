// formats/picture/isolines/element_tracer.cpp: the isoline in one element (private to this room).
#include "formats/picture/isolines/element_tracer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "formats/picture/isolines/sign_changes.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

constexpr int most_halvings = 3;  // in one go; pieces that are not monotone then are traced as elements of their own
constexpr int flat_halvings = 6;  // where many pieces are not
constexpr std::size_t many = 12;  // around a point where the curve crosses itself there are fewer such pieces
constexpr int most_levels = 8, most_traces = 300;  // of pieces in pieces, and of pieces of one element in all
constexpr double noise = 1e-13;  // well above the rounding of subdivision; coefficients are about 1 at most
constexpr double cone = 0.3;     // least cosine between the direction of growth and the gradients of a piece

using Node = std::array<int, 2>;
using Corners = std::array<Barycentric, 3>;

/// The direction, of length 1, along which the polynomial grows in the whole triangle, if one is found.
std::optional<Vector> direction_of_growth(int degree, const std::vector<double>& net) {
  if (degree == 0) return {};
  std::vector<double> along_2(static_cast<std::size_t>(net_size(degree - 1))), along_3(along_2.size());
  differentiate_triangle(degree, net, along_2, along_3);
  Vector sum{};
  for (std::size_t k = 0; k < along_2.size(); ++k) sum += Vector{along_2[k], along_3[k]};
  const double size = length(sum);
  if (!(size > noise)) return {};
  const Vector direction = sum / size;
  for (std::size_t k = 0; k < along_2.size(); ++k) {
    const Vector gradient{along_2[k], along_3[k]};
    if (!(dot(gradient, direction) >= cone * length(gradient)) || !(dot(gradient, direction) > noise)) return {};
  }
  return direction;
}

class IsolineTracer {
 public:
  IsolineTracer(const ElementToTrace& element, double tolerance, std::size_t& crossing_count,
                std::vector<IsolineArc>& arcs)
      : element_(element), tolerance_(tolerance), crossing_count_(crossing_count), arcs_(arcs) {}

  /// `traces`: how many pieces have been traced before in the element that this one is a piece of.
  std::size_t trace(int level, int& traces) {
    const Corners whole{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const int halvings = halvings_needed(element_.field, 0);
    const bool flat = halvings == most_halvings && doubtful(element_.field, 0) > many;
    n_ = 1 << (flat ? flat_halvings : halvings);
    visit(whole, {Node{0, 0}, Node{n_, 0}, Node{0, n_}}, element_.field, 1);
    std::size_t uncertain = 0;
    for (const Doubtful& piece : doubtful_) {
      const bool is_small = size_of(piece.element.geometry) <= tolerance_ / 2;
      if (!is_small && doubtful_.size() <= many && level < most_levels && ++traces <= most_traces) {
        uncertain += IsolineTracer(piece.element, tolerance_, crossing_count_, arcs_).trace(level + 1, traces);
        continue;
      }
      for (std::size_t k = 0; k < piece.entries.size(); ++k) join_straight(piece.entries[k], piece.exits[k]);
      if (!is_small) ++uncertain;
    }
    return uncertain;
  }

 private:
  struct Crossing {
    double s;  ///< along the lattice edge, from its lesser node
    std::size_t id;
    Point place;
  };
  struct LocalCrossing {
    ArcEnd end;
    std::size_t id;
  };
  /// A piece in which the polynomial is not known to be monotone.
  struct Doubtful {
    ElementToTrace element;
    std::vector<LocalCrossing> entries, exits;  ///< those that go together if the piece is not looked into
  };

  static double size_of(const std::vector<double>& geometry) {
    Box box;
    for (std::size_t k = 0; k < geometry.size(); k += 2) box.extend({geometry[k], geometry[k + 1]});
    return box.size();
  }
  void join_straight(const LocalCrossing& from, const LocalCrossing& to) {
    IsolineArc arc{from.id, to.id, {}};
    if (!(from.end.place == to.end.place)) arc.curves.push_back({from.end.place, to.end.place});
    arcs_.push_back(std::move(arc));
  }
  static bool is_flat(const std::vector<double>& net) {
    const auto [low, high] = std::minmax_element(net.begin(), net.end());
    return *high - *low < 100 * noise;
  }
  /// How many pieces of the lattice with most_halvings the polynomial is not monotone in.
  std::size_t doubtful(const std::vector<double>& net, int depth) const {
    if (has_one_sign(net) || direction_of_growth(element_.field_degree, net)) return 0;
    if (depth == most_halvings) return 1;
    std::size_t sum = 0;
    for (int which = 0; which < 4; ++which) sum += doubtful(child_net(element_.field_degree, 1, net, which), depth + 1);
    return sum;
  }

  static Corners child(const Corners& c, int which) {
    const auto middle = [&](std::size_t a, std::size_t b) {
      Barycentric m{};
      for (std::size_t k = 0; k < 3; ++k) m[k] = (c[a][k] + c[b][k]) / 2;
      return m;
    };
    const Barycentric ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    return which == 0   ? Corners{c[0], ab, ca}
           : which == 1 ? Corners{ab, c[1], bc}
           : which == 2 ? Corners{ca, bc, c[2]}
                        : Corners{ab, bc, ca};
  }
  static std::vector<double> child_net(int degree, int width, const std::vector<double>& net, int which) {
    const Corners part = child({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, which);
    std::vector<double> result(net.size());
    sub_net(degree, width, net, part[0], part[1], part[2], result);
    return result;
  }

  int halvings_needed(const std::vector<double>& net, int depth) const {
    if (has_one_sign(net)) return 0;
    if (depth == most_halvings || is_flat(net) || direction_of_growth(element_.field_degree, net)) return depth;
    int most = depth + 1;
    for (int which = 0; which < 4 && most < most_halvings; ++which)
      most = std::max(most, halvings_needed(child_net(element_.field_degree, 1, net, which), depth + 1));
    return most;
  }

  /// Goes down to the lattice's triangles, past those that the isoline cannot meet.
  void visit(const Corners& corners, const std::array<Node, 3>& nodes, const std::vector<double>& net, int parts) {
    if (has_one_sign(net)) return;
    if (parts == n_) {
      leaf(corners, nodes, net);
      return;
    }
    const auto middle = [&](std::size_t a, std::size_t b) {
      return Node{(nodes[a][0] + nodes[b][0]) / 2, (nodes[a][1] + nodes[b][1]) / 2};
    };
    const Node ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    const std::array<std::array<Node, 3>, 4> parts_nodes{
        {{nodes[0], ab, ca}, {ab, nodes[1], bc}, {ca, bc, nodes[2]}, {ab, bc, ca}}};
    for (int which = 0; which < 4; ++which)
      visit(child(corners, which), parts_nodes[static_cast<std::size_t>(which)],
            child_net(element_.field_degree, 1, net, which), 2 * parts);
  }

  Barycentric xi_of(const Node& node) const {
    return {double(n_ - node[0] - node[1]) / n_, double(node[0]) / n_, double(node[1]) / n_};
  }
  /// The edge of the element that holds both nodes, and their steps along it from its first corner; or no edge (-1).
  int edge_with(const Node& a, const Node& b, int& step_a, int& step_b) const {
    const auto weights = [this](const Node& node) {
      return std::array<int, 3>{n_ - node[0] - node[1], node[0], node[1]};
    };
    const std::array<int, 3> wa = weights(a), wb = weights(b);
    for (std::size_t e = 0; e < 3; ++e)
      if (wa[(e + 2) % 3] == 0 && wb[(e + 2) % 3] == 0) {
        step_a = wa[(e + 1) % 3], step_b = wb[(e + 1) % 3];
        return static_cast<int>(e);
      }
    return -1;
  }

  /// Whether the polynomial counts as at least zero at a node. Along the element's edges the crossings decide, so that
  /// signs and crossings agree whatever rounding does.
  bool is_above(const Node& node) {
    int step = 0, same = 0;
    const int e = edge_with(node, node, step, same);
    if (e >= 0) {
      bool above = element_.above[static_cast<std::size_t>(e)];
      if (step == n_) return element_.above[static_cast<std::size_t>((e + 1) % 3)];
      for (const EdgeCrossing& crossing : element_.crossings[static_cast<std::size_t>(e)])
        if (crossing.s < double(step) / n_) above = !above;
      return above;
    }
    const auto [place, is_new] = above_.try_emplace(node, false);
    if (is_new) {
      double value = 0;
      evaluate_net(element_.field_degree, 1, element_.field, xi_of(node), {&value, 1});
      place->second = value >= 0;
    }
    return place->second;
  }

  /// The crossings of the lattice edge between two nodes, from the lesser to the greater.
  const std::vector<Crossing>& crossings(const Node& a, const Node& b, const std::vector<double>& coefficients) {
    const auto [place, is_new] = lattice_crossings_.try_emplace(std::pair(a, b));
    if (!is_new) return place->second;
    std::vector<Crossing>& result = place->second;
    int step_a = 0, step_b = 0;
    const int e = edge_with(a, b, step_a, step_b);
    if (e >= 0) {
      const auto [low, high] = std::minmax(step_a, step_b);
      for (const EdgeCrossing& crossing : element_.crossings[static_cast<std::size_t>(e)]) {
        const double s = crossing.s * n_ - low;
        if (s < 0 || (high < n_ && crossing.s >= double(high) / n_)) continue;
        result.push_back({step_a < step_b ? s : 1 - s, crossing.id, crossing.place});
      }
      if (step_b < step_a) std::reverse(result.begin(), result.end());
      return result;
    }
    for (const double s : sign_changes(coefficients, is_above(a), is_above(b))) {
      const Barycentric from = xi_of(a), to = xi_of(b);
      Barycentric xi{};
      for (std::size_t k = 0; k < 3; ++k) xi[k] = (1 - s) * from[k] + s * to[k];
      std::array<double, 2> at{};
      evaluate_net(element_.degree, 2, element_.geometry, xi, at);
      result.push_back({s, crossing_count_++, {at[0], at[1]}});
    }
    return result;
  }

  void leaf(const Corners& corners, const std::array<Node, 3>& nodes, const std::vector<double>& net) {
    // Around the piece, counter-clockwise: where the isoline enters (above zero comes before, below after) and leaves.
    const NetLayout& layout = NetLayout::of(element_.field_degree);
    constexpr std::array<Point, 3> local{{{0, 0}, {1, 0}, {0, 1}}};
    std::vector<LocalCrossing> entries, exits;
    std::array<std::vector<EdgeCrossing>, 3> on_edges;
    bool first_is_entry = true;
    bool above = is_above(nodes[0]);
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t next = (e + 1) % 3;
      const bool forward = nodes[e] < nodes[next];
      std::vector<double> along;
      for (int k = 0; k <= element_.field_degree; ++k)
        along.push_back(net[static_cast<std::size_t>(
            layout.edge_index(static_cast<int>(e), forward ? k : element_.field_degree - k))]);
      std::vector<Crossing> found = crossings(std::min(nodes[e], nodes[next]), std::max(nodes[e], nodes[next]), along);
      if (!forward) std::reverse(found.begin(), found.end());
      for (const Crossing& crossing : found) {
        const double s = std::clamp(forward ? crossing.s : 1 - crossing.s, 0.0, 1.0);
        if (entries.empty() && exits.empty()) first_is_entry = above;
        (above ? entries : exits).push_back({{(1 - s) * local[e] + s * local[next], crossing.place}, crossing.id});
        above = !above;
        on_edges[e].push_back({s, crossing.id, crossing.place});
      }
    }
    const std::optional<Vector> rise = direction_of_growth(element_.field_degree, net);
    // Without crossings there is no arc, and where the polynomial may turn back perhaps a closed curve.
    if (entries.size() != exits.size() || (entries.empty() && (rise || is_flat(net)))) return;
    MonotonePiece piece{element_.degree, std::vector<double>(element_.geometry.size()), element_.field_degree, net, {}};
    sub_net(element_.degree, 2, element_.geometry, corners[0], corners[1], corners[2], piece.geometry);
    if (rise) {
      piece.rise = *rise;
      // Arcs are graphs over the direction across the rise, one beside the other.
      const auto earlier = [&](const LocalCrossing& a, const LocalCrossing& b) {
        const Vector across{rise->y, -rise->x};
        return dot(across, a.end.local) < dot(across, b.end.local);
      };
      std::stable_sort(entries.begin(), entries.end(), earlier);
      std::stable_sort(exits.begin(), exits.end(), earlier);
      for (std::size_t k = 0; k < entries.size(); ++k) {
        IsolineArc arc{entries[k].id, exits[k].id, {}};
        draw_arc(piece, entries[k].end, exits[k].end, tolerance_, arc.curves);
        arcs_.push_back(std::move(arc));
      }
      return;
    }
    // Each entry goes with the exit that follows it, which leaves no arcs that cross.
    if (!first_is_entry) std::rotate(exits.begin(), exits.begin() + 1, exits.end());
    const ElementToTrace inner{element_.degree,
                               piece.geometry,
                               element_.field_degree,
                               net,
                               {is_above(nodes[0]), is_above(nodes[1]), is_above(nodes[2])},
                               on_edges};
    doubtful_.push_back({inner, entries, exits});
  }

  const ElementToTrace& element_;
  double tolerance_;
  std::size_t& crossing_count_;
  std::vector<IsolineArc>& arcs_;
  int n_ = 1;
  std::vector<Doubtful> doubtful_;
  std::map<Node, bool> above_;
  std::map<std::pair<Node, Node>, std::vector<Crossing>> lattice_crossings_;
};

}  // namespace

bool has_one_sign(const std::vector<double>& field) {
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  return *low > noise || *high < -noise;
}

std::size_t trace_element(const ElementToTrace& element, double tolerance, std::size_t& crossing_count,
                          std::vector<IsolineArc>& arcs) {
  int traces = 0;
  return IsolineTracer(element, tolerance, crossing_count, arcs).trace(0, traces);
}

}  // namespace pliant

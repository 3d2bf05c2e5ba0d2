// lib/pliant/generate/delaunay_segments.cpp: forces segments into the triangulation by flips (Sloan 1993).
#include <deque>

#include "pliant/generate/delaunay.h"
#include "pliant/geometry/predicates.h"

namespace pliant {

/// The half-edge from a to b, or -1.   Complexity O(degree of a)
int Delaunay::find_edge(int a, int b) const {
  const int start = leaving_[static_cast<std::size_t>(a)];
  if (start < 0) return -1;
  int h = start;
  do {
    if (target(h) == b) return h;
    h = twin(previous(h));
  } while (h != start);
  return -1;
}

void Delaunay::constrain(int h) {
  constrained_[static_cast<std::size_t>(h)] = 1;
  constrained_[static_cast<std::size_t>(twin(h))] = 1;
}

/// The half-edge opposite a in the triangle at a that the segment from a to b enters first.
int Delaunay::first_crossed(int a, int b) const {
  const Point &p = point(a), &q = point(b);
  const int start = leaving_[static_cast<std::size_t>(a)];
  int h = start;
  do {
    const int u = target(h), v = apex(h);
    if (u != infinite && orient2d(p, point(u), q) == 0 && dot(point(u) - p, q - p) > 0)
      refuse(a, b, "are joined by a segment through", u, -1);
    if (u != infinite && v != infinite && orient2d(p, point(u), q) > 0 && orient2d(p, point(v), q) < 0) return next(h);
    h = twin(previous(h));
  } while (h != start);
  refuse(a, b, "cannot be joined", -1, -1);
}

/// The edges that cross the segment from a to b, in their order from a on, each given from right to left.
std::vector<std::array<int, 2>> Delaunay::crossed_edges(int a, int b) const {
  std::vector<std::array<int, 2>> crossed;
  for (int h = first_crossed(a, b);;) {
    crossed.push_back({origin(h), target(h)});
    if (is_constrained(h)) refuse(a, b, "are joined by a segment that crosses the one from", origin(h), target(h));
    const int g = twin(h), w = apex(g);
    if (w == b) return crossed;
    const int side = orient2d(point(a), point(b), point(w));
    if (side == 0) refuse(a, b, "are joined by a segment through", w, -1);
    h = side > 0 ? next(g) : previous(g);  // g runs from the left of the segment to its right
  }
}

/// Is the quadrilateral of the edge's two triangles strictly convex?
bool Delaunay::is_flippable(int h) const {
  const int g = twin(h), c = apex(h), d = apex(g);
  if (c == infinite || d == infinite || origin(h) == infinite || target(h) == infinite) return false;
  return orient2d(point(d), point(target(h)), point(c)) > 0 && orient2d(point(c), point(origin(h)), point(d)) > 0;
}

/// Replaces an edge by the other diagonal of the quadrilateral around it. Its half-edges stay in their triangles'
/// slots.
void Delaunay::flip(int h) {
  const int g = twin(h);
  const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
  const auto mark = [this](int e) { return constrained_[static_cast<std::size_t>(e)]; };
  const int bc = twin(next(h)), ca = twin(previous(h)), ad = twin(next(g)), db = twin(previous(g));
  const int s = h / 3, t = g / 3;
  set_triangle(s, c, d, b);
  set_triangle(t, d, c, a);
  const auto join = [&](int inner, int outer) {
    link(inner, outer);
    constrained_[static_cast<std::size_t>(inner)] = mark(outer);
  };
  link(3 * s, 3 * t);
  constrained_[static_cast<std::size_t>(3 * s)] = constrained_[static_cast<std::size_t>(3 * t)] = 0;
  join(3 * s + 1, db);
  join(3 * s + 2, bc);
  join(3 * t + 1, ca);
  join(3 * t + 2, ad);
}

/// Flips these edges and those that flips disturb until all that are not constrained are locally Delaunay (Lawson).
void Delaunay::make_delaunay(std::vector<std::array<int, 2>> edges) {
  while (!edges.empty()) {
    const auto [u, v] = edges.back();
    edges.pop_back();
    const int h = find_edge(u, v);
    if (h < 0 || is_constrained(h) || !is_flippable(h)) continue;
    const int a = origin(h), b = target(h), c = apex(h), d = apex(twin(h));
    if (in_circle(point(a), point(b), point(c), point(d)) <= 0) continue;
    flip(h);
    edges.insert(edges.end(), {{b, c}, {c, a}, {a, d}, {d, b}});
  }
}

void Delaunay::insert_segment(int a, int b) {
  if (a == b || leaving_[static_cast<std::size_t>(a)] < 0) refuse(a, b, "make no segment", -1, -1);
  if (const int h = find_edge(a, b); h >= 0) return constrain(h);
  const std::vector<std::array<int, 2>> crossed = crossed_edges(a, b);
  std::deque<std::array<int, 2>> waiting(crossed.begin(), crossed.end());
  std::vector<std::array<int, 2>> made;
  while (!waiting.empty()) {
    const auto [u, v] = waiting.front();
    waiting.pop_front();
    const int h = find_edge(u, v);
    if (!is_flippable(h)) {
      waiting.push_back({u, v});
      continue;
    }
    const int c = apex(h), d = apex(twin(h));
    flip(h);
    const auto side = [&](int w) { return w == a || w == b ? 0 : orient2d(point(a), point(b), point(w)); };
    if (side(c) * side(d) < 0)
      waiting.push_back({c, d});
    else
      made.push_back({c, d});
  }
  constrain(find_edge(a, b));
  make_delaunay(std::move(made));
}

}  // namespace pliant

// formats/picture/isolines/element_tracer.h: the isoline in one element (private to this room).
#pragma once
#include <array>
#include <vector>

#include "formats/picture/isolines/arc.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// An arc between two numbered crossings.
struct IsolineArc {
  std::size_t from, to;
  std::vector<std::vector<Point>> curves;
};

/// Where the isoline crosses the boundary of an element: a parameter along one of its edges, from the edge's first
/// corner, and the number and place that the neighbour knows it by.
struct EdgeCrossing {
  double s;
  std::size_t id;
  Point place;
};

struct ElementToTrace {
  int degree;
  std::vector<double> geometry;  ///< x, y of each control point
  int field_degree;
  std::vector<double> field;  ///< coefficients less the value, so that the isoline is where they vanish
  std::array<bool, 3> above;  ///< whether the field counts as at least 0 at each corner
  std::array<std::vector<EdgeCrossing>, 3> crossings;  ///< of each edge, in ascending order
};

/// Appends the arcs in the element; `crossing_count` is the number that the next crossing inside gets. Around a point
/// where the curve crosses itself, pieces are halved until they are smaller than the tolerance. Returns in how many
/// pieces the arcs are not certain: where the field is flat along a whole line.
std::size_t trace_element(const ElementToTrace& element, double tolerance, std::size_t& crossing_count,
                          std::vector<IsolineArc>& arcs);

/// True if no coefficient is near zero or has another sign than the others, so that no isoline is in the element.
bool has_one_sign(const std::vector<double>& field);

}  // namespace pliant

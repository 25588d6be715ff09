// The best division of an outline into quads and triangles, no node inside.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "paver/options.h"
#include "repair/curved_element.h"

namespace paver {

/// Elements for an outline, with what they are worth.
struct Filling {
  double worst = -1;  ///< of the elements' values
  int triangles = 0;
  std::vector<Corners> elements;
};

/// Which elements may be made.
struct ElementKinds {
  bool quads = true, triangles = true;
};

inline ElementKinds kinds_of(Elements elements) {
  return {elements != Elements::all_triangle, elements != Elements::all_quad};
}

/// What a filling is worth against others of the same place: from `fair` on fewer triangles count.
double merit(double worst, int triangles);

constexpr int most_outline = 10;  ///< nodes: what is filled anew many times

/// As ElementJudge::value; need not be exact at `floor` and below.
using ElementValue = std::function<double(const Corners&, double floor)>;

/// `is_taken`: whether a side between two nodes is there already outside. Of at most `most_nodes` nodes,
/// counter-clockwise; nothing where no division has elements of positive value only.
Filling fill_outline(std::span<const int> outline, ElementKinds kinds, const ElementValue& value,
                     const std::function<bool(int, int)>& is_taken, std::size_t most_nodes = most_outline);

/// The same of sides that are nowhere else, by the judge's values.
Filling fill_outline(std::span<const int> outline, ElementKinds kinds, const ElementJudge& judge);

/// The same with a node inside: triangles and quads about it, by turns as few triangles as there may be.
Filling fill_about(int centre, std::span<const int> outline, ElementKinds kinds, const ElementValue& value);

}  // namespace paver

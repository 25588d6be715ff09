#include "sizing/parts/size_source.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double fewest_columns = 4.5;  // a circle gets five at least by its turn, a square of one interval a side four
constexpr double roundest = 1.5;        // the most by which distances from a round hole's middle differ
constexpr double ring_room = 0.3;       // of a hole's distance to other borders

}  // namespace

void start_where_rings_end(std::vector<SizeSource>& hole, std::size_t index, const NearestSegment& borders) {
  double columns = 0;
  Vec3 middle;
  for (const SizeSource& piece : hole) {
    columns += norm(piece.b - piece.a) / piece.value;
    middle += (1.0 / static_cast<double>(hole.size())) * piece.a;
  }
  if (columns < fewest_columns) return;
  double radius = 0, least = INFINITY;
  for (const SizeSource& piece : hole)
    radius = std::max(radius, norm(piece.a - middle)), least = std::min(least, norm(piece.a - middle));
  const double room = ring_room * borders.least_of_others(middle, INFINITY, index);
  if (!(radius > 0 && room < INFINITY) || radius > roundest * least) return;
  const double growth = 1 + 2 * M_PI / columns;
  double wider = 1;
  while (wider * growth * radius <= room) wider *= growth;
  if (wider < growth * growth) return;
  for (SizeSource& piece : hole) {
    for (Vec3* x : {&piece.a, &piece.b}) *x = middle + wider * (*x - middle);
    piece.value *= wider;
  }
}

}  // namespace paver

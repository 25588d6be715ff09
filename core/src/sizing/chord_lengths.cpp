// The distance falls with the square of the length at order 1, with its third power at least at order 2.
#include "sizing/chord_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/listed.h"

namespace paver {
namespace {

constexpr int most_rounds = 12;
constexpr double margin = 0.9;        // of the length that would just do for a face
constexpr double place_margin = 0.8;  // about a place, where lengths grow
constexpr double least_share = 0.25;  // of a length, from round to round
constexpr double no_help = 0.9;       // of the distance before: a face that is farther off got no nearer
constexpr double firm_share = 0.7;    // of the length where that did not help
constexpr int most_stalls = 5;        // rounds that do not help until a face is given up
constexpr double spread = 2;          // places of elements that get shorter with one: lengths grow from it
constexpr double steps_per_half = 3;
constexpr std::size_t most_named = 5;

/// Its sides and, of a quad, the lines between their middles: no point of it is farther than a quarter of a side from
/// them.
void add_sources(const FarPlace& place, double length, std::vector<SizeSource>& sources) {
  if (place.corners == 2) return sources.push_back({place.x[0], place.x[1], length});
  const auto n = static_cast<std::size_t>(place.corners);
  auto middle = [&](std::size_t k) { return 0.5 * (place.x[k % n] + place.x[(k + 1) % n]); };
  for (std::size_t k = 0; k < n; ++k) sources.push_back({place.x[k], place.x[(k + 1) % n], length});
  for (std::size_t k = 0; n == 4 && k < 2; ++k) sources.push_back({middle(k), middle(k + 2), length});
}

/// The next of few lengths: neighbours are to have the same.
double step_below(double length, double most) {
  return most * std::pow(2, -std::ceil(steps_per_half * std::log2(most / length)) / steps_per_half);
}

double square(double x) { return x * x; }

double longest_side(const FarPlace& place) {
  const auto n = static_cast<std::size_t>(place.corners);
  double longest = 0;
  for (std::size_t k = 0; k < n; ++k) longest = std::max(longest, norm(place.x[(k + 1) % n] - place.x[k]));
  return longest;
}

}  // namespace

/// Of a length: what would just do, times `less`.
double ChordLengths::share(double distance, double less) const {
  return less * std::pow(most_ / distance, order_ == 1 ? 1.0 / 2 : 1.0 / 3);
}

ShorterLengths ChordLengths::next(const std::vector<FaceReport>& faces, const std::vector<double>& length,
                                  const std::vector<FarPlace>& far) {
  last_.resize(faces.size(), INFINITY);
  stalls_.resize(faces.size(), 0);
  ShorterLengths lengths;
  if (rounds_++ == most_rounds) return lengths;
  std::vector<std::vector<const FarPlace*>> places(faces.size());
  for (const FarPlace& place : far) places[place.face].push_back(&place);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double off = faces[f].distance.largest;
    if (faces[f].status != FaceStatus::meshed || off <= most_) continue;
    const bool has_stalled = off > no_help * last_[f];
    stalls_[f] = has_stalled ? stalls_[f] + 1 : 0;
    last_[f] = std::min(off, last_[f]);
    if (stalls_[f] >= most_stalls) continue;
    const auto all = static_cast<double>(faces[f].quads + faces[f].triangles);
    const double whole = std::clamp(share(off, margin), least_share, has_stalled ? firm_share : margin);
    std::vector<SizeSource> sources;
    double more = 0;  // elements, where these are made shorter
    for (const FarPlace* place : places[f]) {
      const double wanted = share(place->distance, place_margin) * std::pow(firm_share, stalls_[f]);
      const double target = std::min(place->target, longest_side(*place));
      const double shorter = step_below(std::max(wanted, least_share) * target, length[f]);
      if (shorter >= place->target) continue;
      add_sources(*place, shorter, sources);
      more += spread * (square(place->target / shorter) - 1);
    }
    if (more > 0 && more < all * (1 / square(whole) - 1)) {
      lengths.places.insert(lengths.places.end(), sources.begin(), sources.end());
      continue;
    }
    const std::string part = faces[f].name.substr(0, faces[f].name.find(' '));  // of common faces the first
    lengths.faces.push_back({part, whole * length[f]});
  }
  return lengths;
}

std::string ChordLengths::note(const std::vector<FaceReport>& faces) const {
  std::vector<std::string> names;
  double most = 0;
  for (const FaceReport& face : faces) {
    if (face.status != FaceStatus::meshed || face.distance.largest <= most_) continue;
    names.push_back(face.name);
    most = std::max(most, face.distance.largest);
  }
  if (names.empty()) return {};
  return fmt::format(
      "{} {} up to {:.3g} mm from the surface, above chord_error {:.3g} mm, after {} meshes with ever shorter lengths.",
      listed(names, most_named), names.size() == 1 ? "is" : "are", most, most_, rounds_);
}

}  // namespace paver

// The distance falls with the square of the length at order 1, with its third power at least at order 2.
#include "sizing/chord_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/listed.h"

namespace paver {
namespace {

constexpr int most_rounds = 8;
constexpr double margin = 0.9;        // of the length that would just do
constexpr double least_share = 0.25;  // of a length, from round to round
constexpr double no_help = 0.9;       // of the distance before: a face that is farther off got no nearer
constexpr double firm_share = 0.7;    // of the length where that did not help
constexpr int most_stalls = 3;        // rounds that do not help until a face is given up
constexpr std::size_t most_named = 5;

}  // namespace

std::vector<LocalSize> ChordLengths::next(const std::vector<FaceReport>& faces, const std::vector<double>& length) {
  last_.resize(faces.size(), INFINITY);
  stalls_.resize(faces.size(), 0);
  std::vector<LocalSize> lengths;
  if (rounds_++ == most_rounds) return lengths;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double off = faces[f].distance.largest;
    if (faces[f].status != FaceStatus::meshed || off <= most_) continue;
    const bool has_stalled = off > no_help * last_[f];
    stalls_[f] = has_stalled ? stalls_[f] + 1 : 0;
    if (stalls_[f] == most_stalls) continue;
    last_[f] = std::min(off, last_[f]);
    double share = margin * std::pow(most_ / off, order_ == 1 ? 1.0 / 2 : 1.0 / 3);
    if (has_stalled) share = std::min(share, firm_share);
    const std::string part = faces[f].name.substr(0, faces[f].name.find(' '));  // of common faces the first
    lengths.push_back({part, std::clamp(share, least_share, margin) * length[f]});
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

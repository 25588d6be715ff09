// How sides on B-rep edges leave their chords, for sides inside faces that run beside them.
#pragma once

#include <cmath>
#include <unordered_map>
#include <vector>

#include "curving/near_surface.h"

namespace paver {

/// A side inside that runs beside one on an edge, nearer to it than this one bulges, would cross it with its middle
/// over that of its chord.
class EdgeBulges {
 public:
  /// A side on an edge, between nodes of the boundary stage, with its middle.
  void add(int a, Vec3 xa, int b, Vec3 xb, Vec3 middle);
  /// For a side inside: its middle leaves that of its chord as sides on edges do that begin at one of its ends, weighed
  /// by how near to the other one they end; nothing from half its length on. The diagonal of a quad between two edges
  /// has room on both sides wherever the mean of the quad's widths at its ends is more than twice what the two bulges
  /// differ by.
  Beside beside(const SideEnd& a, const SideEnd& b) const;

 private:
  struct Bulge {
    int end;
    Vec3 at, by;
  };
  /// Those from one end of a side, as one.
  struct Mean {
    double share = 0;         ///< 1 where it ends at the other end of the side, 0 where it ends far from that
    Vec3 off, by;             ///< from there to its end; its bulge
    double width = INFINITY;  ///< length of `off`
  };
  Mean mean_from(const SideEnd& from, const SideEnd& to) const;

  std::unordered_map<int, std::vector<Bulge>> from_;
};

}  // namespace paver

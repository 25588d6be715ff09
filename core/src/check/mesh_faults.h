// What is wrong with the mesh of a face, found out by looking at the mesh as it is.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "paver/ranks.h"
#include "paver/vec.h"

namespace paver {

/// The gravest first: a face is reported by the first that it has.
enum class FaultKind {
  folded,        ///< Jacobian not proven positive
  turned,        ///< element against the face's normal
  same_element,  ///< two elements with the same corners
  overlap,       ///< element that lies on one of another face beside it
  side,          ///< mesh edge inside the face that is not in two elements that run opposite
  boundary,      ///< mesh edge on the face's boundary that its elements leave out, or use once too often
  shared,        ///< mesh edge with elements of more faces than meet there
  off_edge,      ///< node that is not on its B-rep edge
  off_surface,   ///< node that is not on the face
  chord,         ///< side or centre farther from the face than chords may be
  area,          ///< elements do not cover the face
};

/// Faults of faces, counted. Any number of these brought together give the same, in any order.
class MeshFaults {
 public:
  void add(int face, FaultKind kind, Vec3 where) { add({face, kind}, {1, where}); }
  void add(const MeshFaults& other);
  /// Collective: those of all ranks, on all.
  void unite(Ranks& ranks);

  bool empty() const { return entries_.empty(); }
  /// Those that have a fault, rising.
  std::vector<int> faces() const;
  /// Of all kinds together.
  long count(int face) const;
  long count(int face, FaultKind kind) const;
  /// A place of the gravest fault of a face that has one: of several the first in the order x, y, z.
  Vec3 where(int face) const { return gravest(face).second.where; }
  /// What is wrong with such a face and what to do, one sentence without a full stop.
  std::string reason(int face) const;

 private:
  using Key = std::pair<int, FaultKind>;
  struct Entry {
    long count = 0;
    Vec3 where;
  };
  using Entries = std::map<Key, Entry>;

  void add(Key key, const Entry& entry);
  const Entries::value_type& gravest(int face) const { return *entries_.lower_bound({face, FaultKind::folded}); }

  Entries entries_;
};

}  // namespace paver

// The edges of a face as points along them, and what lies nearest on them.
#pragma once

#include <cmath>
#include <vector>

#include "base/boxes/box_tree.h"
#include "sizing/merging/model_edits.h"

namespace paver {

/// An edge as its face walks it.
struct Bank {
  int edge = -1;
  bool is_reversed = false;
  const ParameterCurve* image = nullptr;
  int before = -1, after = -1;  // in the loop
  std::vector<double> t;        // rising, as the points
  std::vector<Vec3> points;
  double bulge = 0;  // mm, of the edge beside the lines between them
  bool is_straight() const { return points.size() <= 2; }
};

/// On a bank.
struct BankFoot {
  double distance = INFINITY, t = 0;
  double before = 0, behind = 0;  // mm, of the edge
};

class FaceBanks {
 public:
  FaceBanks(const ModelEdits& edits, int face);

  int size() const { return static_cast<int>(banks_.size()); }
  const Bank& operator[](int b) const { return banks_[b]; }
  const Surface& surface() const { return *face_.surface; }
  const Edge& edge(const Bank& bank) const { return edits_.edge(bank.edge); }
  /// Numbers of banks that come into a box, by the lines between their points, rising.
  std::vector<int> meeting(const Box& box) const;
  /// Of a line between two points, with the edge.
  static Box box_of(const Bank& bank, std::size_t line);
  /// Whether they have a vertex in common.
  bool meet(const Bank& one, const Bank& two) const;
  BankFoot foot_on(const Bank& bank, Vec3 x) const;
  /// Left of the bank at a parameter.
  Vec3 inward(const Bank& bank, double t) const;

 private:
  void add(const Loop& loop);

  const ModelEdits& edits_;
  const Face& face_;
  std::vector<Bank> banks_;
  std::vector<int> bank_of_;  // per line
  BoxTree tree_;
};

}  // namespace paver

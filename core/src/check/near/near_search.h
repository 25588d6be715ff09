// Pairs of elements near each other, in places where elements differ: what differs is up to the kind of search.
//
// Steps: the elements in large cells of space, of all ranks; on with those in cells that hold different ones, in cells
// a quarter as large, down to the elements' own size; pairs of elements in one cell of that size. Each cell is looked
// at by one rank.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <span>
#include <tuple>
#include <vector>

#include "base/boxes/box_pairs.h"
#include "base/tasks/gather.h"
#include "base/tasks/tasks.h"
#include "check/near/cell_table.h"
#include "check/near/mesh_pieces.h"
#include "paver/ranks.h"

namespace paver {

/// When a pair comes up in a search, the same on any number of ranks and threads.
struct PairOrder {
  int step = 0;
  CellPlace cell{};
  long number = 0;
  auto operator<=>(const PairOrder&) const = default;
};

/// `Kind` has
/// - Summary, trivially copyable, of the elements in a cell, with add(const Summary&) in any order,
/// - bool is_wanted(std::size_t element) and Summary summary(const Piece&) const,
/// - Box box(const Piece&) const: what is near, no smaller than the piece,
/// - bool is_mixed(const Summary&) const: whether there are pairs to look at. True of a cell where it is of a part.
///
/// Runs on the threads of the calling arena.
template <class Kind>
class NearSearch {
 public:
  /// References are kept.
  NearSearch(const Kind& kind, const MeshPieces& pieces, Ranks& ranks) : kind_(kind), pieces_(pieces), ranks_(ranks) {}

  /// Collective. compare(found, a, b, order) for pairs whose boxes meet, each on one rank; `found` starts empty for
  /// each stretch of these, and found.add(other) puts two together.
  template <class Found, class Compare>
  Found run(Compare compare) {
    constexpr int first_step = 2;  // doublings of the longest element
    Found found;
    if (!(pieces_.longest() > 0)) return found;
    start();
    for (int power = std::ilogb(pieces_.longest()) + 1 + first_step; is_any_left(); power -= per_step, ++step_) {
      side_ = std::ldexp(1.0, power);
      is_last_ = side_ <= least_share * pieces_.largest_coordinate();
      find_mixed();
      choose();
      deal();
      found.add(compare_pairs<Found>(compare));
    }
    return found;
  }

 private:
  using Summary = typename Kind::Summary;
  static constexpr int per_step = 2;               // halvings
  static constexpr double least_share = 1e-8;      // of the largest coordinate: cells are counted in int
  static constexpr std::size_t stretch = 1 << 14;  // elements
  static constexpr std::size_t cells_stretch = 64;

  struct Content {
    Summary summary;
    bool has_own = false;  ///< elements of the cells' size
    bool is_open = false;  ///< mixed
  };
  struct SharedCell {
    CellPlace place;
    Content content;
  };
  /// An element in a cell.
  struct Entry {
    CellPlace cell;
    int piece = 0;  ///< here, or ~ its place among those received
  };
  struct SharedPiece {
    CellPlace cell;
    Piece piece;
  };

  Cells cells() const { return Cells(side_); }
  bool is_own(const Box& box) const {
    const Vec3 size = box.high - box.low;
    return is_last_ || std::max({size.x, size.y, size.z}) > std::ldexp(side_, -per_step);
  }

  void start() {
    for (std::size_t i = 0; i < pieces_.count(); ++i)
      if (kind_.is_wanted(i)) left_.push_back(static_cast<int>(i));
  }

  bool is_any_left() {
    long count = static_cast<long>(left_.size());
    ranks_.add_up({&count, 1});
    return count > 0;
  }

  static std::size_t stretches(std::size_t count, std::size_t most) { return (count + most - 1) / most; }

  void find_mixed() {
    std::vector<CellTable<Content>> tables(stretches(left_.size(), stretch));
    run_stretches(left_.size(), stretch, [&](std::size_t begin, std::size_t end) {
      CellTable<Content>& table = tables[begin / stretch];
      for (std::size_t i = begin; i < end; ++i) {
        const Piece piece = pieces_.piece(left_[i]);
        const Box box = kind_.box(piece);
        const Summary summary = kind_.summary(piece);
        cells().visit(box, [&](const CellPlace& place) { add({summary, is_own(box)}, table.at(place)); });
      }
    });
    table_ = {};
    for (CellTable<Content>& some : tables) {
      for (const auto& [place, content] : some.map()) add(content, table_.at(place));
      some = {};
    }
    if (ranks_.count() > 1) return settle();
    for (auto& [place, content] : table_.map()) content.is_open = kind_.is_mixed(content.summary);
  }

  static void add(const Content& more, Content& content) {
    content.summary.add(more.summary);
    content.has_own = content.has_own || more.has_own;
  }

  int owner(const CellPlace& place) const {
    return static_cast<int>(CellHash()(place) / 64 % static_cast<std::size_t>(ranks_.count()));
  }

  // Each cell's owner hears of what the ranks have in it, and tells them.
  void settle() {
    const auto count = static_cast<std::size_t>(ranks_.count());
    std::vector<std::vector<SharedCell>> mine(count);
    for (const auto& [place, content] : table_.map()) mine[owner(place)].push_back({place, content});
    std::vector<std::vector<SharedCell>> theirs = exchange_all(mine, ranks_);
    CellTable<Content> owned;
    for (const auto& some : theirs)
      for (const auto& [place, content] : some) add(content, owned.at(place));
    for (auto& [place, content] : owned.map()) content.is_open = kind_.is_mixed(content.summary);
    for (auto& some : theirs)
      for (auto& [place, content] : some) content = owned.at(place);
    for (const auto& some : exchange_all(theirs, ranks_))
      for (const auto& [place, content] : some) table_.at(place) = content;
  }

  // Entries of what lies in mixed cells beside elements of the cells' size; on with what is smaller.
  void choose() {
    const std::size_t count = stretches(left_.size(), stretch);
    std::vector<std::vector<Entry>> entries(count);
    std::vector<std::vector<int>> smaller(count);
    run_stretches(left_.size(), stretch, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Box box = kind_.box(pieces_.piece(left_[i]));
        bool is_open = false;
        cells().visit(box, [&](const CellPlace& place) {
          const Content& content = *table_.find(place);
          if (!content.is_open) return;
          is_open = true;
          if (content.has_own) entries[begin / stretch].push_back({place, left_[i]});
        });
        if (is_open && !is_own(box)) smaller[begin / stretch].push_back(left_[i]);
      }
    });
    table_ = {};
    entries_.clear();
    left_.clear();
    for (const std::vector<Entry>& some : entries) entries_.insert(entries_.end(), some.begin(), some.end());
    for (const std::vector<int>& some : smaller) left_.insert(left_.end(), some.begin(), some.end());
  }

  // Entries go to the owners of their cells.
  void deal() {
    received_.clear();
    std::vector<SharedPiece> of_others;
    std::erase_if(entries_, [&](const Entry& entry) {
      const bool is_of_other = owner(entry.cell) != ranks_.rank();
      if (is_of_other) of_others.push_back({entry.cell, pieces_.piece(entry.piece)});
      return is_of_other;
    });
    auto owner_of = [&](const SharedPiece& shared) { return owner(shared.cell); };
    for (const auto& [cell, piece] : paver::deal(of_others, ranks_, owner_of)) {
      entries_.push_back({cell, ~static_cast<int>(received_.size())});
      received_.push_back(piece);
    }
    std::ranges::sort(entries_, {}, [](const Entry& entry) { return std::tuple(entry.cell, entry.piece); });
  }

  template <class Found, class Compare>
  Found compare_pairs(Compare compare) const {
    std::vector<std::size_t> firsts;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (i == 0 || entries_[i].cell != entries_[i - 1].cell) firsts.push_back(i);
    firsts.push_back(entries_.size());
    std::vector<Found> found(stretches(firsts.size() - 1, cells_stretch));
    run_stretches(firsts.size() - 1, cells_stretch, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        compare_within({&entries_[firsts[i]], firsts[i + 1] - firsts[i]}, found[begin / cells_stretch], compare);
    });
    Found all;
    for (const Found& some : found) all.add(some);
    return all;
  }

  // In an order that does not depend on ranks. A pair belongs to the cell that holds the lowest corner of what the two
  // boxes have in common.
  template <class Found, class Compare>
  void compare_within(std::span<const Entry> entries, Found& found, Compare compare) const {
    std::vector<Piece> pieces;
    for (const Entry& entry : entries)
      pieces.push_back(entry.piece >= 0 ? pieces_.piece(entry.piece) : received_[~entry.piece]);
    std::ranges::sort(pieces, {}, &Piece::key);
    auto is_same = [](const Piece& a, const Piece& b) { return a.key() == b.key(); };
    pieces.erase(std::unique(pieces.begin(), pieces.end(), is_same), pieces.end());
    std::vector<Box> boxes;
    for (const Piece& piece : pieces) boxes.push_back(kind_.box(piece));
    PairOrder order{step_, entries[0].cell};
    for_meeting(boxes, [&](int i, int j) {
      ++order.number;
      const Vec3 a = boxes[i].low, b = boxes[j].low;
      const bool is_here = cells().at({std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}) == order.cell;
      if (is_here && (is_own(boxes[i]) || is_own(boxes[j]))) compare(found, pieces[i], pieces[j], order);
      return true;
    });
  }

  const Kind& kind_;
  const MeshPieces& pieces_;
  Ranks& ranks_;
  double side_ = 0;
  bool is_last_ = false;
  int step_ = 0;
  std::vector<int> left_;
  CellTable<Content> table_;
  std::vector<Entry> entries_;
  std::vector<Piece> received_;
};

}  // namespace paver

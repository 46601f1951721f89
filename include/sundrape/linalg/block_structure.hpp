#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sundrape {

/// Where the 3×3 blocks of a structurally symmetric matrix stand: the lower triangle by block rows, diagonal last in
/// each.
///
/// Row i holds the columns column[row_start[i]] … column[row_start[i+1] − 1], ascending, the last one being i itself.
/// Read as columns it is the upper triangle by block columns, which is what CHOLMOD wants.
struct BlockStructure {
  std::vector<std::int64_t> row_start;  // size() + 1 entries
  std::vector<std::int32_t> column;     // one per stored block

  [[nodiscard]] int size() const { return static_cast<int>(row_start.size()) - 1; }  // block rows
  [[nodiscard]] std::int64_t blocks() const { return row_start.back(); }             // stored blocks, diagonal included
  [[nodiscard]] std::int64_t diagonal(int row) const { return row_start[static_cast<std::size_t>(row) + 1] - 1; }

  /// Index of block (row, column) with column ≤ row; −1 where the structure has none.
  [[nodiscard]] std::int64_t find(int row, int column) const;
};

/// The lower triangle by block columns: the stored blocks below each diagonal block, rows ascending.
struct BlockColumns {
  std::vector<std::int64_t> start;  // size() + 1 entries
  std::vector<std::int64_t> block;  // stored block, one per off-diagonal block
  std::vector<std::int32_t> row;    // its block row

  BlockColumns() = default;
  explicit BlockColumns(const BlockStructure& structure);
};

/// Where an element's block goes: a stored block, and whether it lands there transposed. Blocks of points that are not
/// unknowns go to the matrix's scratch block, so that assembly needs no branch.
struct Slot {
  std::int32_t block = 0;
  bool transposed = false;
};

/// The slots of one force term: element e of n points has the n(n+1)/2 slots of its pairs (p, q), p ≤ q.
struct SlotTable {
  int points_per_element = 0;
  std::vector<Slot> slots;

  [[nodiscard]] static constexpr std::size_t pairs(int points) {
    return static_cast<std::size_t>(points * (points + 1) / 2);
  }
  [[nodiscard]] const Slot& at(std::size_t element, int p, int q) const {  // requires p ≤ q
    return slots[element * pairs(points_per_element) + pairs(q) + static_cast<std::size_t>(p)];
  }
};

/// Collects the couplings that force terms declare and turns them into a structure and one slot table a term.
class Pattern {
 public:
  /// @param unknown_of_point  block row of each point, −1 for points that are no unknowns (fixed or moved)
  /// @throws std::invalid_argument  an entry below −1
  explicit Pattern(std::vector<int> unknown_of_point);

  /// The elements declared from here on belong to the next term and have `points_per_element` points each.
  /// @throws std::invalid_argument  less than one point
  void begin_term(int points_per_element);
  /// All points of one element couple with each other. A point that an element does not use may be −1.
  /// @throws std::invalid_argument  no term begun, wrong number of points, no such point, or one unknown twice
  void add_element(std::span<const int> points);

  struct Built {
    BlockStructure structure;
    std::vector<SlotTable> tables;  // one a term, in the order of begin_term
  };
  /// The union of all terms' couplings, and every diagonal block.
  [[nodiscard]] Built build() const;

 private:
  struct Term {
    int points_per_element;
    std::vector<int> unknowns;  // points_per_element each element
  };
  [[nodiscard]] BlockStructure structure() const;
  [[nodiscard]] SlotTable slots(const Term& term, const BlockStructure& structure) const;

  std::vector<int> unknown_of_point_;
  std::vector<Term> terms_;
};

}  // namespace sundrape

#include "sundrape/linalg/block_structure.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace sundrape {
namespace {

std::size_t pairs(int points) { return static_cast<std::size_t>(points) * (static_cast<std::size_t>(points) + 1) / 2; }

}  // namespace

std::int64_t BlockStructure::find(int row, int column_wanted) const {
  const auto first = column.begin() + row_start[static_cast<std::size_t>(row)];
  const auto last = column.begin() + row_start[static_cast<std::size_t>(row) + 1];
  const auto found = std::lower_bound(first, last, column_wanted);
  return found != last && *found == column_wanted ? found - column.begin() : -1;
}

BlockColumns::BlockColumns(const BlockStructure& structure) : start(static_cast<std::size_t>(structure.size()) + 1, 0) {
  const auto each_block_below_a_diagonal = [&](const auto& visit) {
    for (int i = 0; i < structure.size(); ++i)
      for (auto k = structure.row_start[static_cast<std::size_t>(i)]; k < structure.diagonal(i); ++k)
        visit(i, k, static_cast<std::size_t>(structure.column[static_cast<std::size_t>(k)]));
  };
  each_block_below_a_diagonal([&](int, std::int64_t, std::size_t j) { ++start[j + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());

  block.resize(static_cast<std::size_t>(start.back()));
  row.resize(block.size());
  auto next = start;
  each_block_below_a_diagonal([&](int i, std::int64_t k, std::size_t j) {
    const auto place = static_cast<std::size_t>(next[j]++);
    block[place] = k;
    row[place] = i;
  });
}

Pattern::Pattern(std::vector<int> unknown_of_point) : unknown_of_point_(std::move(unknown_of_point)) {
  if (std::ranges::any_of(unknown_of_point_, [](int unknown) { return unknown < -1; }))
    throw std::invalid_argument("the unknown of a point is its block row, or -1");
}

void Pattern::begin_term(int points_per_element) {
  if (points_per_element < 1) throw std::invalid_argument("the elements of a term have at least one point");
  terms_.push_back({points_per_element, {}});
}

void Pattern::add_element(std::span<const int> points) {
  if (terms_.empty()) throw std::invalid_argument("an element was declared before its term");
  auto& term = terms_.back();
  if (points.size() != static_cast<std::size_t>(term.points_per_element))
    throw std::invalid_argument("an element has another number of points than its term said");
  if (std::ranges::any_of(points, [&](int p) { return p < -1 || p >= std::ssize(unknown_of_point_); }))
    throw std::invalid_argument("an element names a point that does not exist");

  const auto first = static_cast<std::ptrdiff_t>(term.unknowns.size());
  for (const int p : points) term.unknowns.push_back(p < 0 ? -1 : unknown_of_point_[static_cast<std::size_t>(p)]);
  for (auto a = term.unknowns.begin() + first; a != term.unknowns.end(); ++a)
    if (*a >= 0 && std::find(a + 1, term.unknowns.end(), *a) != term.unknowns.end()) {
      term.unknowns.resize(static_cast<std::size_t>(first));
      throw std::invalid_argument("an element names the same unknown twice");
    }
}

Pattern::Built Pattern::build() const {
  Built built{structure(), {}};
  for (const auto& term : terms_) built.tables.push_back(slots(term, built.structure));
  return built;
}

BlockStructure Pattern::structure() const {
  const int rows =
      unknown_of_point_.empty() ? 0 : *std::max_element(unknown_of_point_.begin(), unknown_of_point_.end()) + 1;

  // Couplings sorted by row, with repetitions: count, then fill.
  const auto each_coupling = [&](const auto& visit) {
    for (const auto& term : terms_) {
      const auto n = static_cast<std::size_t>(term.points_per_element);
      for (auto element = term.unknowns.begin(); element != term.unknowns.end(); element += term.points_per_element)
        for (std::size_t q = 1; q < n; ++q)
          for (std::size_t p = 0; p < q; ++p) {
            const auto [low, high] =
                std::minmax(element[static_cast<std::ptrdiff_t>(p)], element[static_cast<std::ptrdiff_t>(q)]);
            if (low >= 0) visit(static_cast<std::size_t>(high), low);
          }
    }
  };
  std::vector<std::int64_t> start(static_cast<std::size_t>(rows) + 1, 0);
  each_coupling([&](std::size_t row, int) { ++start[row + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::int32_t> column(static_cast<std::size_t>(start.back()));
  auto next = start;
  each_coupling([&](std::size_t row, int low) { column[static_cast<std::size_t>(next[row]++)] = low; });

  BlockStructure structure;
  structure.row_start.push_back(0);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    const auto first = column.begin() + start[row];
    const auto last = column.begin() + start[row + 1];
    std::sort(first, last);
    structure.column.insert(structure.column.end(), first, std::unique(first, last));
    structure.column.push_back(static_cast<std::int32_t>(row));
    structure.row_start.push_back(std::ssize(structure.column));
  }
  return structure;
}

SlotTable Pattern::slots(const Term& term, const BlockStructure& structure) const {
  SlotTable table{term.points_per_element, {}};
  table.slots.reserve(term.unknowns.size() / static_cast<std::size_t>(term.points_per_element) *
                      pairs(term.points_per_element));
  for (auto element = term.unknowns.begin(); element != term.unknowns.end(); element += term.points_per_element)
    for (int q = 0; q < term.points_per_element; ++q)
      for (int p = 0; p <= q; ++p) {
        const int i = element[p];
        const int j = element[q];
        if (i < 0 || j < 0)
          table.slots.push_back({static_cast<std::int32_t>(structure.blocks()), false});
        else
          table.slots.push_back({static_cast<std::int32_t>(structure.find(std::max(i, j), std::min(i, j))), i < j});
      }
  return table;
}

}  // namespace sundrape

#include "sundrape/linalg/block_structure.hpp"

#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(BlockStructure, RowsHoldTheirCouplingsAscendingAndEndOnTheDiagonal) {
  Pattern pattern({0, 1, 2, 3});
  pattern.begin_term(2);
  pattern.add_element(std::array{3, 0});
  pattern.add_element(std::array{1, 3});
  pattern.add_element(std::array{3, 1});  // again, the other way round
  const auto structure = pattern.build().structure;
  EXPECT_EQ(structure.row_start, (std::vector<std::int64_t>{0, 1, 2, 3, 6}));
  EXPECT_EQ(structure.column, (std::vector<std::int32_t>{0, 1, 2, 0, 1, 3}));
  EXPECT_EQ(structure.diagonal(3), 5);
}

TEST(BlockStructure, FindsStoredBlocksAndNoOthers) {
  Pattern pattern({0, 1, 2});
  pattern.begin_term(2);
  pattern.add_element(std::array{0, 2});
  const auto structure = pattern.build().structure;
  EXPECT_EQ(structure.find(2, 0), 2);
  EXPECT_EQ(structure.find(2, 2), 3);
  EXPECT_EQ(structure.find(2, 1), -1);
  EXPECT_EQ(structure.find(1, 0), -1);
}

TEST(BlockStructure, ColumnsHoldTheBlocksBelowTheDiagonal) {
  Pattern pattern({0, 1, 2, 3});
  pattern.begin_term(2);
  for (const auto& element : {std::array{0, 3}, std::array{0, 1}, std::array{2, 3}}) pattern.add_element(element);
  const BlockColumns columns(pattern.build().structure);  // blocks: 00 | 10 11 | 22 | 30 32 33
  EXPECT_EQ(columns.start, (std::vector<std::int64_t>{0, 2, 2, 3, 3}));
  EXPECT_EQ(columns.block, (std::vector<std::int64_t>{1, 4, 5}));
  EXPECT_EQ(columns.row, (std::vector<std::int32_t>{1, 3, 3}));
}

TEST(BlockStructure, WithoutElementsIsTheDiagonal) {
  const auto structure = Pattern({-1, 0, 1}).build().structure;
  EXPECT_EQ(structure.size(), 2);
  EXPECT_EQ(structure.column, (std::vector<std::int32_t>{0, 1}));
}

TEST(BlockStructure, WithoutUnknownsIsEmpty) {
  const auto structure = Pattern({-1, -1}).build().structure;
  EXPECT_EQ(structure.size(), 0);
  EXPECT_EQ(structure.blocks(), 0);
}

TEST(Pattern, SlotsOfFixedAndAbsentPointsAreTheScratchBlock) {
  Pattern pattern({0, -1, 1});
  pattern.begin_term(3);
  pattern.add_element(std::array{0, 1, -1});
  const auto built = pattern.build();
  const auto scratch = built.structure.blocks();
  EXPECT_EQ(built.tables[0].at(0, 0, 0).block, built.structure.diagonal(0));
  for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}})
    EXPECT_EQ(built.tables[0].at(0, p, q).block, scratch) << p << ' ' << q;
}

TEST(Pattern, SlotsAreTransposedWhereTheFirstPointHasTheSmallerRow) {
  Pattern pattern({1, 0});  // point 1 comes first in the matrix
  pattern.begin_term(2);
  pattern.add_element(std::array{0, 1});
  pattern.begin_term(2);
  pattern.add_element(std::array{1, 0});
  const auto built = pattern.build();
  EXPECT_FALSE(built.tables[0].at(0, 0, 1).transposed);
  EXPECT_TRUE(built.tables[1].at(0, 0, 1).transposed);
}

TEST(Pattern, RefusesElementsThatMakeNoSense) {
  Pattern pattern({0, 1, 1, -1});
  EXPECT_THROW(pattern.add_element(std::array{0, 1}), std::invalid_argument);  // no term
  EXPECT_THROW(pattern.begin_term(0), std::invalid_argument);
  pattern.begin_term(2);
  EXPECT_THROW(pattern.add_element(std::array{0, 1, 3}), std::invalid_argument);
  EXPECT_THROW(pattern.add_element(std::array{0, 4}), std::invalid_argument);
  EXPECT_THROW(pattern.add_element(std::array{0, -2}), std::invalid_argument);
  EXPECT_THROW(pattern.add_element(std::array{0, 0}), std::invalid_argument);
  EXPECT_THROW(pattern.add_element(std::array{1, 2}), std::invalid_argument);  // both are block row 1
  EXPECT_THROW(Pattern({-2}), std::invalid_argument);
  EXPECT_TRUE(pattern.build().tables[0].slots.empty());  // nothing of the refused ones stays
  EXPECT_NO_THROW(pattern.add_element(std::array{3, -1}));
}

}  // namespace
}  // namespace sundrape

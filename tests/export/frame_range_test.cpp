#include "sundrape/export/frame_range.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

using Frames = std::vector<std::size_t>;

TEST(FrameRange, CountsAsPythonDoes) {
  EXPECT_EQ(select_frames("", 3), (Frames{0, 1, 2}));
  EXPECT_EQ(select_frames(":", 3), (Frames{0, 1, 2}));
  EXPECT_EQ(select_frames("1:4", 6), (Frames{1, 2, 3}));
  EXPECT_EQ(select_frames("::2", 6), (Frames{0, 2, 4}));
  EXPECT_EQ(select_frames("1::3", 6), (Frames{1, 4}));
  EXPECT_EQ(select_frames("-2:", 6), (Frames{4, 5}));
  EXPECT_EQ(select_frames(":-4", 6), (Frames{0, 1}));
  EXPECT_EQ(select_frames("-100:100", 2), (Frames{0, 1}));
  EXPECT_EQ(select_frames("4", 6), Frames{4});
  EXPECT_EQ(select_frames("-1", 6), Frames{5});
}

TEST(FrameRange, RefusesWhatPicksNothing) {
  for (const auto* const range :
       {"3:3", "6", "-7", "4:2", "1:2:0", "1:2:-1", "a", "1:b", "1.5", "0:1:2:3", " 1", "::x"})
    EXPECT_THROW(static_cast<void>(select_frames(range, 6)), std::invalid_argument) << range;
  EXPECT_THROW(static_cast<void>(select_frames(":", 0)), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

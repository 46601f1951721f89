#include "sundrape/mesh/selector.hpp"

#include <string>

#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

using Nodes = std::vector<int>;

class SelectorOnAGrid : public ::testing::Test {
 protected:
  QuadMesh mesh_ = rectangle(0.3, 0.2, 3, 2);  // nodes 0 … 3 at y = −0.1, 4 … 7 at 0, 8 … 11 at 0.1
  [[nodiscard]] Nodes picked(const Selector& selector) const { return select(selector, mesh_, mesh_.reference); }
};

TEST_F(SelectorOnAGrid, NamedSetsAreTheMeshs) { EXPECT_EQ(picked(NamedSet{"right"}), (Nodes{3, 7, 11})); }

TEST_F(SelectorOnAGrid, UnknownSetIsAnErrorThatListsTheKnownOnes) {
  try {
    (void)picked(NamedSet{"rigth"});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& problem) {
    const std::string message = problem.what();
    EXPECT_NE(message.find("\"rigth\""), std::string::npos);
    EXPECT_NE(message.find("left, right, top"), std::string::npos);
  }
}

TEST_F(SelectorOnAGrid, NearTakesTheClosestNodeAndAllThatAreAsClose) {
  EXPECT_EQ(picked(Near{{0.16, 0.09, 0.5}}), Nodes{11});
  EXPECT_EQ(picked(Near{{0, 0, 0}}), (Nodes{5, 6}));
}

TEST_F(SelectorOnAGrid, BoxTakesItsSurfaceIn) {
  EXPECT_EQ(picked(InBox{{-0.05, 0, 0}, {0.15, 0.1, 0}}), (Nodes{5, 6, 7, 9, 10, 11}));
  EXPECT_TRUE(picked(InBox{{-0.04, 0.01, 0}, {0.04, 0.09, 0}}).empty());
}

TEST_F(SelectorOnAGrid, PlaneTakesNodesOnIt) {
  EXPECT_EQ(picked(OnPlane{{0.05, 7, 3}, {5, 0, 0}}), (Nodes{2, 6, 10}));
  EXPECT_TRUE(picked(OnPlane{{0.051, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_THROW((void)picked(OnPlane{{0, 0, 0}, {0, 0, 0}}), std::invalid_argument);
}

TEST_F(SelectorOnAGrid, SphereTakesItsSurfaceIn) {
  EXPECT_EQ(picked(InSphere{{0.05, 0, 0}, 0.1}), (Nodes{2, 5, 6, 7, 10}));
}

TEST_F(SelectorOnAGrid, GeometryIsComparedWithThePlacedSheet) {
  auto placed = mesh_.reference;
  for (auto& x : placed) x += Vector3(0, 0, 1);
  EXPECT_EQ(select(InSphere{{0.05, 0, 1}, 0.01}, mesh_, placed), Nodes{6});
  EXPECT_TRUE(select(InSphere{{0.05, 0, 0}, 0.01}, mesh_, placed).empty());
}

}  // namespace
}  // namespace sundrape

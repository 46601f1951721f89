#include "sundrape/statics/chapter_relaxation.hpp"

#include <gtest/gtest.h>

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

TEST(ChapterRelaxation, EndsWhereTheSpringCarriesTheWeightOnIt) {
  const auto system = mass_on_spring(9.80665);
  Vector q = below();
  UnseenRelaxation observer;
  const auto result = relax_as_in_chapter(system, {.edge_length = spring_length, .tolerance = 1e-8}, q, observer);
  EXPECT_EQ(result.end, RelaxationEnd::converged) << result.diagnosis;
  EXPECT_NEAR(q[5], -spring_length - hanging_mass * 9.80665 / spring_stiffness, 1e-8);  // Hooke
  EXPECT_GT(result.criterion_iterations, 0);
}

}  // namespace
}  // namespace sundrape

#include "sundrape/force/contact_law.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

constexpr double k = 4e6, w = 1e-4;

TEST(ContactLaw, PressureIsTheSlopeOfTheEnergyAndSlopeThatOfThePressure) {
  const ContactLaw law(k, w);
  const double step = 1e-4 * w;
  for (int i = 0; i < 86; ++i) {
    const double gap = (-2 + 0.0373 * i) * w;
    // the gap shrinks as the depth grows
    EXPECT_NEAR((law.energy(gap - step) - law.energy(gap + step)) / (2 * step), law.pressure(gap), 1e-6 * k * w);
    EXPECT_NEAR((law.pressure(gap - step) - law.pressure(gap + step)) / (2 * step), law.slope(gap), 1e-6 * k);
  }
}

TEST(ContactLaw, JoinsAreTwiceContinuouslyDifferentiable) {
  const ContactLaw law(k, w);
  for (const double joint : {0.0, w}) {
    // across a join the values agree to the order of the step, the curvature of p too
    const double step = 1e-5 * w;
    EXPECT_NEAR(law.energy(joint - step), law.energy(joint + step), 2e-5 * k * w * w);
    EXPECT_NEAR(law.pressure(joint - step), law.pressure(joint + step), 3e-5 * k * w);
    EXPECT_NEAR(law.slope(joint - step), law.slope(joint + step), 1e-8 * k);
    const double second = (law.slope(joint - step) - law.slope(joint + step)) / (2 * step);
    EXPECT_NEAR(second * w / k, 0, 1e-4);
  }
}

TEST(ContactLaw, ValuesAtTheJoinsAreThoseOfTheFormula) {
  const ContactLaw law(k, w);
  EXPECT_EQ(law.pressure(w), 0);
  EXPECT_EQ(law.energy(1.5 * w), 0);
  EXPECT_DOUBLE_EQ(law.pressure(0), 0.5 * k * w);            // x = 1: 1 − ½
  EXPECT_DOUBLE_EQ(law.energy(0), 0.15 * k * w * w);         // ¼ − 1/10
  EXPECT_DOUBLE_EQ(law.pressure(-w), 1.5 * k * w);           // d = 2w
  EXPECT_DOUBLE_EQ(law.pressure(0.5 * w), k * w * 0.09375);  // ⅛ − 1/32
}

TEST(ContactLaw, GapUnderAPressureInvertsIt) {
  const ContactLaw law(k, w);
  for (const double gap : {0.9 * w, 0.5 * w, 0.01 * w, 0.0, -0.3 * w, -5 * w})
    EXPECT_NEAR(law.gap_under(law.pressure(gap)), gap, 1e-9 * w);
}

TEST(ContactLaw, SuggestedStiffnessHoldsTwiceTheTableclothOnOneNode) {
  // 20 cm tablecloth of 2.338 N/m², 1 cm cells, 5.4e-5 m allowed: 64 · 2.338 · 28.28 / 5.4e-5
  const ContactLoad load{2.338, 0.2 * std::sqrt(2.0), 0.01};
  const double stiffness = suggested_stiffness(load, 5.4e-5);
  EXPECT_NEAR(stiffness, 7.8374e7, 2e4);
  const double twice_the_weight = 2 * 2.338 * 0.04, one_node = 1e-4;  // [N], [m²]
  EXPECT_GT(ContactLaw(stiffness, 5e-5).gap_under(twice_the_weight / one_node), -5.4e-5);
}

TEST(ContactLaw, RefusesNonsense) {
  EXPECT_THROW(ContactLaw(0, w), std::invalid_argument);
  EXPECT_THROW(ContactLaw(k, 0), std::invalid_argument);
  EXPECT_THROW(ContactLaw(std::nan(""), w), std::invalid_argument);
  EXPECT_THROW((void)suggested_stiffness({1, 1, 0}, 1e-4), std::invalid_argument);
  EXPECT_THROW((void)suggested_stiffness({1, 1, 1}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

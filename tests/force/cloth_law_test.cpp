#include "sundrape/force/cloth_law.hpp"

#include <gtest/gtest.h>

namespace sundrape {
namespace {

constexpr double h = 0.5e-3;
const ClothLaw law({1e8, 0.1 * h});

TEST(ClothLaw, PressureAndSlopeAreDerivatives) {
  for (const double share : {0.02, 0.1, 0.3, 0.49, 0.5, 0.51, 0.8, 0.96, 1.0, 1.04, 1.2}) {
    const double d = share * h, step = 1e-5 * d;
    const double pressure = (law.energy(d - step, h) - law.energy(d + step, h)) / (2 * step);
    const double slope = (law.pressure(d - step, h) - law.pressure(d + step, h)) / (2 * step);
    EXPECT_NEAR(law.pressure(d, h), pressure, 1e-6 * law.pressure(0.9 * d, h)) << share;
    EXPECT_NEAR(law.slope(d, h), slope, 1e-4 * law.slope(0.9 * d, h)) << share;
  }
}

TEST(ClothLaw, IsTheContactLawAroundTheThickness) {
  const ContactLaw contact(1e8, 0.1 * h);
  for (const double share : {0.5, 0.7, 0.95, 1.0, 1.03, 1.05})
    EXPECT_NEAR(law.pressure(share * h, h), contact.pressure(share * h - 0.95 * h), 1e-9 * contact.pressure(0));
  EXPECT_EQ(law.pressure(1.000001 * law.reach(h), h), 0);
  EXPECT_GT(law.pressure(0.999 * law.reach(h), h), 0);
}

TEST(ClothLaw, NoEnergyIsEnoughToPassIt) {
  EXPECT_GT(law.energy(0.01 * h, h), 1e4 * law.energy(0.5 * h, h));
  EXPECT_GT(law.energy(1e-4 * h, h), 1e9 * law.energy(0.5 * h, h));
}

}  // namespace
}  // namespace sundrape

#include "sundrape/material/fabric.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(IsotropicFabric, HasTheResultantsOfAThinPlate) {
  // E h = 1e6 · 1e-3; G h = E h / 2.5; E h³ / (12 · 0.9375), worked by hand for ν = 1/4
  const Fabric fabric = isotropic_fabric(1e6, 0.25, 1e-3, 0.2);
  EXPECT_DOUBLE_EQ(fabric.warp_membrane, 1000);
  EXPECT_DOUBLE_EQ(fabric.weft_membrane, 1000);
  EXPECT_DOUBLE_EQ(fabric.shear_membrane, 400);
  EXPECT_DOUBLE_EQ(fabric.warp_bending, 1e-3 / 11.25);
  EXPECT_DOUBLE_EQ(fabric.weft_bending, 1e-3 / 11.25);
  EXPECT_EQ(fabric.area_density, 0.2);
  EXPECT_EQ(fabric.thickness, 1e-3);
  EXPECT_EQ(fabric.poisson, 0.25);
}

TEST(IsotropicFabric, OfTheTwillHasItsMeasuredBendingRigidity) {
  // The article's twill: E = 12 B / h³ = 60446 gf/cm² for B = 0.589 gf cm²/cm, h = 0.0489 cm, ν = 0 (five digits)
  const Fabric twill = isotropic_fabric(60446 * 98.0665, 0, 0.0489e-2, 0.2665);
  EXPECT_NEAR(twill.warp_bending, 0.589 * 9.80665e-5, 2e-5 * 0.589 * 9.80665e-5);
}

TEST(IsotropicFabric, RefusesWhatNoSheetHas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)isotropic_fabric(bad, 0.3, 1e-3, 0.2), std::invalid_argument) << bad;
    EXPECT_THROW((void)isotropic_fabric(1e6, 0.3, bad, 0.2), std::invalid_argument) << bad;
    EXPECT_THROW((void)isotropic_fabric(1e6, 0.3, 1e-3, bad), std::invalid_argument) << bad;
  }
  for (const double bad : {-0.1, 0.5, 0.7, nan})
    EXPECT_THROW((void)isotropic_fabric(1e6, bad, 1e-3, 0.2), std::invalid_argument) << bad;
}

}  // namespace
}  // namespace sundrape

#include "sundrape/material/fabric.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

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

TEST(OrthotropicFabric, HasTheResultantsOfAPlateOfItsModuli) {
  // ν₁₂ ν₂₁ = 0.4² · 1/2 = 0.08
  const Fabric fabric = orthotropic_fabric(2e6, 1e6, 3e4, 0.4, 1e-3, 0.2);
  EXPECT_DOUBLE_EQ(fabric.warp_membrane, 2000);
  EXPECT_DOUBLE_EQ(fabric.weft_membrane, 1000);
  EXPECT_DOUBLE_EQ(fabric.shear_membrane, 30);
  EXPECT_DOUBLE_EQ(fabric.warp_bending, 2e-3 / 12 / 0.92);
  EXPECT_DOUBLE_EQ(fabric.weft_bending, 1e-3 / 12 / 0.92);
  EXPECT_DOUBLE_EQ(fabric.bending_coupling, 0.4 * 1e-3 / 12 / 0.92);
  EXPECT_DOUBLE_EQ(fabric.twist_bending, 3e-5 / 12);
  EXPECT_DOUBLE_EQ(fabric.transverse_shear, std::sqrt(2.0) * 1000 / (2 * (1 + std::sqrt(0.08))));
  // the bending of a plate is its membrane's times h²/12
  EXPECT_LT((plate_bending(fabric).rigidity() - membrane_stiffness(fabric) * 1e-6 / 12).norm(), 1e-18);
}

TEST(OrthotropicFabric, OfEqualThreadsIsIsotropic) {
  const double modulus = 1e6, nu = 0.25;
  const Fabric a = isotropic_fabric(modulus, nu, 1e-3, 0.2);
  const Fabric b = orthotropic_fabric(modulus, modulus, modulus / (2 * (1 + nu)), nu, 1e-3, 0.2);
  EXPECT_LT((membrane_stiffness(a) - membrane_stiffness(b)).norm(), 1e-12 * membrane_stiffness(a).norm());
  EXPECT_LT((plate_bending(a).rigidity() - plate_bending(b).rigidity()).norm(), 1e-12 * a.warp_bending);
  EXPECT_NEAR(a.transverse_shear, b.transverse_shear, 1e-12 * a.transverse_shear);
}

TEST(MeasuredBending, IsThatOfAStripFreeToCurl) {
  Fabric fabric = isotropic_fabric(1e6, 0.3, 1e-3, 0.2);
  set_measured_bending(fabric, 4e-5, 2e-5);
  // bend a strip along the warp and let it curl until m₂₂ = 0: m₁₁/κ₁₁ is what was measured
  const Eigen::Matrix3d d = plate_bending(fabric).rigidity();
  EXPECT_DOUBLE_EQ(d(0, 0) - d(0, 1) * d(0, 1) / d(1, 1), 4e-5);
  EXPECT_DOUBLE_EQ(d(1, 1) - d(0, 1) * d(0, 1) / d(0, 0), 2e-5);
  EXPECT_DOUBLE_EQ(d(0, 1), 0.3 * d(1, 1));
  EXPECT_DOUBLE_EQ(d(2, 2), std::sqrt(8e-10) / (2 * (1 + 0.3 * std::sqrt(0.5))));
  set_measured_bending(fabric, 4e-5, 2e-5, 1e-6);
  EXPECT_EQ(fabric.twist_bending, 1e-6);
}

TEST(MeasuredBending, OfAPlatesOwnStripsIsThePlate) {
  const Fabric plate = isotropic_fabric(1e6, 0.3, 1e-3, 0.2);
  Fabric strips = plate;
  set_measured_bending(strips, 1e-3 / 12, 1e-3 / 12);
  EXPECT_LT((plate_bending(plate).rigidity() - plate_bending(strips).rigidity()).norm(), 1e-12 * plate.warp_bending);
}

TEST(MeasuredBending, ByPolynomialsGivesTheRigiditiesAtRest) {
  Fabric fabric = isotropic_fabric(1e6, 0.3, 1e-3, 0.2);
  const auto law = MomentCurvature::polynomial(std::vector{2e-5, 1e-7}, 100);
  set_measured_bending(fabric, {.warp = law, .weft = law});
  EXPECT_DOUBLE_EQ(fabric.warp_bending, 2e-5 / 0.91);
  EXPECT_DOUBLE_EQ(fabric.weft_bending, 2e-5 / 0.91);
  EXPECT_DOUBLE_EQ(fabric.bending_coupling, 0.3 * 2e-5 / 0.91);
  EXPECT_DOUBLE_EQ(fabric.twist_bending, 1e-5 / 1.3);
  EXPECT_EQ(plate_bending(fabric).form(), PlateBending::Form::energy);
  set_measured_bending(fabric, 1e-5, 1e-5);  // the last one counts
  EXPECT_EQ(plate_bending(fabric).form(), PlateBending::Form::linear);
}

TEST(MeasuredBending, RefusesWhatNoSheetHas) {
  Fabric fabric = isotropic_fabric(1e6, 0.3, 1e-3, 0.2);
  EXPECT_THROW(set_measured_bending(fabric, 0, 1), std::invalid_argument);
  EXPECT_THROW(set_measured_bending(fabric, 1, 1, -1), std::invalid_argument);
  EXPECT_THROW(set_measured_bending(fabric, 1, 12), std::invalid_argument);  // 0.09 · 12 > 1
  EXPECT_THROW((void)orthotropic_fabric(1e6, 1e8, 1e4, 0.3, 1e-3, 0.2), std::invalid_argument);
  EXPECT_THROW((void)orthotropic_fabric(1e6, 1e6, 0, 0.3, 1e-3, 0.2), std::invalid_argument);
}

TEST(ScaledFabric, HasMultipliedResultantsWhateverItsLaws) {
  Fabric fabric = orthotropic_fabric(2e6, 1e6, 4e5, 0.2, 1e-3, 0.2);
  const Fabric linear = scaled(fabric, 0.01, 10);
  EXPECT_TRUE(membrane_stiffness(linear).isApprox(0.01 * membrane_stiffness(fabric), 1e-14));
  EXPECT_TRUE(plate_bending(linear).rigidity().isApprox(10 * plate_bending(fabric).rigidity(), 1e-14));
  EXPECT_EQ(linear.transverse_shear, fabric.transverse_shear);
  EXPECT_EQ(linear.area_density, fabric.area_density);
  const auto law = MomentCurvature::polynomial(std::vector{2e-5, 1e-7}, 100);
  set_measured_bending(fabric, {.warp = law, .weft = law});
  const Eigen::Vector3d curvature(30, -150, 20);  // within the fit, past it, and a twist
  EXPECT_TRUE(plate_bending(scaled(fabric, 1, 10))
                  .at(curvature)
                  .moment.isApprox(10 * plate_bending(fabric).at(curvature).moment, 1e-13));
  EXPECT_THROW((void)scaled(fabric, 0, 1), std::invalid_argument);
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

#include "sundrape/material/plate_bending.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "twill.hpp"

namespace sundrape {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Form = PlateBending::Form;

constexpr double nu = 0.3;

/// Stiffer than the twill and less curved: α in the same units.
MomentCurvature canvas() { return MomentCurvature::polynomial(std::vector{1.8, -1.0, 0.4}, 2); }

Matrix3d isotropic(double d, double poisson) {
  Matrix3d m = Vector3d(d, d, 0.5 * (1 - poisson) * d).asDiagonal();
  m(0, 1) = m(1, 0) = poisson * d;
  return m;
}

/// Curvatures from far inside the tests' range to past it, reproducibly.
std::vector<Vector3d> curvatures(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1), size(-3, 0.6);
  std::vector<Vector3d> all;
  for (int i = 0; i < count; ++i) {
    const Vector3d direction(unit(random), unit(random), unit(random));
    all.emplace_back(std::pow(10, size(random)) * direction);
  }
  return all;
}

/// Curvatures (κ₁₁, κ₂₂, 2κ₁₂) of a cylinder of curvature k whose generators lie across the direction at `angle`.
Vector3d cylinder(double k, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return k * Vector3d(c * c, s * s, 2 * c * s);
}

/// Components of moments about axes turned by `angle`: bending, bending across, twist.
Vector3d turned(const Vector3d& m, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * m[0] + s * s * m[1] + 2 * c * s * m[2], s * s * m[0] + c * c * m[1] - 2 * c * s * m[2],
          c * s * (m[1] - m[0]) + (c * c - s * s) * m[2]};
}

struct Law {
  std::string name;
  PlateBending bending;
};
void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

std::vector<Law> laws() {
  Matrix3d orthotropic = Vector3d(2, 0.7, 0.4).asDiagonal();
  orthotropic(0, 1) = orthotropic(1, 0) = 0.21;
  return {{"Linear", PlateBending(orthotropic)},
          {"Paper", PlateBending(Form::paper, twill(), twill(), nu)},
          {"PaperOfTwoThreads", PlateBending(Form::paper, twill(), canvas(), nu)},
          {"Energy", PlateBending(Form::energy, twill(), twill(), nu)},
          {"EnergyOfTwoThreads", PlateBending(Form::energy, twill(), canvas(), nu)}};
}

class AnyPlateBending : public testing::TestWithParam<Law> {};

TEST_P(AnyPlateBending, HasTheDerivativeOfItsMomentAsTangent) {
  const auto& law = GetParam().bending;
  for (const Vector3d& k : curvatures(200)) {
    const auto here = law.at(k);
    Matrix3d differences;
    const double step = 1e-4 * k.norm();
    for (int j = 0; j < 3; ++j) {  // fourth order: the laws bend sharply near the origin
      const auto moment = [&](double steps) { return law.at<double>(k + steps * step * Vector3d::Unit(j)).moment; };
      differences.col(j) = (8 * (moment(1) - moment(-1)) - (moment(2) - moment(-2))) / (12 * step);
    }
    EXPECT_LT((differences - here.tangent).norm(), 1e-6 * here.tangent.norm()) << k.transpose();
  }
}

TEST_P(AnyPlateBending, HasTheTangentAtRestAsRigidity) {
  const auto& law = GetParam().bending;
  const Matrix3d at_rest = law.at<double>(Vector3d::Zero()).tangent;
  EXPECT_LT((0.5 * (at_rest + at_rest.transpose()) - law.rigidity()).norm(), 1e-5 * law.rigidity().norm());
  EXPECT_EQ(law.at<double>(Vector3d::Zero()).moment.norm(), 0);
  EXPECT_TRUE(law.rigidity().isApprox(law.rigidity().transpose()));
  // and goes over into it: no jump where curvatures become too small for their powers
  for (const double size : {1e-12, 1e-9, 1e-6, 1e-5})
    EXPECT_LT((law.at<double>(size * Vector3d(1, -0.4, 0.7)).tangent - at_rest).norm(),
              (10 * size + 1e-8) * at_rest.norm())
        << size;
}

TEST_P(AnyPlateBending, IsOdd) {
  const auto& law = GetParam().bending;
  for (const Vector3d& k : curvatures(20)) {
    EXPECT_LT((law.at(k).moment + law.at<double>(-k).moment).norm(), 1e-14 * law.at(k).moment.norm());
    EXPECT_DOUBLE_EQ(law.at(k).energy, law.at<double>(-k).energy);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, AnyPlateBending, testing::ValuesIn(laws()),
                         [](const auto& info) { return info.param.name; });

class ElasticPlateBending : public testing::TestWithParam<Law> {};

TEST_P(ElasticPlateBending, HasMomentsThatAreTheGradientOfItsEnergy) {
  const auto& law = GetParam().bending;
  EXPECT_TRUE(law.is_symmetric());
  for (const Vector3d& k : curvatures(200)) {
    const auto here = law.at(k);
    Vector3d gradient;
    const double step = 1e-4 * k.norm();
    for (int j = 0; j < 3; ++j) {
      const auto energy = [&](double steps) { return law.at<double>(k + steps * step * Vector3d::Unit(j)).energy; };
      gradient[j] = (8 * (energy(1) - energy(-1)) - (energy(2) - energy(-2))) / (12 * step);
    }
    EXPECT_LT((gradient - here.moment).norm(), 1e-8 * here.moment.norm()) << k.transpose();
  }
}

TEST_P(ElasticPlateBending, HasASymmetricPositiveDefiniteTangent) {
  const auto& law = GetParam().bending;
  for (const Vector3d& k : curvatures(2000)) {
    const Matrix3d tangent = law.at(k).tangent;
    EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-12 * tangent.norm()) << k.transpose();
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix3d>(tangent).eigenvalues()[0], 0) << k.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ElasticPlateBending,
                         testing::Values(laws()[0], laws()[3], laws()[4],
                                         Law{"EnergyWithoutPoisson", {Form::energy, twill(), twill(), 0}}),
                         [](const auto& info) { return info.param.name; });

TEST(EnergyPlateBending, ResistsACylinderAlikeInEveryDirection) {
  const PlateBending law(Form::energy, twill(), twill(), nu);
  for (const double k : {0.05, 0.6, -1.4, 2.4, 3.0})
    for (int i = 0; i < 16; ++i) {
      const double angle = std::numbers::pi * i / 16;
      // a strip's law over 1 − ν², ν of it across, and no twist, in the axes of the bend
      const double f = twill().at(k).moment / (1 - nu * nu);
      const Vector3d m = turned(law.at<double>(cylinder(k, angle)).moment, angle);
      EXPECT_LT((m - Vector3d(f, nu * f, 0)).norm(), 1e-12 * std::abs(f)) << k << " at " << angle;
      EXPECT_NEAR(law.at<double>(cylinder(k, angle)).energy, twill().at(k).energy / (1 - nu * nu), 1e-13);
    }
}

TEST(EnergyPlateBending, HasTheMomentsOfThePaperAlongAThread) {
  const PlateBending energy(Form::energy, twill(), twill(), nu), paper(Form::paper, twill(), twill(), nu);
  for (const double k : {0.3, -1.0, 2.2, 4.0})
    for (const Vector3d& bend : {Vector3d(k, 0, 0), Vector3d(0, k, 0)})
      EXPECT_LT((energy.at(bend).moment - paper.at(bend).moment).norm(), 1e-13);
  // with two laws, each thread bends by its own
  const PlateBending two(Form::energy, twill(), canvas(), nu);
  EXPECT_NEAR(two.at<double>({1.1, 0, 0}).moment[0], twill().at(1.1).moment / (1 - nu * nu), 1e-14);
  EXPECT_NEAR(two.at<double>({0, 1.1, 0}).moment[1], canvas().at(1.1).moment / (1 - nu * nu), 1e-14);
}

TEST(PaperPlateBending, IsEquations32To34) {
  const PlateBending law(Form::paper, twill(), canvas(), nu);
  const double k1 = 0.7, k2 = -1.3, twist = 0.4;
  const double f1 = twill().at(k1).moment, f2 = canvas().at(k2).moment;
  const double f = 0.5 * (twill().at(twist).moment + canvas().at(twist).moment);
  const Vector3d m = law.at<double>({k1, k2, twist}).moment;
  EXPECT_NEAR(m[0], (f1 + nu * f2) / (1 - nu * nu), 1e-14);  // (32)
  EXPECT_NEAR(m[1], (nu * f1 + f2) / (1 - nu * nu), 1e-14);  // (33)
  EXPECT_NEAR(m[2], 0.5 * f / (1 + nu), 1e-14);              // (34)
}

TEST(PaperPlateBending, IsSymmetricOnlyWithoutPoissonsRatio) {
  const PlateBending with(Form::paper, twill(), twill(), nu), without(Form::paper, twill(), twill(), 0);
  EXPECT_FALSE(with.is_symmetric());
  EXPECT_TRUE(without.is_symmetric());
  const Vector3d k(0.2, 1.0, 0.1);  // the slopes there differ: 0.71 and 0.53
  const Matrix3d a = with.at(k).tangent, b = without.at(k).tangent;
  EXPECT_GT(std::abs(a(0, 1) - a(1, 0)), 0.05 * a(0, 0));
  EXPECT_EQ(b(0, 1), b(1, 0));
}

TEST(PlateBending, OfLinearStripsIsTheLinearPlateWhateverItsForm) {
  const double b = 0.589, d = b / (1 - nu * nu);
  const auto strip = MomentCurvature::linear(b);
  const PlateBending plate(isotropic(d, nu));
  for (const auto form : {Form::paper, Form::energy}) {
    const PlateBending law(form, strip, strip, nu);
    EXPECT_LT((law.rigidity() - plate.rigidity()).norm(), 1e-14);
    for (const Vector3d& k : curvatures(50)) {
      EXPECT_LT((law.at(k).moment - plate.at(k).moment).norm(), 1e-13 * plate.at(k).moment.norm());
      EXPECT_LT((law.at(k).tangent - plate.at(k).tangent).norm(), 1e-12);
      EXPECT_NEAR(law.at(k).energy, plate.at(k).energy, 1e-13 * plate.at(k).energy);
    }
  }
}

TEST(PlateBending, CountsTheTwistOnce) {
  // z = κ₁₂ x y: m₁₂ = D (1 − ν) κ₁₂ and D (1 − ν) κ₁₂² of energy per area, of a plate bent to a saddle
  const double d = 2, twist = 0.3, strip = d * (1 - nu * nu);
  const PlateBending linear(isotropic(d, nu)),
      energy(Form::energy, MomentCurvature::linear(strip), MomentCurvature::linear(strip), nu),
      paper(Form::paper, MomentCurvature::linear(strip), MomentCurvature::linear(strip), nu);
  for (const auto* law : {&linear, &energy, &paper}) {
    const auto r = law->at<double>({0, 0, 2 * twist});
    EXPECT_NEAR(r.moment[2], d * (1 - nu) * twist, 1e-14);
    EXPECT_NEAR(r.energy, d * (1 - nu) * twist * twist, 1e-14);
    // the same saddle in axes at 45°: +κ₁₂ and −κ₁₂ along them
    EXPECT_NEAR(law->at<double>({twist, -twist, 0}).energy, d * (1 - nu) * twist * twist, 1e-14);
  }
}

TEST(PlateBending, RefusesWhatNoSheetHas) {
  const Matrix3d nothing = Matrix3d::Zero();
  EXPECT_THROW(PlateBending{nothing}, std::invalid_argument);
  Matrix3d skew = Matrix3d::Identity();
  skew(0, 1) = 0.1;
  EXPECT_THROW(PlateBending{skew}, std::invalid_argument);
  Matrix3d indefinite = Matrix3d::Identity();
  indefinite(0, 1) = indefinite(1, 0) = 1.1;
  EXPECT_THROW(PlateBending{indefinite}, std::invalid_argument);
  EXPECT_THROW(PlateBending(Form::linear, twill(), twill(), nu), std::invalid_argument);
  for (const double bad : {-0.1, 0.5, 2.0})
    EXPECT_THROW(PlateBending(Form::energy, twill(), twill(), bad), std::invalid_argument);
  // ν (B₁ + B₂)/2 > √(B₁ B₂): bending both ways at once would give energy back
  EXPECT_THROW(PlateBending(Form::energy, MomentCurvature::linear(100), MomentCurvature::linear(1), nu),
               std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

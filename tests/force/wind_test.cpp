#include "sundrape/force/wind.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/force_term_checks.hpp"

namespace sundrape {
namespace {

const std::vector<std::array<int, 4>> face{{0, 1, 2, 3}};
const std::vector<Vector3> square{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};

Vector3 total(const Wind& wind, const TestState& state) {
  Vector f = Vector::Zero(state.q.size());
  wind.add_force(state, f);
  Vector3 sum = Vector3::Zero();
  for (Eigen::Index k = 0; k < f.size(); k += 3) sum += f.segment<3>(k);
  return sum;
}

TestState moving(const Vector3& velocity) {
  auto state = perturbed(square, 0, 0, 1);
  for (Eigen::Index k = 0; k < state.v.size(); ++k) state.v[k] = velocity[k % 3];
  return state;
}

TEST(Wind, TangentIsExact) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    expect_tangent_is_force_derivative(
        Wind(face, {.velocity = {1, 0.5, -2}}, {.density = 1.2, .drag = 1.1, .lift = 0.8}), random_state(4, seed),
        1e-6);
}

TEST(Wind, SymmetricPartIsWhatSymmetricMatricesGet) {
  expect_symmetric_tangent_is_symmetric_part(Wind(face, {.velocity = {1, 0.5, -2}}, {}), random_state(4, 3));
}

TEST(Wind, DragOnAFaceAcrossTheFlow) {
  // ½ ρ C_d A v² along the flow
  const Wind still(face, {}, {.density = 1.25, .drag = 1.3, .lift = 0.7});
  const double expected = 0.5 * 1.25 * 1.3 * 0.01 * 4;
  EXPECT_LT((total(still, moving({0, 0, -2})) - Vector3(0, 0, expected)).norm(), 1e-4 * expected);
}

TEST(Wind, LiftIsNormalToTheFlowAndAsLargeAsItsCoefficientSays) {
  const double speed = 3, angle = 0.6;
  const Wind still(face, {}, {.density = 1.25, .drag = 0, .lift = 0.7});
  const Vector3 along(std::cos(angle), 0, -std::sin(angle));
  const Vector3 lift = total(still, moving(speed * along));
  EXPECT_NEAR(lift.dot(along), 0, 1e-12);
  EXPECT_NEAR(lift.norm(), 0.5 * 1.25 * 0.01 * speed * speed * 0.7 * std::sin(angle) * std::cos(angle), 1e-12);
  EXPECT_GT(lift.z(), 0);  // it falls forwards and is carried
}

TEST(Wind, NothingActsOnWhatMovesWithIt) {
  const Wind wind(face, {.velocity = {2, -1, 0.5}}, {});
  EXPECT_EQ(total(wind, moving({2, -1, 0.5})).norm(), 0);
}

TEST(Wind, PowerIsThatOfTheForceLessWhatTheAirTurnsIntoHeat) {
  const Wind wind(face, {.velocity = {2, -1, 0.5}}, {});
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto state = random_state(4, seed);
    Vector f = Vector::Zero(state.q.size());
    wind.add_force(state, f);
    EXPECT_GE(wind.dissipated_power(state), 0);
    EXPECT_NEAR(f.dot(state.v), wind.external_power(state) - wind.dissipated_power(state), 1e-12);
  }
}

TEST(Wind, GustsStayWithinTheirAmplitudeAndHaveNoMean) {
  const WindField field{.velocity = {1, 0, 0}, .gust = {0, 2, 0}, .period = 0.5, .seed = 7};
  double sum = 0, most = 0;
  constexpr int samples = 100000;
  for (int i = 0; i < samples; ++i) {
    const Vector3 v = field.at(0.003 * i);
    EXPECT_EQ(v.x(), 1);
    sum += v.y();
    most = std::max(most, std::abs(v.y()));
  }
  EXPECT_LE(most, 2);
  EXPECT_GT(most, 1.8);
  EXPECT_NEAR(sum / samples, 0, 0.01);
}

TEST(Wind, RefusesNegativeAir) {
  EXPECT_THROW(Wind(face, {}, {.density = -1}), std::invalid_argument);
  EXPECT_THROW(Wind(face, {.period = 0}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape

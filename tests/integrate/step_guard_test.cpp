#include "sundrape/integrate/step_guard.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

/// A wall at x = 0 for a single point: nothing goes through it, and beside it corrections have to be small.
class Wall final : public ForceTerm {
 public:
  explicit Wall(bool watched) : watched_(watched) {}
  [[nodiscard]] std::string_view name() const override { return "wall"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::contact; }
  [[nodiscard]] double energy(const State& /*state*/) const override { return 0; }
  void add_force(const State& /*state*/, VectorRef /*f*/) const override {}
  void add_tangent(const State& /*state*/, double /*dq*/, double /*dv*/, Assembler& /*tangent*/) const override {}
  void declare_pattern(Pattern& pattern) const override { pattern.begin_term(1); }
  [[nodiscard]] bool watches_passages() const override { return watched_; }
  [[nodiscard]] std::optional<Passage> passage(const State& from, const State& to) const override {
    if (from.q[0] * to.q[0] > 0) return std::nullopt;
    return Passage{"the point through the wall", Vector3(0, from.q[1], from.q[2])};
  }
  [[nodiscard]] bool settles(const State& before, const State& after) const override {
    return std::abs(before.q[0] - after.q[0]) <= 0.1 * std::abs(after.q[0]);
  }

 private:
  bool watched_;
};

System point_at_a_wall(bool watched = true) {
  std::vector<std::unique_ptr<ForceTerm>> terms;
  terms.push_back(std::make_unique<Wall>(watched));
  return {Vector::Ones(1), std::move(terms), Unknowns({{false, false, false}}), Vector::Zero(3)};
}

Vector at(double x) { return Vector3(x, 2, 3); }

TEST(StepGuard, LooksAtTheWayFromTheStateAcceptedLast) {
  const auto system = point_at_a_wall();
  StepGuard guard(system);
  EXPECT_TRUE(guard.watches());
  guard.start_from(0, at(1));
  EXPECT_TRUE(guard.admits(1, at(0.1)));
  EXPECT_FALSE(guard.refusal());
  EXPECT_FALSE(guard.admits(1, at(-0.1)));
  ASSERT_TRUE(guard.refusal());
  EXPECT_EQ(guard.refusal()->what, "the point through the wall");
  EXPECT_EQ(guard.refusal()->place, Vector3(0, 2, 3));
  // refused steps change nothing, accepted ones do; and what was refused is forgotten
  guard.start_from(1, at(-1));
  EXPECT_TRUE(guard.admits(2, at(-0.1)));
  EXPECT_FALSE(guard.refusal());
}

TEST(StepGuard, AsksWhetherCorrectionsSettle) {
  const auto system = point_at_a_wall();
  StepGuard guard(system);
  guard.start_from(0, at(1));
  EXPECT_TRUE(guard.settles(1, at(0.205), at(0.2)));
  EXPECT_FALSE(guard.settles(1, at(0.25), at(0.2)));
}

TEST(StepGuard, LeavesToOthersWhatIsNotFinite) {
  const auto system = point_at_a_wall();
  StepGuard guard(system);
  guard.start_from(0, at(1));
  EXPECT_TRUE(guard.admits(1, at(std::nan(""))));
  EXPECT_TRUE(guard.settles(1, at(std::nan("")), at(1)));
}

TEST(StepGuard, AdmitsEverythingWhereNobodyWatches) {
  const auto system = point_at_a_wall(false);
  StepGuard guard(system);
  EXPECT_FALSE(guard.watches());
  guard.start_from(0, at(1));
  EXPECT_TRUE(guard.admits(1, at(-1)));
  EXPECT_TRUE(guard.settles(1, at(1), at(-1)));
}

}  // namespace
}  // namespace sundrape

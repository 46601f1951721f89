#include "sundrape/io/expression.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

Expression expression(const std::string& text) { return Expression(text, Units()); }

/// Its value where every reduction is 2 and every number is 10.
double value(const std::string& text) {
  return expression(text).evaluate([](const Reduction&) { return 2.0; }, [](const std::string&) { return 10.0; });
}

TEST(Expression, TakesOneNumberFromEverySeries) {
  const auto e = expression("(at(probe.tip.z, 300 ms) - first(probe.tip.z)) / max( energy.total )");
  ASSERT_EQ(e.reductions().size(), 3U);
  EXPECT_EQ(e.reductions()[0].function, "at");
  EXPECT_EQ(e.reductions()[0].series, "probe.tip.z");
  EXPECT_DOUBLE_EQ(e.reductions()[0].at, 0.3);
  EXPECT_EQ(e.reductions()[2].series, "energy.total");
  EXPECT_TRUE(e.numbers().empty());
  EXPECT_EQ(value("last(probe.left-hand.x) * 3 + 1"), 7);
}

TEST(Expression, HasNumbersByNameAndTheUsualArithmetic) {
  EXPECT_EQ(expression("steps / newton_iterations").numbers(),
            (std::vector<std::string>{"newton_iterations", "steps"}));
  EXPECT_EQ(value("min(steps, 3) ^ 2"), 9);  // of numbers, not of a series
  EXPECT_EQ(value("abs(-steps) > 5 ? 1 : 0"), 1);
  EXPECT_EQ(value("1e-3 * steps"), 0.01);
  EXPECT_TRUE(std::isnan(value("sqrt(-steps)")));
}

TEST(Expression, KnowsWhetherItIsOneMeasureAndNothingElse) {
  ASSERT_NE(expression(" last(probe.tip.z) ").single_reduction(), nullptr);
  EXPECT_EQ(expression("2*last(probe.tip.z)").single_reduction(), nullptr);
  ASSERT_NE(expression("steps").single_number(), nullptr);
  EXPECT_EQ(expression("steps + 1").single_number(), nullptr);
}

TEST(Expression, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> all{
      {"probe.tip.z / 2", "'probe.tip.z' is a series: say which number of it is meant, last(probe.tip.z)"},
      {"lst(probe.tip.z)", "'lst' makes no number of the series 'probe.tip.z', did you mean 'last'?"},
      {"at(probe.tip.z)", "needs to know when"},
      {"last(probe.tip.z, 3)", "takes nothing besides the series"},
      {"at(probe.tip.z, 3 cm)", "'3 cm' is a length, a time is expected"},
      {"steps +", "'steps +' cannot be read: "},
      {"log(steps", "cannot be read: "},
      {"", "cannot be read: "},
  };
  for (const auto& [text, message] : all) {
    try {
      (void)expression(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const std::invalid_argument& problem) {
      EXPECT_NE(std::string(problem.what()).find(message), std::string::npos) << problem.what();
    }
  }
}

}  // namespace
}  // namespace sundrape

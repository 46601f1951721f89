#include "sundrape/io/measures.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "docs_section.hpp"

namespace sundrape {
namespace {

double reduced(const MeasureSeries& series, const std::string& function, double at = 0) {
  return reduce(series, {.function = function, .series = "a.b", .at = at});
}

TEST(Reductions, AreWhatTheirNamesSay) {
  const MeasureSeries series{.variable = {0, 1, 3, 4}, .value = {2, -1, 5, 5}};
  EXPECT_EQ(reduced(series, "first"), 2);
  EXPECT_EQ(reduced(series, "last"), 5);
  EXPECT_EQ(reduced(series, "min"), -1);
  EXPECT_EQ(reduced(series, "max"), 5);
  EXPECT_EQ(reduced(series, "range"), 6);
  EXPECT_EQ(reduced(series, "argmin"), 1);
  EXPECT_EQ(reduced(series, "argmax"), 3);                // the first time
  EXPECT_EQ(reduced(series, "mean"), (0.5 + 4 + 5) / 4);  // trapezia over the variable
  EXPECT_EQ(reduced(series, "at", 3), 5);
  EXPECT_EQ(reduced(series, "at", 0.5), 0.5);  // straight between entries
  EXPECT_THROW((void)reduced(series, "at", 4.1), std::invalid_argument);
  EXPECT_THROW((void)reduced({}, "last"), std::invalid_argument);
}

TEST(Reductions, FollowACubicExactlyWhereRatesAreKnown) {
  const auto x = [](double t) { return 1 - 2 * t + 3 * t * t - 0.5 * t * t * t; };
  const auto v = [](double t) { return -2 + 6 * t - 1.5 * t * t; };
  MeasureSeries series;
  for (const double t : {0.0, 0.3, 1.0, 1.2}) {
    series.variable.push_back(t);
    series.value.push_back(x(t));
    series.rate.push_back(v(t));
  }
  for (const double t : {0.1, 0.3, 0.77, 1.2}) EXPECT_NEAR(reduced(series, "at", t), x(t), 1e-15) << t;
}

TEST(Reductions, FindLoadFactorsThatTurnBackWhereTheyComeFirst) {
  const MeasureSeries path{.variable = {0, 1, 0.5, 2}, .value = {0, 10, 20, 30}};
  EXPECT_EQ(reduced(path, "at", 0.75), 7.5);
  EXPECT_EQ(reduced(path, "at", 1.25), 25);
}

Case small_case() {
  Case c;
  c.output.probes.resize(1);
  c.output.probes.front().name = "left tip";
  return c;
}

TEST(MeasureCatalogue, KnowsWhatACaseHasAndItsUnits) {
  const Case c = small_case();
  EXPECT_EQ(measure_info("probe.left_tip.z", c, false).unit, "m");
  EXPECT_EQ(measure_info("probe.left_tip.vx", c, false).unit, "m/s");
  EXPECT_EQ(measure_info("energy.total", c, false).unit, "J");
  EXPECT_EQ(measure_info("contact.force.z", c, false).unit, "N");
  EXPECT_EQ(measure_info("step.step_size", c, false).unit, "s");
  EXPECT_EQ(measure_info("reference.rms", c, true).unit, "m");
  EXPECT_TRUE(measure_info("cpu_seconds", c, false).timing);
  EXPECT_FALSE(measure_info("steps", c, false).timing);
}

TEST(MeasureCatalogue, SaysWhatACaseDoesNotHave) {
  const Case c = small_case();
  const std::vector<std::pair<std::string, std::string>> all{
      {"probe.leff_tip.z", "'leff_tip' is not there, did you mean 'left_tip'?"},
      {"probe.left_tip.w", "'w' is not there"},
      {"energy.elastic", "accepted: kinetic, membrane"},
      {"shape.height", "no such series"},
      {"reference.rms", "there is no reference: add [reference]"},
      {"reaction.clamp.z", "accepted: none"},
      {"step", "no such number, did you mean 'steps'?"},
  };
  for (const auto& [name, message] : all) {
    try {
      (void)measure_info(name, c, false);
      ADD_FAILURE() << "accepted: " << name;
    } catch (const std::invalid_argument& problem) {
      EXPECT_NE(std::string(problem.what()).find(message), std::string::npos) << problem.what();
    }
  }
}

std::string markdown(const std::vector<MeasureInfo>& catalogue, const char* heading) {
  auto text = fmt::format("| {} | Unit | |\n|---|---|---|\n", heading);
  for (const auto& entry : catalogue)
    text += fmt::format("| `{}` | {} | {} |\n", entry.name, entry.unit == "1" ? "" : entry.unit, entry.doc);
  return text;
}

TEST(MeasureCatalogue, IsTheOneInTheDocs) {
  expect_docs_section("studies.md", "<!-- series: begin; written by the tests, see the end -->\n",
                      "<!-- series: end -->\n", markdown(series_catalogue(), "Series"));
  expect_docs_section("studies.md", "<!-- numbers: begin; written by the tests, see the end -->\n",
                      "<!-- numbers: end -->\n", markdown(number_catalogue(), "Number"));
}

}  // namespace
}  // namespace sundrape

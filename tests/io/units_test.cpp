#include "sundrape/io/units.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

// 1 gf = 9.80665e-3 N, 1 ozf = 0.028349523125 kg · 9.80665 m/s², 1 in = 0.0254 m: exact by definition.
constexpr double gf = 9.80665e-3;
constexpr double ozf = 0.028349523125 * 9.80665;
constexpr double inch = 0.0254;
constexpr double ozf_digits = 2e-7;  // UDUNITS has 0.2780139 N, seven digits of 0.27801385...

std::string complaint(std::string_view text, std::string_view unit) {
  try {
    const double value = Units().parse_quantity(text, unit);
    return "accepted as " + std::to_string(value);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
}

TEST(Units, ReadTextileQuantitiesAsSi) {
  const Units units;
  const auto expect = [&](const char* text, const char* unit, double si, double relative = 1e-14) {
    EXPECT_NEAR(units.parse_quantity(text, unit), si, relative * std::abs(si)) << text;
  };
  expect("0.0489 cm", "m", 0.000489);
  expect("0.02665 gf/cm^2", "N/m^2", 0.02665 * gf * 1e4);
  expect("0.2384e-3 gf/mm^2", "N/m^2", 0.2384e-3 * gf * 1e6);
  expect("118.1176 gf/mm^2", "N/m^2", 118.1176 * gf * 1e6);
  expect("4196 ozf/in^2", "N/m^2", 4196 * ozf / (inch * inch), ozf_digits);
  expect("4.019e-3 ozf/in^2", "N/m^2", 4.019e-3 * ozf / (inch * inch), ozf_digits);
  expect("0.589 gf*cm^2/cm", "N m", 0.589 * gf * 0.01);
  expect("1e-4 in", "m", 1e-4 * inch);
  expect("1 ms", "s", 1e-3);
  expect("2.5 1/cm", "1/m", 250);
  expect("0.1 1/s", "1/s", 0.1);
  expect("180 deg", "rad", std::numbers::pi);
  expect("-4 cm", "m", -0.04);
  expect("+4cm", "m", 0.04);
  expect("500 gf/cm^3", "N/m^3", 500 * gf * 1e6);
  expect("20 um", "m", 20e-6);
  expect("150 g/m^2", "kg/m^2", 0.15);
}

TEST(Units, ZeroOfAnyUnitIsZero) {
  const Units units;
  for (const auto* text : {"0 1/s", "0 Hz", "0"}) EXPECT_EQ(units.parse_quantity(text, "1/s"), 0) << text;
  EXPECT_EQ(units.parse_quantity("0 deg", "rad"), 0);
}

TEST(Units, TakeABareNumberForSi) { EXPECT_EQ(Units().parse_quantity(" 0.25 ", "m"), 0.25); }

TEST(Units, ReadSuperscriptsAndMiddleDots) {
  EXPECT_DOUBLE_EQ(Units().parse_quantity("1 cm²", "m^2"), 1e-4);
  EXPECT_DOUBLE_EQ(Units().parse_quantity("1 N·m", "N m"), 1);
}

TEST(Units, NameTheDimensionThatIsThereAndTheOneThatIsExpected) {
  EXPECT_EQ(complaint("0.54229 kg", "m"), "'0.54229 kg' is a mass, a length is expected");
  EXPECT_EQ(complaint("1 m", "s"), "'1 m' is a length, a time is expected");
  EXPECT_EQ(complaint("2 N/m", "N/m^2"), "'2 N/m' is a force per length, a force per area is expected");
  EXPECT_EQ(complaint("2 m", "rad"), "'2 m' is a length, an angle is expected");
  EXPECT_EQ(complaint("2 kg m", "m"), "'2 kg m' is of another dimension (kg m), a length is expected");
}

TEST(Units, DoNotTurnATimeIntoARate) {
  // UDUNITS by itself converts 2 s to 0.5 1/s
  EXPECT_EQ(complaint("2 s", "1/s"), "'2 s' is a time, a rate is expected");
}

TEST(Units, TellAnOunceFromItsWeight) {
  EXPECT_NE(complaint("4196 oz/in^2", "N/m^2").find("'oz' is a fluid ounce: write 'ozf' for the force"),
            std::string::npos);
  EXPECT_NE(complaint("0.02665 g/cm^2", "N/m^2").find("'g' is a mass: write 'gf' for the force"), std::string::npos);
  EXPECT_EQ(complaint("3 kg", "m").find("write"), std::string::npos);
}

TEST(Units, RefuseWhatIsNoFiniteNumber) {
  for (const auto* text : {"nan m", "inf m", "-inf m", "1e999 m", "1e308 Mm"})
    EXPECT_NE(complaint(text, "m").find("is not a finite number"), std::string::npos) << complaint(text, "m");
}

TEST(Units, RefuseWhatIsNoQuantity) {
  EXPECT_EQ(complaint("cm", "m"), "'cm' does not begin with a number; a length is expected, e.g. \"1 m\"");
  EXPECT_NE(complaint("", "m").find("does not begin with a number"), std::string::npos);
  EXPECT_EQ(complaint("1 furlongg", "m"), "'1 furlongg': unknown unit 'furlongg'");
  EXPECT_EQ(complaint("1 2 cm", "m"), "'1 2 cm': unknown unit '2 cm'");
}

}  // namespace
}  // namespace sundrape

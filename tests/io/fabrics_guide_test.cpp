#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "sundrape/io/case_reader.hpp"

#include "case_samples.hpp"

namespace sundrape {
namespace {

/// The TOML blocks of docs/fabrics.md as materials of the sample, by their titles.
std::map<std::string, Case> examples() {
  std::ifstream stream(std::string(SUNDRAPE_SOURCE_DIR) + "/docs/fabrics.md");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string fence = "```toml\n";
  std::map<std::string, Case> all;
  for (auto at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    Case read = parse_case(with_material(text.substr(at, text.find("```", at) - at)), "fabrics.md");
    const std::string title = read.sheet().fabric_title;
    all.emplace(title, std::move(read));
  }
  return all;
}

void expect_close(double value, double expected) { EXPECT_NEAR(value, expected, 1e-9 * expected); }

TEST(FabricsGuide, HasExamplesThatAreCases) {
  EXPECT_EQ(examples().size(), 4U);
  EXPECT_EQ(examples().at("Cotton twill, linear bending").sheet().fabric.poisson, 0);
}

// Expected: the reported numbers with their units turned to SI by hand; 1 gf = 9.80665e-3 N, 1° = π/180.

TEST(FabricsGuide, TurnsAKesReportIntoResultants) {
  const Fabric f = examples().at("Suiting, KES-FB").sheet().fabric;
  expect_close(f.area_density, 0.186);
  expect_close(f.warp_membrane, 0.62 * 500 * 0.980665 / 0.045);
  expect_close(f.weft_membrane, 0.60 * 500 * 0.980665 / 0.07);
  expect_close(f.shear_membrane, 0.62 * 0.980665 * 180 / 3.14159265358979);
  expect_close(f.warp_bending, 0.085 * 9.80665e-5);
  expect_close(f.weft_bending, 0.062 * 9.80665e-5);
}

TEST(FabricsGuide, TurnsAFastReportIntoResultants) {
  const Fabric f = examples().at("Light wool, FAST").sheet().fabric;
  expect_close(f.area_density, 0.17);
  expect_close(f.warp_membrane, 98.0665 / 0.045);
  expect_close(f.weft_membrane, 98.0665 / 0.059);
  expect_close(f.shear_membrane, 25.6);
  // B = W C³ g, reported to three digits
  EXPECT_NEAR(f.warp_bending, 0.17 * 9.80665 * std::pow(15.6e-3, 3), 2e-3 * f.warp_bending);
  EXPECT_NEAR(f.weft_bending, 0.17 * 9.80665 * std::pow(14.8e-3, 3), 2e-3 * f.weft_bending);
}

TEST(FabricsGuide, TurnsACantileverTestIntoResultants) {
  const Fabric f = examples().at("Shirting, cantilever test").sheet().fabric;
  expect_close(f.area_density, 0.145);
  expect_close(f.warp_bending, 0.145 * 9.80665 * 1.9 * 1.9 * 1.9 * 1e-6);
  expect_close(f.weft_bending, 0.145 * 9.80665 * 1.6 * 1.6 * 1.6 * 1e-6);
  expect_close(f.warp_membrane * f.thickness * f.thickness / 12, f.warp_bending);
}

}  // namespace
}  // namespace sundrape

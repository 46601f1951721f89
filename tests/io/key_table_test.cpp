#include "sundrape/io/key_table.hpp"

#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/io/nearest_name.hpp"
#include "sundrape/io/units.hpp"

#include "docs_section.hpp"

namespace sundrape {
namespace {

void expect_reference(const std::string& guide, const std::vector<Section>& table) {
  expect_docs_section(guide, "<!-- key table: begin; written by the tests, see below -->\n",
                      "<!-- key table: end -->\n", fmt::format("\n{}", key_table_markdown(table)));
}

TEST(KeyTable, IsTheReferenceInTheDocs) {
  expect_reference("case-file.md", key_table());
  expect_reference("studies.md", study_key_table());
  expect_reference("fit.md", fit_key_table());
}

TEST(KeyTable, SaysSomethingOfEveryKeyAndNamesItOnceAKind) {
  for (const auto* table : {&key_table(), &study_key_table(), &fit_key_table()})
    for (const auto& section : *table) {
      std::set<std::string> seen;
      for (const auto& key : section.keys) {
        EXPECT_FALSE(key.doc.empty()) << section.name << '.' << key.name;
        for (const auto& kind : key.kinds.empty() ? std::vector<std::string>{""} : key.kinds)
          EXPECT_TRUE(seen.insert(kind + '/' + key.name).second) << section.name << '.' << key.name << " twice";
      }
    }
}

TEST(KeyTable, HasASectionForEveryTableAndAUnitForEveryQuantity) {
  const Units units;
  for (const auto* table : {&key_table(), &study_key_table(), &fit_key_table()})
    for (const auto& section : *table)
      for (const auto& key : section.keys) {
        if (!key.holds.empty()) {
          EXPECT_NO_THROW((void)key_section(key.holds, *table)) << key.holds;
        }
        EXPECT_NO_THROW((void)units.parse_quantity(key.unit == "1" ? "1" : "1 " + key.unit, key.unit)) << key.unit;
        EXPECT_EQ(units.dimension(key.unit).find("of another dimension"), std::string::npos) << key.unit;
      }
  EXPECT_THROW((void)key_section("nothing"), std::invalid_argument);
}

TEST(Range, PrintsAndKeepsItsEnds) {
  const Range half_open{.low = 0, .high = 0.5, .low_included = true};
  EXPECT_EQ(half_open.text(), "[0, 0.5)");
  EXPECT_TRUE(half_open.contains(0));
  EXPECT_FALSE(half_open.contains(0.5));
  EXPECT_FALSE(Range{}.bounded());
}

TEST(NearestName, ForgivesOneSlipInThreeLetters) {
  EXPECT_EQ(nearest_name("poison", {"thickness", "poisson"}), "poisson");
  EXPECT_EQ(nearest_name("durtaion", {"duration", "rtol"}), "duration");  // a swap counts once
  EXPECT_EQ(nearest_name("youngs", {"warp_modulus", "youngs_modulus"}), "youngs_modulus");
  EXPECT_EQ(nearest_name("nearest", {"box", "near"}), "near");
  EXPECT_EQ(nearest_name("abc", {"xyz"}), "");
  EXPECT_EQ(nearest_name("rol", {"rtol", "role"}), "rtol");  // of equals the first
}

}  // namespace
}  // namespace sundrape

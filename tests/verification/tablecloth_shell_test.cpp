// B4 with shell elements: the tablecloth of the chapter (§4.4) at rest, from flat and by a fall.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/square_drape.hpp"

namespace sundrape {
namespace {

using namespace square_drape;

const std::string shell = "model=shell";
const std::string table_of_text = "tablecloth_static.toml", small_table = "tablecloth_small_table_static.toml";

std::string cells(int n) { return fmt::format("cloth.cells=[{},{}]", n, n); }

TEST(Tablecloth, ShellRestsStablyOnATableThatCarriesItsWeight) {
  const auto b = benchmark(table_of_text, {shell});
  expect_rest(b, rest_of("shell, 8 cm, 20²", b));
}

// Unlike the net's, a shell's drape on one mesh does not hang on the imperfection that it starts with.
TEST(TableclothVerification, ShellRestsAlikeWhateverItsWaviness) {
  for (const auto& table : {table_of_text, small_table}) {
    std::vector<Vector> rests;
    for (const int seed : {1, 2, 3}) {
      const auto b = benchmark(table, {shell, cells(40), fmt::format("cloth.waviness.seed={}", seed)});
      rests.push_back(rest_of(fmt::format("shell, {}, 40², seed {}", table, seed), b));
      expect_rest(b, rests.back());
      EXPECT_LE(nearest_image(b, rests.back(), rests.front()).max, same_branch) << table << ", seed " << seed;
    }
  }
}

/// The end of a fall through thick air against relaxation from flat.
void falls_to_the_static_state(const std::string& table, const std::string& size) {
  const auto b = benchmark(table, {shell, cells(40)});
  const Vector relaxed = rest_of("shell, relaxed from flat, " + table, b);
  expect_rest(b, relaxed);
  const auto falling = benchmark("tablecloth_damped.toml",
                                 {shell, cells(40), fmt::format("obstacle.0.size=[\"{0}\",\"{0}\",\"8 cm\"]", size)});
  const auto fall = motion(falling);
  const Vector end = fall.position.back();
  print(fmt::format("shell, damped fall, {} steps", fall.statistics.steps), falling, end);
  EXPECT_LE(deepest(falling, fall), 0.1 * thickness);
  const auto apart = nearest_image(b, end, relaxed);
  fmt::print("    fall and statics are {:.4f} mm (RMS), {:.4f} mm (max) apart, up to symmetry\n", 1e3 * apart.rms,
             1e3 * apart.max);
  EXPECT_LE(apart.max, same_branch);
}

TEST(TableclothVerification, ShellFallsToItsStaticStateOnTheTableOfTheText) {
  falls_to_the_static_state(table_of_text, "8.2 cm");
}
TEST(TableclothVerification, ShellFallsToItsStaticStateOnTheSmallTable) {
  falls_to_the_static_state(small_table, "4.2 cm");
}

}  // namespace
}  // namespace sundrape

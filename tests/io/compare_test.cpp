#include "sundrape/io/compare.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/result_info.hpp"

#include "result_samples.hpp"

namespace sundrape {
namespace {

/// A sheet that moves along x by `speed` · time, with frames every `interval` s up to 1 s.
std::filesystem::path moving_sheet(const std::filesystem::path& file, double speed, double interval, int cells = 4) {
  const auto header = samples::header(cells, 4);
  ResultWriter writer(file, header);
  for (int f = 0; f * interval <= 1 + 1e-9; ++f) {
    auto frame = samples::frame(header, 0);
    frame.variable = f * interval;
    for (int i = 0; i < header.mesh.nodes(); ++i)
      frame.position.segment<3>(3 * i) =
          header.mesh.reference[static_cast<std::size_t>(i)] + Vector3(speed * frame.variable, 0, 0);
    frame.energies.kinetic = speed;
    writer.append_frame(frame);
  }
  writer.finish(ResultStatus::done);
  return file;
}

TEST(Compare, FindsNoDistanceBetweenAResultAndItself) {
  const samples::TemporaryFolder folder;
  const ResultReader a(moving_sheet(folder.path() / "a.h5", 0.1, 0.25));
  const auto comparison = compare(a, a);
  EXPECT_EQ(comparison.last.max, 0);
  EXPECT_EQ(comparison.series.distance.size(), 5U);
  for (const auto& each : comparison.series.distance) EXPECT_EQ(each.max, 0);
}

TEST(Compare, MeasuresAShiftOverTheDiagonalAndInterpolatesInTime) {
  const samples::TemporaryFolder folder;
  const ResultReader a(moving_sheet(folder.path() / "a.h5", 0.1, 0.25));
  const ResultReader b(moving_sheet(folder.path() / "b.h5", 0.3, 0.4));  // frames at 0, 0.4, 0.8 s
  const auto comparison = compare(a, b);
  // last frames: 0.1 m/s · 1 s against 0.3 m/s · 0.8 s, the same for every node
  EXPECT_NEAR(comparison.last.rms, 0.14, 1e-12);
  EXPECT_NEAR(comparison.last.max, 0.14, 1e-12);
  EXPECT_NEAR(comparison.diagonal, 0.04 * std::sqrt(2.0), 1e-12);
  // motion is linear in time, so that linear interpolation is exact: 0.2 m/s apart at 0, 0.25, 0.5, 0.75 s
  ASSERT_EQ(comparison.series.variable.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(comparison.series.distance[i].rms, 0.2 * comparison.series.variable[i], 1e-12);
  const auto json = to_json(comparison);
  EXPECT_NEAR(json["energies"]["kinetic"]["difference"].get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(json["last_frame"]["max_over_diagonal"].get<double>(), 0.14 / comparison.diagonal, 1e-12);
  EXPECT_NE(to_text(comparison).find("max distance"), std::string::npos);
}

TEST(Compare, RefusesResultsOnDifferentMeshes) {
  const samples::TemporaryFolder folder;
  const ResultReader a(moving_sheet(folder.path() / "a.h5", 0.1, 0.5));
  const ResultReader b(moving_sheet(folder.path() / "b.h5", 0.1, 0.5, /*cells=*/5));
  EXPECT_THROW((void)compare(a, b), FileError);
}

TEST(Info, TellsWhatIsInAResult) {
  const samples::TemporaryFolder folder;
  const auto header = samples::header(4, 3);
  ResultWriter writer(folder.path() / "a.h5", header);
  samples::append(writer, header, 0);
  samples::append(writer, header, 1);
  writer.add_warning("sharp fold");
  writer.set_statistic("steps", std::int64_t{10}, "accepted steps");
  writer.finish(ResultStatus::done);
  const ResultReader reader(folder.path() / "a.h5");
  const auto json = info_json(reader);
  EXPECT_EQ(json["mesh"]["nodes"], 25);
  EXPECT_EQ(json["frames"]["count"], 2);
  EXPECT_EQ(json["frames"]["last"], 0.01);
  EXPECT_EQ(json["last_frame"]["energy"]["membrane"], 2.0);  // samples: frame number + 1
  EXPECT_EQ(json["statistics"]["steps"], 10);
  const auto text = info_text(reader);
  for (const auto* const part : {"sharp fold", "accepted steps", "25 nodes", "status      done"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
}

}  // namespace
}  // namespace sundrape

#include "sundrape/io/result_writer.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "sundrape/io/result_layout.hpp"

#include "result_samples.hpp"

namespace sundrape {
namespace {

class AResult : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "out.h5"; }
  samples::TemporaryFolder folder_;
};

/// Every dataset of a file, by path.
void collect_datasets(const hdf5::File& file, const std::string& group, std::vector<std::string>& datasets) {
  for (const auto& name : file.children(group)) {
    const auto path = (group == "/" ? "" : group) + "/" + name;
    bool is_group = true;
    try {
      (void)file.dataset(path);
      is_group = false;
    } catch (const FileError&) {
    }
    if (is_group)
      collect_datasets(file, path, datasets);
    else
      datasets.push_back(path);
  }
}

TEST_F(AResult, IsReadableWithAllItsFramesWhileItIsWritten) {
  const auto header = samples::header(4, 3);
  ResultWriter writer(file(), header);
  EXPECT_EQ(ResultReader(file()).frames(), 0U);
  for (std::uint64_t f = 0; f < 20; ++f) {
    samples::append(writer, header, f);
    const ResultReader reader(file());
    EXPECT_EQ(reader.frames(), f + 1);
    EXPECT_EQ(reader.steps(), 5 * (f + 1));
    EXPECT_EQ(reader.status(), "running");
    EXPECT_EQ(samples::complaint(reader), "");
  }
}

TEST_F(AResult, KeepsTheFieldsOfAShell) {
  auto header = samples::header(4, 3);
  header.director = header.element_fields = true;
  ResultWriter writer(file(), header);
  for (std::uint64_t f = 0; f < 5; ++f) samples::append(writer, header, f);
  writer.finish(ResultStatus::done, "");
  const ResultReader reader(file());
  EXPECT_TRUE(reader.has_director());
  EXPECT_TRUE(reader.has_element_fields());
  EXPECT_EQ(samples::complaint(reader), "");
  for (const auto& [name, components] : layout::element_fields())
    EXPECT_EQ(reader.file().dataset("/frames/element/" + std::string(name)).shape(),
              (std::vector<std::uint64_t>{5, 16, static_cast<std::uint64_t>(components)}));
}

TEST_F(AResult, SaysWhatItWasMadeOf) {
  auto header = samples::header(4, 3);
  header.obstacles.front().rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  ResultWriter writer(file(), header);
  samples::append(writer, header, 0);
  writer.add_warning("the sheet is stiff");
  writer.set_statistic("steps", std::int64_t{5}, "accepted steps");
  writer.set_statistic("cpu_time", 0.5, "CPU time [s]");
  writer.set_statistic("steps", std::int64_t{6}, "accepted steps");
  writer.finish(ResultStatus::failed, "no convergence at 0.1 s");
  const ResultReader reader(file());
  EXPECT_EQ(reader.title(), header.title);
  EXPECT_EQ(reader.case_text(), header.case_text);
  EXPECT_EQ(reader.status(), "failed");
  EXPECT_EQ(reader.message(), "no convergence at 0.1 s");
  EXPECT_EQ(reader.mesh().quads, header.mesh.quads);
  EXPECT_EQ(reader.mesh().sets, header.mesh.sets);
  EXPECT_EQ(reader.warnings(), std::vector<std::string>{"the sheet is stiff"});
  ASSERT_EQ(reader.statistics().size(), 2U);
  EXPECT_EQ(std::get<double>(reader.statistics()[0].value), 0.5);
  EXPECT_EQ(std::get<std::int64_t>(reader.statistics()[1].value), 6);
  EXPECT_EQ(reader.statistics()[1].description, "accepted steps");
  ASSERT_EQ(reader.obstacles().size(), 1U);
  EXPECT_EQ(reader.obstacles()[0].parameters, header.obstacles[0].parameters);
  EXPECT_EQ(reader.obstacles()[0].rotation, header.obstacles[0].rotation);
  EXPECT_EQ(reader.probes().at("root").node, 0);
}

TEST_F(AResult, SumsTheContactForces) {
  const auto header = samples::header(1, 3);
  ResultWriter writer(file(), header);
  auto frame = samples::frame(header, 0);
  frame.contact_force << 1, 2, 3, 10, 20, 30, 100, 200, 300, 1000, 2000, 3000;
  writer.append_frame(frame);
  EXPECT_EQ(ResultReader(file()).contact_force_sum().at(0), Vector3(1111, 2222, 3333));
}

TEST_F(AResult, GivesUnitsAndDescriptionOfEveryDataset) {
  auto header = samples::header(4, 3);
  header.director = true;
  ResultWriter writer(file(), header);
  samples::append(writer, header, 0);
  writer.finish(ResultStatus::done);
  const auto content = hdf5::File::open(file());
  std::vector<std::string> datasets;
  collect_datasets(content, "/", datasets);
  EXPECT_GT(datasets.size(), 30U);
  for (const auto& path : datasets) {
    EXPECT_FALSE(content.text_attribute(path, "units").empty()) << path;
    EXPECT_FALSE(content.text_attribute(path, "description").empty()) << path;
  }
}

TEST_F(AResult, KeepsItsContentWhenItIsCompactedAndTakesNoMoreThanItsNumbers) {
  const auto header = samples::header(20, 1000);
  ResultWriter writer(file(), header);
  for (std::uint64_t f = 0; f < 10; ++f) samples::append(writer, header, f);
  const auto spacious = std::filesystem::file_size(file());
  writer.finish(ResultStatus::done);
  EXPECT_EQ(samples::complaint(ResultReader(file())), "");
  const auto numbers = 10 * 441 * (3 + 3 + 3 + 1) * 8;  // position, velocity, contact force, energy density
  EXPECT_GT(spacious, 50U * numbers);                   // space for 1000 frames
  EXPECT_LT(std::filesystem::file_size(file()), numbers + 100000U);
}

TEST_F(AResult, KeepsItsContentWhenItIsDeflated) {
  const auto header = samples::header(20, 10);
  ResultWriter writer(file(), header);
  for (std::uint64_t f = 0; f < 10; ++f) samples::append(writer, header, f);
  writer.finish(ResultStatus::done, {}, /*deflate=*/6);
  EXPECT_EQ(samples::complaint(ResultReader(file())), "");
  EXPECT_LT(std::filesystem::file_size(file()), 10U * 441 * 9 * 8);
}

TEST_F(AResult, GoesOnFromItsCheckpointWithoutWhatCameAfterIt) {
  const auto header = samples::header(4, 3);
  {
    ResultWriter writer(file(), header);
    for (std::uint64_t f = 0; f < 6; ++f) samples::append(writer, header, f);
    writer.write_checkpoint({.arrays = {{"q", {1, 2, 3}}}});
    for (std::uint64_t f = 6; f < 9; ++f) samples::append(writer, header, f);
    writer.add_warning("to be forgotten");
    samples::append(writer, header, 9);
  }
  {
    const ResultReader earlier(file());
    EXPECT_EQ(earlier.frames(), 10U);
    ASSERT_TRUE(earlier.checkpoint());
    EXPECT_EQ(earlier.checkpoint()->frames, 6U);
    auto writer = ResultWriter::resume(file(), header, earlier);
    EXPECT_EQ(ResultReader(file()).frames(), 6U);
    for (std::uint64_t f = 6; f < 12; ++f) samples::append(writer, header, f);
    writer.finish(ResultStatus::interrupted);
  }
  const ResultReader reader(file());
  EXPECT_EQ(reader.frames(), 12U);
  EXPECT_EQ(reader.steps(), 60U);
  EXPECT_TRUE(reader.warnings().empty());
  EXPECT_EQ(samples::complaint(reader), "");
  EXPECT_EQ(reader.checkpoint()->arrays.at("q"), (std::vector<double>{1, 2, 3}));  // still there to go on from
}

TEST_F(AResult, KeepsTheNewestOfItsCheckpointsAlsoWhenTheirSizesChange) {
  const auto header = samples::header(4, 3);
  ResultWriter writer(file(), header);
  for (int number = 1; number < 8; ++number) {
    const std::size_t size = number < 5 ? 3 : 4;
    writer.write_checkpoint({.arrays = {{"q", std::vector<double>(size, number)}, {"none", {}}}});
    EXPECT_EQ(ResultReader(file()).checkpoint()->arrays.at("q"), std::vector<double>(size, number));
  }
}

TEST_F(AResult, RefusesToGoOnWithoutACheckpointOrOnAnotherMesh) {
  const auto header = samples::header(4, 3);
  { ResultWriter writer(file(), header); }
  const ResultReader earlier(file());
  EXPECT_THROW((void)ResultWriter::resume(file(), header, earlier), FileError);
  EXPECT_THROW((void)ResultWriter::resume(file(), samples::header(5, 3), earlier), FileError);
}

TEST_F(AResult, RefusesArraysOfTheWrongSizeAndUnknownSteps) {
  const auto header = samples::header(4, 3);
  ResultWriter writer(file(), header);
  auto frame = samples::frame(header, 0);
  frame.velocity.resize(3);
  EXPECT_THROW(writer.append_frame(frame), std::invalid_argument);
  EXPECT_THROW(writer.append_step({{"stepsize", 1.0}}), std::invalid_argument);
  samples::append(writer, header, 0);  // nothing of the refused ones is left behind
  EXPECT_EQ(samples::complaint(ResultReader(file())), "");
}

TEST_F(AResult, ReportsMissingFoldersAndForeignFiles) {
  EXPECT_THROW(ResultWriter(folder_.path() / "nowhere" / "out.h5", samples::header(1, 1)), FileError);
  try {
    (void)ResultReader(folder_.path() / "missing.h5");
    FAIL() << "a missing file was opened";
  } catch (const FileError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("missing.h5"), std::string::npos) << text;
    EXPECT_NE(text.find("No such file"), std::string::npos) << text;
  }
}

/// Writes 40 frames with room for 20, of which a limit on the file's size lets some through. Runs in a child.
int write_against_a_limit(const std::filesystem::path& file, rlim_t bytes) {
  const auto header = samples::header(20, 20);
  ResultWriter writer(file, header);
  for (std::uint64_t f = 0; f < 5; ++f) samples::append(writer, header, f);
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  try {
    for (std::uint64_t f = 5; f < 40; ++f) samples::append(writer, header, f);
    return 1;
  } catch (const FileError&) {
  }
  try {
    writer.finish(ResultStatus::failed, "disk full");
  } catch (const FileError&) {  // the frame that waited is lost, unless a compact file has space for it
  }
  return 0;
}

TEST_F(AResult, KeepsItsFramesAndTakesAStatusWhenTheDiskRefusesMore) {
  for (const rlim_t bytes : {200000U, 1000000U}) {  // too little for a second file, and enough for a compact one
    std::filesystem::remove(file());
    EXPECT_EXIT(std::exit(write_against_a_limit(file(), bytes)), testing::ExitedWithCode(0), "");
    const ResultReader reader(file());
    EXPECT_GE(reader.frames(), 5U);
    EXPECT_LE(reader.frames(), 21U);
    EXPECT_EQ(reader.status(), "failed");
    EXPECT_EQ(reader.message(), "disk full");
    EXPECT_EQ(samples::complaint(reader), "");
    EXPECT_FALSE(std::filesystem::exists(file().string() + ".tmp"));
  }
}

TEST_F(AResult, KeepsItsFramesWhenTheDiskIsFull) {
  const auto disk = folder_.path() / "disk";
  std::filesystem::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=2m") != 0) GTEST_SKIP() << "only root can mount a small disk";
  std::uint64_t frames = 0;
  {
    const auto header = samples::header(20, 500);
    ResultWriter writer(disk / "out.h5", header);
    EXPECT_THROW(for (; frames < 500; ++frames) samples::append(writer, header, frames), FileError);
    EXPECT_THROW(writer.finish(ResultStatus::failed, "disk full"), FileError);
    const ResultReader reader(disk / "out.h5");
    EXPECT_GT(frames, 5U);
    EXPECT_EQ(reader.frames(), frames);
    EXPECT_EQ(reader.status(), "failed");
    EXPECT_EQ(samples::complaint(reader), "");
  }
  ::umount(disk.c_str());
}

}  // namespace
}  // namespace sundrape

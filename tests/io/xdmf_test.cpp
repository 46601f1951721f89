#include "sundrape/io/xdmf.hpp"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "result_samples.hpp"

namespace sundrape {
namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Xdmf, DescribesEveryFrameAsSlabsOfTheResultBesideIt) {
  const samples::TemporaryFolder folder;
  const auto header = samples::header(2, 4);
  XdmfWriter writer(folder.path() / "a & b.h5", header);
  for (int f = 0; f < 3; ++f) writer.add_frame(0.5 * f);
  writer.write();
  const auto text = content(folder.path() / "a & b.xdmf");
  EXPECT_EQ(occurrences(text, "GridType=\"Uniform\""), 3U);
  EXPECT_EQ(occurrences(text, "CollectionType=\"Temporal\""), 1U);
  EXPECT_EQ(occurrences(text, "a &amp; b.h5:/frames/velocity"), 3U);  // relative and escaped
  EXPECT_EQ(occurrences(text, ">2 0 0 1 1 1 1 9 3<"), 3U);            // third frame, 9 nodes: geometry and two vectors
  EXPECT_EQ(occurrences(text, "<Time Value=\"1\"/>"), 1U);
}

TEST(Xdmf, IsThereAfterTheFirstFrameAndNotRewrittenForEveryOneInHaste) {
  const samples::TemporaryFolder folder;
  XdmfWriter writer(folder.path() / "a.h5", samples::header(2, 4));
  writer.add_frame(0);
  EXPECT_EQ(occurrences(content(writer.path()), "GridType=\"Uniform\""), 1U);
  writer.add_frame(1);  // within a second of the first
  EXPECT_EQ(occurrences(content(writer.path()), "GridType=\"Uniform\""), 1U);
  writer.write();
  EXPECT_EQ(occurrences(content(writer.path()), "GridType=\"Uniform\""), 2U);
}

}  // namespace
}  // namespace sundrape

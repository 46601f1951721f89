#include "sundrape/io/fingerprint.hpp"

#include <fstream>

#include <gtest/gtest.h>

namespace sundrape {
namespace {

TEST(Fingerprint, IsThatOfTheContents) {
  const auto file = std::filesystem::temp_directory_path() / "sundrape-fingerprint.txt";
  const auto of = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    return fingerprint(file);
  };
  // values of the reference of FNV-1a (Fowler, Noll, Vo)
  EXPECT_EQ(of(""), "cbf29ce484222325");
  EXPECT_EQ(of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(of("foobar"), "85944171f73967e8");
  EXPECT_NE(of(std::string(100000, 'x')), of(std::string(100000, 'x') + "y"));
  std::filesystem::remove(file);
  EXPECT_EQ(fingerprint(file), "missing");
}

}  // namespace
}  // namespace sundrape

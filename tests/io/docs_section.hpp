#pragma once
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace sundrape {

/// Holds what stands between two lines of a page in docs/ against what it should be; with SUNDRAPE_UPDATE_DOCS in the
/// environment it is put there instead.
inline void expect_docs_section(const std::string& guide, const std::string& begin_mark, const std::string& end_mark,
                                const std::string& expected) {
  const auto path = std::string(SUNDRAPE_SOURCE_DIR) + "/docs/" + guide;
  std::ifstream stream(path);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const auto begin = text.find(begin_mark);
  const auto end = text.find(end_mark);
  ASSERT_NE(begin, std::string::npos) << guide;
  ASSERT_NE(end, std::string::npos) << guide;
  const auto from = begin + begin_mark.size();
  if (std::getenv("SUNDRAPE_UPDATE_DOCS") != nullptr) {
    text.replace(from, end - from, expected);
    std::ofstream(path) << text;
    return;
  }
  EXPECT_EQ(text.substr(from, end - from), expected)
      << "run the tests once with SUNDRAPE_UPDATE_DOCS=1 to bring docs/" << guide << " up to date";
}

}  // namespace sundrape

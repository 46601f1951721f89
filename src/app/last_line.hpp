#pragma once
#include <filesystem>
#include <fstream>
#include <string>

namespace sundrape {

/// The last line of a log that says something: what a process that failed ended with.
inline std::string last_line(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string line, last;
  while (std::getline(stream, line))
    if (!line.empty()) last = line;
  return last;
}

}  // namespace sundrape

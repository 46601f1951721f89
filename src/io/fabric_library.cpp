#include "fabric_library.hpp"

#include <algorithm>
#include <system_error>

// Both are the build system's to say.
#if !defined(SUNDRAPE_FABRICS_FROM_EXECUTABLE) || !defined(SUNDRAPE_SOURCE_FABRICS)
#error "where fabrics are installed, and where they are in the source tree"
#endif

namespace sundrape {
namespace {

constexpr const char* extension = ".toml";

/// The folder of the program that runs, empty if the system does not say.
std::filesystem::path executable_folder() {
  std::error_code problem;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", problem);
  return problem ? std::filesystem::path() : executable.parent_path();
}

}  // namespace

FabricLibrary::FabricLibrary(std::filesystem::path case_folder) : case_folder_(std::move(case_folder)) {
  shelves_ = {case_folder_ / "fabrics"};
  if (const auto folder = executable_folder(); !folder.empty())
    shelves_.push_back((folder / SUNDRAPE_FABRICS_FROM_EXECUTABLE).lexically_normal());
  shelves_.emplace_back(SUNDRAPE_SOURCE_FABRICS);
}

std::optional<std::filesystem::path> FabricLibrary::find(const std::string& name) const {
  std::vector<std::filesystem::path> candidates;
  if (name.ends_with(extension))
    candidates.push_back(case_folder_ / name);
  else if (!name.empty())
    for (const auto& shelf : shelves_) candidates.push_back(shelf / (name + extension));
  for (auto& candidate : candidates) {
    std::error_code unreadable;  // as good as absent
    if (std::filesystem::is_regular_file(candidate, unreadable)) return std::move(candidate);
  }
  return std::nullopt;
}

std::vector<std::string> FabricLibrary::names() const {
  std::vector<std::string> all;
  for (const auto& shelf : shelves_) {
    std::error_code absent;
    for (const auto& entry : std::filesystem::directory_iterator(shelf, absent))
      if (entry.path().extension() == extension) all.push_back(entry.path().stem().string());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace sundrape

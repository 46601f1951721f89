#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sundrape {

/// Files with a fabric each, looked up by name: in `fabrics` beside the case file, then among those installed with the
/// running executable, then in the source tree that this library was built from.
class FabricLibrary {
 public:
  /// @param case_folder  where relative paths of the case count from
  explicit FabricLibrary(std::filesystem::path case_folder);

  /// The file of a fabric; a name that ends in ".toml" is its path. Nothing if there is none.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name) const;
  /// The names that find() knows, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path case_folder_;
  std::vector<std::filesystem::path> shelves_;
};

}  // namespace sundrape

#pragma once
#include <filesystem>

namespace sundrape {

/// Replaces a file as a whole: the new one is written as NAME.tmp beside it and renamed over it, which is atomic, so
/// that at every moment there is either the old file or the new one. Without commit() the new one is removed.
class ReplaceFile {
 public:
  explicit ReplaceFile(std::filesystem::path path);
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;
  ~ReplaceFile();

  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

  enum class Durability { process, disk };  // what the new file survives: a kill, or a power cut as well
  /// @throws FileError
  void commit(Durability durability = Durability::disk);

 private:
  std::filesystem::path path_, temporary_;
  bool committed_ = false;
};

}  // namespace sundrape

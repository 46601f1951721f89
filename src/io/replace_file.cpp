#include "sundrape/io/replace_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "sundrape/io/file_error.hpp"

namespace sundrape {
namespace {

void synchronise(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) ::close(file);
  // some file systems cannot synchronise a folder: EINVAL is no loss of data
  if (!done && reason != EINVAL)
    throw FileError(fmt::format("{}: cannot write to the disk: {}", path.string(), std::strerror(reason)));
}

}  // namespace

ReplaceFile::ReplaceFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".tmp";
}

ReplaceFile::~ReplaceFile() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(temporary_, ignored);
}

void ReplaceFile::commit(Durability durability) {
  if (durability == Durability::disk) synchronise(temporary_, O_RDWR);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0)
    throw FileError(
        fmt::format("{}: cannot rename {} to it: {}", path_.string(), temporary_.string(), std::strerror(errno)));
  committed_ = true;
  const auto folder = path_.parent_path();
  if (durability == Durability::disk) synchronise(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

}  // namespace sundrape

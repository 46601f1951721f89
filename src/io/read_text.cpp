#include "read_text.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace sundrape {

std::string read_text(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file))
    throw std::system_error(std::make_error_code(std::errc::is_a_directory), file.string());
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), file.string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace sundrape

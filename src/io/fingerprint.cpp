#include "sundrape/io/fingerprint.hpp"

#include <array>
#include <cstdint>
#include <fstream>

#include <fmt/format.h>

namespace sundrape {

std::string fingerprint(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "missing";
  std::uint64_t hash = 0xcbf29ce484222325;
  std::array<char, 65536> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
    for (std::streamsize i = 0; i < stream.gcount(); ++i)
      hash = (hash ^ static_cast<unsigned char>(block[static_cast<std::size_t>(i)])) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace sundrape

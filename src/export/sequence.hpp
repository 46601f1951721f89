#pragma once
#include <filesystem>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"

namespace sundrape {

/// A file a frame, each written by write_one(k, file): NAME.ext of one frame, else NAME_0000.ext by the frame's number.
template <class WriteOne>
WrittenFiles write_sequence(const ExportScene& scene, const std::filesystem::path& file, const WriteOne& write_one) {
  WrittenFiles written;
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    auto path = file;
    if (scene.frames() > 1)
      path.replace_filename(
          fmt::format("{}_{:04}{}", file.stem().string(), scene.frame_numbers()[k], file.extension().string()));
    write_one(k, path);
    written.push_back(path);
  }
  return written;
}

}  // namespace sundrape

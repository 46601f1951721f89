#include "sundrape/export/export_result.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/export/frame_range.hpp"

namespace sundrape {
namespace {

using Writer = WrittenFiles (*)(const ExportScene&, const std::filesystem::path&);

const std::map<std::string, Writer>& writers() {
  static const std::map<std::string, Writer> all{{".vtkhdf", write_vtkhdf}, {".xdmf", write_xdmf}, {".glb", write_gltf},
                                                 {".obj", write_obj},       {".ply", write_ply},   {".mdd", write_mdd},
                                                 {".csv", write_csv}};
  return all;
}

}  // namespace

std::vector<std::string> export_formats() {
  std::vector<std::string> endings;
  for (const auto& [ending, writer] : writers()) endings.push_back(ending);
  return endings;
}

WrittenFiles export_result(const ExportOptions& options) {
  auto ending = options.output.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = writers().find(ending);
  if (found == writers().end())
    throw std::invalid_argument(
        fmt::format("{}: the name must end in one of {}", options.output.string(), fmt::join(export_formats(), ", ")));
  const ResultReader result(options.result);
  if (result.frames() == 0) throw FileError(fmt::format("{}: holds no frames to export", options.result.string()));
  const ExportScene scene(result, select_frames(options.frames, result.frames()), options.obstacles);
  return found->second(scene, options.output);
}

}  // namespace sundrape

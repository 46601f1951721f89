#pragma once
#include <string>

#include "sundrape/export/scene.hpp"

namespace sundrape {

/// A frame as the text of a Wavefront OBJ, with or without the obstacles. Coordinates in full double precision.
[[nodiscard]] std::string obj_text(const ExportScene& scene, std::size_t frame, bool with_obstacles);

}  // namespace sundrape

#pragma once
#include <filesystem>
#include <vector>

#include "sundrape/export/scene.hpp"

/// One writer a format. Each returns the files that it wrote and throws FileError where it cannot.
namespace sundrape {

using WrittenFiles = std::vector<std::filesystem::path>;

/// VTKHDF 2.0, an unstructured grid with steps in time: ParaView 5.12 and later. Cloth and obstacles are cells of one
/// grid, told apart by the cell field `part`: 0 is the cloth, k the k-th obstacle.
WrittenFiles write_vtkhdf(const ExportScene& scene, const std::filesystem::path& file);

/// XDMF 3 and its data NAME-xdmf.h5 beside it: any ParaView. A block for the cloth and one for each obstacle.
WrittenFiles write_xdmf(const ExportScene& scene, const std::filesystem::path& file);

/// Binary glTF 2.0: the first frame, and every other one as a morph target that an animation turns on in its time.
WrittenFiles write_gltf(const ExportScene& scene, const std::filesystem::path& file);

/// Wavefront OBJ with normals and texture coordinates; of several frames NAME_0000.obj and so on, by frame number.
WrittenFiles write_obj(const ExportScene& scene, const std::filesystem::path& file);

/// Stanford PLY, binary, with normals, texture coordinates and fields at each vertex; of several frames as for OBJ.
WrittenFiles write_ply(const ExportScene& scene, const std::filesystem::path& file);

/// A point cache (Lightwave MDD) of the cloth, and its first frame as NAME.obj, the mesh to put it on.
WrittenFiles write_mdd(const ExportScene& scene, const std::filesystem::path& file);

/// Tables: a row a frame, with energies, forces and the probed nodes; NAME-steps.csv and NAME-probes.csv have a row an
/// accepted step.
WrittenFiles write_csv(const ExportScene& scene, const std::filesystem::path& file);

}  // namespace sundrape

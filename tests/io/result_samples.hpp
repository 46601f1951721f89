#pragma once
#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

#include "sundrape/io/result.hpp"
#include "sundrape/io/result_reader.hpp"
#include "sundrape/io/result_writer.hpp"

/// Results whose every number follows from its frame, node and component, so that a reader can tell right from wrong.
namespace sundrape::samples {

/// A folder of its own that goes with its owner.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
    static int count = 0;
    path_ = parent / ("sundrape-result-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A flat sheet of cells × cells unit quads of 1 cm.
inline QuadMesh sheet(int cells) {
  QuadMesh mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      mesh.reference.emplace_back(0.01 * i, 0.01 * j, 0);
      mesh.material.emplace_back(0.01 * i, 0.01 * j);
      mesh.sets["all"].push_back(mesh.nodes() - 1);
      if (i == 0) mesh.sets["left"].push_back(mesh.nodes() - 1);
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int corner = j * (cells + 1) + i;
      mesh.quads.push_back({corner, corner + 1, corner + cells + 2, corner + cells + 1});
    }
  return mesh;
}

inline ResultHeader header(int cells, std::uint64_t expected_frames) {
  ResultHeader header;
  header.title = "A sample – ½ sheet";
  header.model = "particle";
  header.analysis = "dynamics";
  header.case_text = "title = \"A sample\"\n";
  header.version = "0.1.0";
  header.mesh = sheet(cells);
  header.expected_frames = expected_frames;
  header.reaction_sets = {"left"};
  header.probes = {{"tip", header.mesh.nodes() - 1}, {"root", 0}};
  header.step_columns = dynamics_step_columns();
  header.obstacles = {{"table", "box", {{"size", {0.08, 0.08, 0.08}}, {"edge_radius", {0.001}}}, {0, 0, -0.04}}};
  return header;
}

/// Entry `i` of the array numbered `array` in frame `frame`. The factors are powers of two, whose products are exact:
/// the same number comes out whether or not the compiler contracts it to a fused multiply-add, which it decides anew at
/// every place.
inline double entry(std::uint64_t frame, int array, Eigen::Index i) {
  return std::sin(0.125 * static_cast<double>(frame) + array) + 0x1p-10 * static_cast<double>(i);
}

inline Vector entries(std::uint64_t frame, int array, Eigen::Index size) {
  return Vector::NullaryExpr(size, [&](Eigen::Index i) { return entry(frame, array, i); });
}

inline double frame_time(std::uint64_t frame) { return 0.01 * static_cast<double>(frame); }

inline Frame frame(const ResultHeader& header, std::uint64_t number) {
  const Eigen::Index size = 3 * header.mesh.nodes();
  Frame frame;
  frame.variable = frame_time(number);
  frame.position = entries(number, 1, size);
  frame.velocity = entries(number, 2, size);
  frame.contact_force = entries(number, 3, size);
  if (header.director) frame.director = entries(number, 4, size);
  const auto n = static_cast<double>(number);
  frame.energies = {n, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6, n + 7, n + 8};
  frame.residual = n + 9;
  frame.negative_pivots = static_cast<int>(number);
  frame.penetration = n + 10;
  frame.reactions = {{n, n + 1, n + 2}};
  frame.moments = {{n + 3, n + 4, n + 5}};
  if (header.element_fields) {
    const auto elements = static_cast<Eigen::Index>(header.mesh.quads.size());
    auto& e = frame.elements;
    e = {entries(number, 5, 3 * elements), entries(number, 6, 3 * elements), entries(number, 7, 2 * elements),
         entries(number, 8, 2 * elements), entries(number, 9, 3 * elements), entries(number, 10, 3 * elements)};
  }
  return frame;
}

/// `per_frame` steps up to a frame, then the frame.
inline void append(ResultWriter& writer, const ResultHeader& header, std::uint64_t number, int per_frame = 5) {
  for (int step = 0; step < per_frame; ++step) {
    const double index = static_cast<double>(number) * per_frame + step;
    writer.append_step({{"time", index}, {"step_size", index + 0.5}, {"order", 2}, {"contacts", index}});
    writer.append_probes(index, entries(number, 1, 3 * header.mesh.nodes()),
                         entries(number, 2, 3 * header.mesh.nodes()));
  }
  writer.append_frame(frame(header, number));
}

/// What is wrong with a result written by append(); empty if nothing is.
inline std::string complaint(const ResultReader& reader) {
  const auto at = [](const char* what, std::uint64_t number) {
    return std::string(what) + " of row " + std::to_string(number);
  };
  const Eigen::Index size = 3 * reader.mesh().nodes();
  const auto energies = reader.energies();
  const auto reactions = reader.reactions();
  const auto moments = reader.reaction_moments();
  const auto pivots = reader.negative_pivots();
  for (std::uint64_t f = 0; f < reader.frames(); ++f) {
    if (reader.frame_values()[f] != frame_time(f)) return at("time", f);
    if (reader.position(f) != entries(f, 1, size)) return at("position", f);
    if (reader.velocity(f) != entries(f, 2, size)) return at("velocity", f);
    if (reader.contact_force(f) != entries(f, 3, size)) return at("contact force", f);
    if (energies.at("method_dissipated")[f] != static_cast<double>(f) + 8) return at("energy", f);
    if (reactions.at("left")[f].z() != static_cast<double>(f) + 2) return at("reaction", f);
    if (moments.at("left")[f].x() != static_cast<double>(f) + 3) return at("reaction moment", f);
    if (reader.has_element_fields()) {
      const auto quads = static_cast<Eigen::Index>(reader.mesh().quads.size());
      const auto e = reader.element_fields(f);
      if (e.membrane_force != entries(f, 6, 3 * quads)) return at("membrane force", f);
      if (e.shear_strain != entries(f, 7, 2 * quads)) return at("shear strain", f);
      if (e.moment != entries(f, 10, 3 * quads)) return at("moment", f);
    }
    if (pivots[f] != static_cast<std::int64_t>(f)) return at("negative pivots", f);
  }
  const auto steps = reader.step_columns();
  for (std::size_t s = 0; s < reader.steps(); ++s)
    if (steps.at("time")[s] != static_cast<double>(s) || steps.at("step_size")[s] != static_cast<double>(s) + 0.5 ||
        steps.at("contacts")[s] != static_cast<double>(s))
      return at("step", s);
  for (const auto& [name, probe] : reader.probes())
    for (std::size_t s = 0; s < probe.time.size(); ++s) {
      const auto f = s / 5;
      if (probe.time[s] != static_cast<double>(s) || probe.position[s].y() != entry(f, 1, 3 * probe.node + 1))
        return at("probe", s);
    }
  return {};
}

}  // namespace sundrape::samples

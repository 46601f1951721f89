#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sundrape/io/growing_file.hpp"
#include "sundrape/io/result.hpp"

namespace sundrape::layout {

/// Version of the layout of result files: changes when a reader of the old one could go wrong.
inline constexpr int format_version = 1;

/// What a dataset's attributes say.
struct Meaning {
  std::string_view path, units, description;
};

/// The meaning of a dataset; of probes, reactions and mesh sets by their pattern ("/probes/*/time").
/// @throws std::invalid_argument  a path that the layout does not have
[[nodiscard]] Meaning meaning(const std::string& path);

/// Every dataset of a result file, in the order of the documentation.
[[nodiscard]] const std::vector<Meaning>& all();

/// Names under /frames/energy, in the order of FrameEnergies, and its members in that order.
[[nodiscard]] const std::vector<std::string>& energy_names();
[[nodiscard]] std::vector<double> energy_values(const FrameEnergies& energies);

/// Names under /frames/element with their numbers of components, in the order of ElementFields, and its members.
[[nodiscard]] const std::vector<std::pair<std::string_view, int>>& element_fields();
[[nodiscard]] std::vector<const Vector*> element_values(const ElementFields& e);

/// The growing parts of a result, in the order in which they are published.
enum SeriesIndex : std::size_t { warnings, steps, probes, iterations, critical, frames, count };
[[nodiscard]] std::vector<Series> series(const ResultHeader& header);

/// A name as it can stand in a path: slashes become underscores, and there is at least one character.
[[nodiscard]] std::string link_name(std::string name);

/// "/frames/time" or "/frames/load_factor".
[[nodiscard]] std::string frame_variable_path(FrameVariable variable);

}  // namespace sundrape::layout

#pragma once
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// How far two results on the same mesh are apart.
struct Comparison {
  struct Distance {
    double rms = 0, max = 0;  // over the nodes [m]
  };
  std::string a, b;               // names of the files
  double diagonal = 0;            // of the cloth's rest shape [m]
  double last_a = 0, last_b = 0;  // time or load factor of the frames compared: the last ones
  Distance last;
  int farthest_node = -1;                            // where last.max is
  std::map<std::string, double> energy_a, energy_b;  // at the last frames [J]

  /// At the frame times of `a` inside the interval that both cover; `b` is interpolated linearly between its frames.
  struct Series {
    std::vector<double> variable;
    std::vector<Distance> distance;
  } series;
};

/// @throws FileError  another mesh (nodes, quads, or rest positions to 1e-9 of the diagonal), or a result without
/// frames
[[nodiscard]] Comparison compare(const ResultReader& a, const ResultReader& b);

[[nodiscard]] nlohmann::json to_json(const Comparison& comparison);
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace sundrape

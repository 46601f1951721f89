#pragma once
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace sundrape {

/// End states that are the same drape.
struct Drape {
  std::vector<std::size_t> members;  // ascending
  std::size_t representative = 0;    // the member of least energy
  double spread = 0;                 // farthest member from the representative, as in the distances
};

/// Sorts states into drapes: two states nearer than the threshold belong to one, and so do all that are linked by such
/// pairs (single linkage, which no order of the states can change).
///
/// The drape with the most members comes first; of equals the one of less energy, then of the smaller first member.
/// @param distances  n × n, symmetric
/// @param energies   n
[[nodiscard]] std::vector<Drape> sort_into_drapes(const Eigen::MatrixXd& distances, const std::vector<double>& energies,
                                                  double threshold);

}  // namespace sundrape

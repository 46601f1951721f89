#pragma once
#include <utility>
#include <vector>

#include "sundrape/mesh/quad_mesh.hpp"

namespace sundrape {

/// How far the edges of a sheet are stretched.
class EdgeStrains {
 public:
  EdgeStrains() = default;
  explicit EdgeStrains(const QuadMesh& mesh);

  /// Smallest and largest Δl/l over all edges.
  /// @param q  coordinates that begin with those of the nodes, 3N or more [m]
  [[nodiscard]] std::pair<double, double> range(ConstVectorRef q) const;

  struct Stretched {
    int i = -1, j = -1;  // its nodes
    double strain = 0;
  };
  /// The edge with the largest strain; none (−1) where all are shorter than at rest.
  [[nodiscard]] Stretched most_stretched(ConstVectorRef q) const;

 private:
  struct Length {
    int i, j;
    double rest;
  };
  std::vector<Length> edges_;
};

}  // namespace sundrape

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sundrape/force/separation.hpp"
#include "sundrape/mesh/sheet_surface.hpp"

namespace sundrape {

/// Two parts of the cloth that may touch.
struct ClothPair {
  Shapes shapes;
  std::array<int, 4> points;  // nodes; unused ones, −1, come last
  double area;                // of the cloth that the pair stands for [m²]; negative where it corrects for others
  double thickness = 0;       // at which distance the two lie on each other [m]
  double parallel2 = 0;       // of edges u and v: |u × v|² below which they count as parallel [m⁴]

  /// Where the points are; unused ones at the origin.
  [[nodiscard]] std::array<Vector3, 4> at(const ConstVectorRef& q) const {
    std::array<Vector3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = points[k] < 0 ? Vector3(Vector3::Zero()) : Vector3(point(q, points[k]));
    return x;
  }
};

/// A pair and how far it is apart [m].
struct NearPair {
  ClothPair pair;
  double distance;
};

/// Finds what of a surface is near what.
///
/// Nodes are paired with triangles, and edges with edges. Next to an edge between two triangles a node is as near to
/// one as to the other: its pairs with inner edges count −1 and those with inner nodes + 1, so that a flat surface
/// counts once wherever the node is (inclusion and exclusion, as of the areas of overlapping sets).
///
/// Pairs never share a node, nor have nodes that are nearer than `excluded` at rest along the sheet. Both sides of a
/// contact are seen, each with half its area.
class ClothPairs {
 public:
  /// @param thickness  at which distance each node's sheet lies on one like itself, N [m]; two sheets lie on each other
  ///                   at the mean of theirs
  /// @param excluded   nodes nearer than so many times the largest thickness at rest do not touch each other
  /// @throws std::invalid_argument  a thickness that is not positive, or another number of them than of nodes
  ClothPairs(const QuadMesh& mesh, std::vector<double> thickness, double excluded);
  /// The same thickness everywhere.
  ClothPairs(const QuadMesh& mesh, double thickness, double excluded);

  [[nodiscard]] double largest_thickness() const { return largest_; }    // [m]
  [[nodiscard]] double smallest_thickness() const { return smallest_; }  // [m]

  /// All pairs that are at most `reach` apart, in an order that depends on the pairs alone.
  [[nodiscard]] std::vector<NearPair> within(double reach, ConstVectorRef q) const;

  [[nodiscard]] const SheetSurface& surface() const { return surface_; }

 private:
  struct Owned {  // by a quad: what no quad before it has
    std::vector<int> nodes, edges;
  };

  [[nodiscard]] bool apart(int i, int j) const;  // neither one node nor near at rest
  template <class Nodes>
  [[nodiscard]] bool apart_from(int node, const Nodes& nodes) const;
  [[nodiscard]] bool apart_from_triangle(int node, int triangle) const;
  void add_from_node(int node, std::size_t quad, double reach, const ConstVectorRef& q,
                     std::vector<NearPair>& pairs) const;
  [[nodiscard]] double between(int i, int j) const {
    return 0.5 * (thickness_[static_cast<std::size_t>(i)] + thickness_[static_cast<std::size_t>(j)]);
  }
  void add_of_edges(int a, int b, double reach, const ConstVectorRef& q, std::vector<NearPair>& pairs) const;

  SheetSurface surface_;
  std::vector<std::array<int, 4>> quads_;
  std::vector<Owned> owned_;       // E
  std::vector<double> thickness_;  // N
  double largest_, smallest_;
  std::vector<std::vector<int>> near_;  // N
};

}  // namespace sundrape

#include "sundrape/mesh/symmetries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <Eigen/Geometry>

#include "point_lookup.hpp"

namespace sundrape {
namespace {

using Quad = std::array<int, 4>;

/// The nodes' places about their centre.
std::vector<Vector3> centred(const QuadMesh& mesh) {
  const Vector3 centre = centre_of_nodes(mesh);
  std::vector<Vector3> places;
  places.reserve(mesh.reference.size());
  for (const auto& x : mesh.reference) places.emplace_back(x - centre);
  return places;
}

/// A quad by its nodes alone, wherever it begins and whichever way it runs.
Quad sorted(Quad quad) {
  std::ranges::sort(quad);
  return quad;
}

/// Nodes as far from the centre as node i.
std::vector<int> as_far_as(std::size_t i, const std::vector<Vector3>& places, double slack) {
  std::vector<int> nodes;
  for (std::size_t j = 0; j < places.size(); ++j)
    if (std::abs(places[j].norm() - places[i].norm()) <= slack) nodes.push_back(static_cast<int>(j));
  return nodes;
}

/// Two nodes in different directions from the centre, with all that could be their images.
struct Anchors {
  std::size_t a = 0, b = 0;
  std::vector<int> images_of_a, images_of_b;
};

/// The first two candidates whose directions from the centre differ well, or else those that differ most.
std::pair<std::size_t, std::size_t> in_different_directions(const std::vector<std::size_t>& candidates,
                                                            const std::vector<Vector3>& places) {
  constexpr double well = 0.1, least = 1e-6;  // sines of the angle between
  std::pair<std::size_t, std::size_t> best;
  double largest = least;
  for (const auto a : candidates)
    for (const auto b : candidates) {
      const double sine = places[a].normalized().cross(places[b].normalized()).norm();
      if (sine <= largest) continue;
      largest = sine;
      best = {a, b};
      if (sine > well) return best;
    }
  if (largest == least)
    throw std::invalid_argument("the nodes of the mesh lie on one line: its symmetries are not defined");
  return best;
}

Anchors find_anchors(const std::vector<Vector3>& places, double size, double slack) {
  // For each node the number that are as far out, counted in the sorted list of distances.
  std::vector<double> distances;
  distances.reserve(places.size());
  for (const auto& x : places) distances.push_back(x.norm());
  std::vector<double> in_order = distances;
  std::ranges::sort(in_order);
  const auto company = [&](std::size_t i) {
    return std::ranges::upper_bound(in_order, distances[i] + slack) -
           std::ranges::lower_bound(in_order, distances[i] - slack);
  };
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (distances[i] > 0.1 * size) candidates.push_back(i);  // near ones fix a direction badly
  std::ranges::stable_sort(candidates, {}, company);
  const auto [a, b] = in_different_directions(candidates, places);
  return {a, b, as_far_as(a, places, slack), as_far_as(b, places, slack)};
}

/// An orthonormal frame: along a, then towards b, then ± their normal.
Matrix3 frame(const Vector3& a, const Vector3& b, double side) {
  Matrix3 f;
  f.col(0) = a.normalized();
  f.col(1) = (b - b.dot(f.col(0)) * f.col(0)).normalized();
  f.col(2) = side * Vector3(f.col(0)).cross(Vector3(f.col(1)));
  return f;
}

bool maps_quads(const std::vector<int>& image, const std::vector<Quad>& quads, const std::set<Quad>& known) {
  return std::ranges::all_of(quads, [&](const Quad& quad) {
    Quad moved = quad;
    for (auto& node : moved) node = image[static_cast<std::size_t>(node)];
    return known.contains(sorted(moved));
  });
}

/// Where each node goes, N; empty if one goes where no other is, or two to the same place.
std::vector<int> images(const Matrix3& rotation, const std::vector<Vector3>& places, const PointLookup& lookup) {
  std::vector<int> image;
  image.reserve(places.size());
  std::vector<bool> taken(places.size(), false);
  for (const auto& x : places) {
    const auto found = lookup.find(rotation * x);
    if (!found || taken[static_cast<std::size_t>(*found)]) return {};
    taken[static_cast<std::size_t>(*found)] = true;
    image.push_back(*found);
  }
  return image;
}

}  // namespace

Vector3 centre_of_nodes(const QuadMesh& mesh) {
  Vector3 sum = Vector3::Zero();
  for (const auto& x : mesh.reference) sum += x;
  return sum / static_cast<double>(mesh.nodes());
}

std::vector<MeshSymmetry> mesh_symmetries(const QuadMesh& mesh, double tolerance) {
  const double size = diagonal(mesh), slack = tolerance * size;
  const auto places = centred(mesh);
  const auto anchors = find_anchors(places, size, slack);
  // What the anchors miss by `slack` at a tenth of the size can be ten times more at the far end.
  const PointLookup lookup(places, 20 * slack);
  std::set<Quad> quads;
  for (const auto& quad : mesh.quads) quads.insert(sorted(quad));

  const Matrix3 from = frame(places[anchors.a], places[anchors.b], 1);
  const double between = (places[anchors.b] - places[anchors.a]).norm();
  std::vector<MeshSymmetry> found;
  for (const int to_a : anchors.images_of_a)
    for (const int to_b : anchors.images_of_b) {
      const Vector3 &a = places[static_cast<std::size_t>(to_a)], &b = places[static_cast<std::size_t>(to_b)];
      if (std::abs((b - a).norm() - between) > 4 * slack) continue;
      for (const double side : {1.0, -1.0}) {
        const Matrix3 rotation = frame(a, b, side) * from.transpose();
        auto image = images(rotation, places, lookup);
        if (!image.empty() && maps_quads(image, mesh.quads, quads)) found.push_back({rotation, std::move(image)});
      }
    }
  std::ranges::stable_sort(found, {}, [](const MeshSymmetry& s) { return -s.rotation.trace(); });  // 3 of the identity
  return found;
}

}  // namespace sundrape

#include "sundrape/app/case_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "sundrape/mesh/directors.hpp"
#include "sundrape/mesh/noise.hpp"
#include "sundrape/mesh/symmetries.hpp"
#include "sundrape/system/equivariance.hpp"

namespace sundrape {
namespace {

constexpr double force_tolerance = 1e-6;  // of a kind's force: round-off leaves 1e-12, rounded meshes 1e-7

constexpr std::uint64_t seed = 20;  // of the trial states

Vector3 random_vector(Noise& noise) {
  const double x = noise(), y = noise();
  return {x, y, noise()};
}

/// Every point displaced at random; directors, which are about as long as `scale` of a mesh, by less.
Vector shaken(const CaseModel& model, Vector q, double amplitude, Noise& noise) {
  for (int p = 0; p < static_cast<int>(q.size() / 3); ++p) {
    const bool direction = p >= model.mesh.nodes();
    point(q, p) += (direction ? std::min(amplitude, 0.3 * model.director_length) : amplitude) * random_vector(noise);
  }
  return q;
}

/// The sheet in long waves of the size of a quarter of itself, so that it is moved far but stretched little.
Vector waved(const CaseModel& model, Vector q, Noise& noise) {
  for (int wave = 0; wave < 4; ++wave) {
    const Vector3 along = 0.06 * model.size * random_vector(noise), number = 6 / model.size * random_vector(noise);
    const double phase = 3 * noise();
    for (int i = 0; i < model.mesh.nodes(); ++i)
      point(q, i) += std::sin(number.dot(model.mesh.reference[static_cast<std::size_t>(i)]) + phase) * along;
  }
  return q;
}

std::vector<Vector> trial_states(const CaseModel& model, std::span<const Vector> visited) {
  Noise noise(seed);
  const double size = model.size;
  std::vector<Vector> states{shaken(model, model.initial, 1e-3 * size, noise),
                             shaken(model, waved(model, model.initial, noise), 1e-3 * size, noise),
                             shaken(model, model.initial, 0.2 * size, noise)};
  // Not as they are: where a kind of force is all but absent, its round-off would be all that is compared.
  for (const auto& state : visited) states.push_back(shaken(model, state, 1e-3 * size, noise));
  return states;
}

/// A symmetry of the rest shape as a map of the placed sheet's points.
PointMap placed(const MeshSymmetry& symmetry, const CaseModel& model, const std::vector<Vector3>& normals) {
  const int n = model.mesh.nodes();
  const Matrix3& turn = model.placement.rotation;
  PointMap map;
  map.rotation = turn * symmetry.rotation * turn.transpose();
  map.centre = turn * centre_of_nodes(model.mesh) + model.placement.translation;
  map.image = symmetry.image;
  map.places = n;
  const Vector3 normal = symmetry.rotation * normals.front();
  map.side = normal.dot(normals[static_cast<std::size_t>(symmetry.image.front())]) < 0 ? -1 : 1;
  if (model.has_directors())
    for (int i = 0; i < n; ++i) map.image.push_back(n + symmetry.image[static_cast<std::size_t>(i)]);
  return map;
}

PointMap rigid(const CaseModel& model, const Matrix3& rotation, const Vector3& centre) {
  PointMap map{.rotation = rotation, .centre = centre, .image = {}, .places = model.mesh.nodes()};
  map.image.resize(static_cast<std::size_t>(model.initial.size() / 3));
  std::iota(map.image.begin(), map.image.end(), 0);
  return map;
}

/// The sheet at its start, but for supports, which are at the ends of their paths.
Vector with_supports_at_the_end(const CaseModel& model) {
  Vector q = model.initial;
  model.system->carry(after_everything, statics_by_time, q);
  return q;
}

bool is_symmetry(const CaseModel& model, const PointMap& map, const std::vector<Vector>& trials) {
  return maps_supports(model.system->unknowns(), map, with_supports_at_the_end(model), 1e-5 * model.size) &&
         std::ranges::all_of(
             trials, [&](const Vector& q) { return equivariance_defect(*model.system, map, q) <= force_tolerance; });
}

/// Forces of obstacles, the only ones that tell places apart, 3P [N].
Vector contact_forces(const CaseModel& model, const Vector& q) {
  const Vector still = Vector::Zero(q.size());
  Vector forces = still;
  for (const auto& term : model.system->terms())
    if (term->kind() == EnergyKind::contact) term->add_force({after_everything, q, still}, forces);
  return forces;
}

Vector slid(const CaseModel& model, Vector q, const Vector3& by) {
  for (int i = 0; i < model.mesh.nodes(); ++i) point(q, i) += by;
  return q;
}

/// Σ over trials of (∂f/∂s)ᵀ (∂f/∂s) / |f|², s = (x, y) over the sheet's size, and what holds the sheet in x and y.
Eigen::Matrix2d resistance(const CaseModel& model, const std::vector<Vector>& trials) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  constexpr double step = 1e-9;  // over the size: within the contact law's reach so little that forces change linearly
  for (const auto& q : trials) {
    const Vector here = contact_forces(model, q);
    if (here.norm() == 0) continue;
    Eigen::MatrixX2d change(q.size(), 2);
    for (int k = 0; k < 2; ++k)
      change.col(k) =
          (contact_forces(model, slid(model, q, step * model.size * Vector3::Unit(k))) - here) / (step * here.norm());
    sum += change.transpose() * change;
  }
  for (int p = 0; p < model.mesh.nodes(); ++p)
    for (int k = 0; k < 2; ++k)
      if (model.system->unknowns().is_held(p, k)) sum(k, k) += 1e12;
  return sum;
}

/// Directions in which neither an obstacle nor a support minds a slide: null vectors of the resistance.
std::vector<Vector3> neutral_slides(const CaseModel& model, const std::vector<Vector>& trials) {
  constexpr double tolerance = 1e-4;  // differences are as exact as that
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(resistance(model, trials));
  std::vector<Vector3> slides;
  for (int k = 0; k < 2; ++k) {
    if (modes.eigenvalues()[k] > tolerance * tolerance * modes.eigenvalues()[1]) continue;
    const Vector3 along(modes.eigenvectors()(0, k), modes.eigenvectors()(1, k), 0);
    const bool neutral = std::ranges::all_of(trials, [&](const Vector& q) {
      const Vector here = contact_forces(model, q);
      return (contact_forces(model, slid(model, q, 1e-3 * model.size * along)) - here).norm() <=
             tolerance * here.norm();
    });
    if (neutral) slides.push_back(along);
  }
  return slides;
}

/// Where an axis could be that nothing minds a turn about: the sheet's middle, an obstacle's, a support's.
std::vector<Vector3> possible_pivots(const CaseModel& model) {
  std::vector<Vector3> pivots{model.placement.rotation * centre_of_nodes(model.mesh) + model.placement.translation,
                              Vector3::Zero()};
  for (const auto& obstacle : model.obstacles) pivots.push_back(obstacle.position);
  const Vector supported = with_supports_at_the_end(model);
  for (const auto& set : model.reactions) {
    Vector3 mean = Vector3::Zero();
    for (const int n : set.nodes) mean += point(supported, n) / static_cast<double>(set.nodes.size());
    pivots.push_back(mean);
  }
  return pivots;
}

std::optional<Vector3> neutral_pivot(const CaseModel& model, const std::vector<Vector>& trials) {
  // Two turns without a common fraction: what both leave alone every turn does.
  for (const auto& pivot : possible_pivots(model)) {
    const auto neutral = [&](double angle) {
      return is_symmetry(model, rigid(model, Eigen::AngleAxisd(angle, Vector3::UnitZ()).matrix(), pivot), trials);
    };
    if (neutral(1e-2) && neutral(1.0)) return pivot;
  }
  return std::nullopt;
}

/// Upright planes across which a case could be its own mirror image: through what is held, through possible pivots.
std::vector<std::pair<Vector3, Vector3>> possible_mirrors(const CaseModel& model) {
  std::vector<std::pair<Vector3, Vector3>> mirrors;  // point, normal
  std::vector<Vector3> held;
  const Vector supported = with_supports_at_the_end(model);
  for (int p = 0; p < model.mesh.nodes(); ++p)
    if (model.system->unknowns().is_held(p, 0) || model.system->unknowns().is_held(p, 1))
      held.emplace_back(point(supported, p));
  for (const auto& x : held) {
    const Vector3 normal = Vector3::UnitZ().cross(x - held.front());
    if (normal.norm() < 1e-3 * model.size) continue;
    mirrors.emplace_back(x, normal.normalized());
    break;
  }
  for (const auto& pivot : possible_pivots(model))
    for (int k = 0; k < 2; ++k) mirrors.emplace_back(pivot, Vector3::Unit(k));
  return mirrors;
}

/// A mirror of space that leaves every node its place in the sheet, as none of the sheet's own symmetries does to
/// space; nothing if the case has none.
std::optional<PointMap> mirror_of_space(const CaseModel& model, const std::vector<PointMap>& own,
                                        const std::vector<Vector>& trials) {
  for (const auto& [at, normal] : possible_mirrors(model)) {
    auto map = rigid(model, Matrix3::Identity() - 2 * normal * normal.transpose(), at);
    const bool known =
        std::ranges::any_of(own, [&](const PointMap& m) { return m.rotation.isApprox(map.rotation, 1e-6); });
    if (!known && is_symmetry(model, map, trials)) return map;
  }
  return std::nullopt;
}

/// Of two maps one after the other; nothing where together they leave no point in place.
std::optional<PointMap> after(const PointMap& second, const PointMap& first, double size) {
  PointMap map = second;
  map.rotation = second.rotation * first.rotation;
  const auto moved = [](const PointMap& m, const Vector3& x) -> Vector3 {
    return m.rotation * (x - m.centre) + m.centre;
  };
  const Vector3 shift = moved(second, moved(first, Vector3::Zero()));
  const Eigen::MatrixXd change = Matrix3::Identity() - map.rotation;
  map.centre = change.completeOrthogonalDecomposition().solve(Eigen::VectorXd(shift));
  if ((map.centre - map.rotation * map.centre - shift).norm() > 1e-9 * size) return std::nullopt;
  for (std::size_t p = 0; p < map.image.size(); ++p)
    map.image[p] = second.image[static_cast<std::size_t>(first.image[p])];
  map.side = second.side * first.side;
  return map;
}

}  // namespace

CaseSymmetries find_case_symmetries(const CaseModel& model, std::span<const Vector> visited) {
  const auto trials = trial_states(model, visited);
  const auto normals = rest_directors(model.mesh);
  CaseSymmetries found;
  for (const auto& symmetry : mesh_symmetries(model.mesh)) {
    auto map = placed(symmetry, model, normals);
    // The identity holds whatever round-off says.
    if (found.maps.empty() || is_symmetry(model, map, trials)) found.maps.push_back(std::move(map));
  }
  // the mirror image of a sheet is a sheet: where space has another mirror, each of these has a partner
  if (const auto mirror = mirror_of_space(model, found.maps, trials))
    for (std::size_t k = 0, own = found.maps.size(); k < own; ++k)
      if (auto map = after(found.maps[k], *mirror, model.size)) found.maps.push_back(std::move(*map));
  if (!model.grippers.empty()) {  // what they take depends on the way there
    found.maps.resize(1);
    return found;
  }
  found.neutral.slides = neutral_slides(model, trials);
  found.neutral.pivot = neutral_pivot(model, trials);
  return found;
}

}  // namespace sundrape

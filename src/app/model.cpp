#include "sundrape/app/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "sundrape/app/last_shape.hpp"
#include "sundrape/app/obstacles.hpp"
#include "sundrape/force/dead_load.hpp"
#include "sundrape/force/drag.hpp"
#include "sundrape/force/pressure.hpp"
#include "sundrape/force/wind.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/file_error.hpp"
#include "sundrape/mesh/crossings.hpp"
#include "sundrape/mesh/directors.hpp"
#include "sundrape/mesh/waviness.hpp"

#include "overload.hpp"
#include "pick.hpp"
#include "pieces.hpp"
#include "sheet.hpp"
#include "support_builder.hpp"

namespace sundrape {
namespace {

Vector flatten(const std::vector<Vector3>& positions) {
  Vector q(static_cast<Eigen::Index>(3 * positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) q.segment<3>(static_cast<Eigen::Index>(3 * i)) = positions[i];
  return q;
}

/// Shares a total over nodes as dead nodal forces.
Vector equal_shares(const std::vector<int>& nodes, const Vector3& total, int points) {
  Vector forces = Vector::Zero(3 * static_cast<Eigen::Index>(points));
  for (const int n : nodes) point(forces, n) += total / static_cast<double>(nodes.size());
  return forces;
}

using Terms = std::vector<std::unique_ptr<ForceTerm>>;

/// Weights of the nodes; directors have inertia but no weight of their own.
Vector node_weights(const Sheet& sheet, int nodes, const Vector3& acceleration) {
  Vector mass = sheet.mass;
  mass.tail(mass.size() - nodes).setZero();
  return weight(mass, acceleration);
}

void add_loads(const Case& c, CaseModel& model, const Threads& threads, const std::vector<Vector3>& placed,
               Sheet& sheet) {
  Terms& terms = sheet.terms;
  const int points = sheet.points();
  Vector3 gravity = Vector3::Zero();
  for (const auto& load : c.loads) {
    // statics knows no time: loads have their full size, or go by stages
    const LoadCourse course{c.analysis == Analysis::dynamics ? load.ramp : 0, load.stages};
    std::visit(
        Overload{[&](const GravityLoad& g) {
                   gravity += g.acceleration;
                   terms.push_back(std::make_unique<DeadLoad>("gravity", EnergyKind::gravity,
                                                              node_weights(sheet, model.mesh.nodes(), g.acceleration),
                                                              course));
                 },
                 [&](const ForceLoad& f) {
                   const auto nodes = pick(f.nodes, model.mesh, placed, load.source);
                   terms.push_back(std::make_unique<DeadLoad>("force", EnergyKind::load,
                                                              equal_shares(nodes, f.total, points), course));
                 },
                 [&](const TractionLoad& t) {
                   const auto nodes = pick(t.nodes, model.mesh, placed, load.source);
                   const auto lengths = tributary_edge_lengths(model.mesh, nodes);
                   Vector forces = Vector::Zero(3 * static_cast<Eigen::Index>(points));
                   for (const int n : nodes) point(forces, n) = lengths[static_cast<std::size_t>(n)] * t.per_length;
                   if (std::ranges::all_of(lengths, [](double l) { return l == 0; }))
                     throw CaseError(load.source,
                                     "a traction needs nodes along an edge of the cloth; no boundary edge has both its "
                                     "ends among these");
                   terms.push_back(std::make_unique<DeadLoad>("traction", EnergyKind::load, std::move(forces), course));
                 },
                 [&](const MomentLoad& m) {
                   const auto nodes = pick(m.nodes, model.mesh, placed, load.source);
                   try {
                     terms.push_back(moment_load(sheet, model.mesh, threads, nodes, m.total, course));
                   } catch (const std::invalid_argument& problem) {
                     throw CaseError(load.source, problem.what());
                   }
                 },
                 [&](const PressureLoad& p) {
                   terms.push_back(std::make_unique<Pressure>(model.mesh.quads, p.value, course));
                 },
                 [&](const WindLoad& w) {
                   auto field = w.field;
                   if (c.analysis != Analysis::dynamics) field.gust.setZero();
                   terms.push_back(std::make_unique<Wind>(model.mesh.quads, field, w.air, course));
                 }},
        load.load);
  }
  model.weight = sheet.mass.head(model.mesh.nodes()).sum() * gravity.norm();
  model.gravity = gravity.norm() > 0 ? gravity.norm() : 9.80665;
  model.area_weight = 0;
  for (const auto& piece : c.pieces)
    model.area_weight = std::max(model.area_weight, piece.fabric.area_density * model.gravity);
}

/// Drag of the air as a part of each piece's mass.
void add_drag(const Case& c, const CaseModel& model, Sheet& sheet) {
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    const double rate = c.pieces[k].fabric.damping.mass;
    if (rate == 0) continue;
    Vector mass = Vector::Zero(sheet.mass.size());
    const auto& piece = model.pieces[k];
    for (int first = 0; first < mass.size(); first += model.mesh.nodes())  // positions, then directors
      mass.segment(first + piece.first_node, piece.nodes) = sheet.mass.segment(first + piece.first_node, piece.nodes);
    sheet.terms.push_back(std::make_unique<Drag>(mass, rate));
  }
}

/// Stiffness of contact [N/m³], unless the case says so.
double contact_stiffness(const Case& c, const Cloth& cloth, double area_weight) {
  // finer nets spread a load over several points
  double bending = std::numeric_limits<double>::infinity();
  for (const auto& piece : c.pieces)
    bending = std::min(bending, std::max(piece.fabric.warp_bending, piece.fabric.weft_bending));
  const double part_of_bending_length = 0.125 * std::cbrt(bending / area_weight);
  return c.contact.stiffness.value_or(suggested_stiffness(
      {.weight_per_area = area_weight,
       .diagonal = cloth.diagonal,
       .spread = std::max(mean_edge_length(cloth.mesh) / c.contact.subdivision, part_of_bending_length)},
      c.contact.penetration));
}

/// At which distance each node's sheet lies on one like itself, N [m].
std::vector<double> thicknesses(const Case& c, const CaseModel& model) {
  std::vector<double> of_nodes(static_cast<std::size_t>(model.mesh.nodes()), c.contact.thickness);
  if (c.contact.thickness_given) return of_nodes;
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    const auto& piece = model.pieces[k];
    std::fill_n(of_nodes.begin() + piece.first_node, piece.nodes, c.pieces[k].fabric.thickness);
  }
  return of_nodes;
}

void add_cloth_contact(const Case& c, const Cloth& cloth, FrictionMatrix friction, CaseModel& model, Terms& terms) {
  if (!c.contact.self) return;
  constexpr double not_neighbours = 2;  // thicknesses: a fold as sharp as it can be, π/2 along the sheet, is none
  auto term = std::make_unique<ClothContact>(
      ClothPairs(model.mesh, thicknesses(c, model), not_neighbours),
      ContactLaw(contact_stiffness(c, cloth, model.area_weight), c.contact.smoothing),
      ClothContactOptions{.friction = c.analysis == Analysis::dynamics ? c.contact.friction : 0,
                          .friction_law = FrictionLaw(c.contact.friction_speed),
                          .friction_matrix = friction});
  model.cloth_contact = term.get();
  terms.push_back(std::move(term));
}

/// Cloth that starts tangled could not be told apart.
void require_untangled(const Case& c, const CaseModel& model) {
  if (model.cloth_contact == nullptr) return;
  const auto found = crossings(model.surface, model.initial);
  if (found.empty()) return;
  const auto nodes = [&](int t) {
    const auto& [i, j, k] = model.surface.triangles[static_cast<std::size_t>(t)];
    return fmt::format("({}, {}, {})", i, j, k);
  };
  std::string pairs;
  constexpr std::size_t most_named = 3;
  for (std::size_t p = 0; p < std::min(found.size(), most_named); ++p)
    pairs += fmt::format("{}{} and {}", p > 0 ? ", " : "", nodes(found[p].first), nodes(found[p].second));
  const auto& [i, j, k] = model.surface.triangles[static_cast<std::size_t>(found.front().first)];
  const Vector3 place = (point(model.initial, i) + point(model.initial, j) + point(model.initial, k)) / 3;
  throw CaseError(
      {.file = c.file.string(), .key = "cloth"},
      fmt::format("the cloth starts by passing through cloth: {} pairs of triangles, with the nodes {}{}, near "
                  "({:.4g}, {:.4g}, {:.4g}) m; place it apart, or start from another shape",
                  found.size(), pairs, found.size() > most_named ? ", ..." : "", place.x(), place.y(), place.z()));
}

void add_contact(const Case& c, const Cloth& cloth, FrictionMatrix friction, CaseModel& model, Terms& terms) {
  if (c.obstacles.empty()) return;
  std::vector<ContactBody> bodies;
  for (const auto& obstacle : c.obstacles) {
    auto built = build_obstacle(obstacle);
    if (c.analysis != Analysis::dynamics) built.body.friction = 0;  // nothing slides in statics
    bodies.push_back(std::move(built.body));
    model.obstacles.push_back(std::move(built.record));
  }
  auto term =
      std::make_unique<ObstacleContact>(std::move(bodies), contact_points(model.mesh, c.contact.subdivision),
                                        ContactLaw(contact_stiffness(c, cloth, model.area_weight), c.contact.smoothing),
                                        FrictionLaw(c.contact.friction_speed), friction);
  model.contact = term.get();
  terms.push_back(std::move(term));
}

/// Cloth that starts on an obstacle would spring off it, since the contact force sets in above the surface: nodes
/// within its reach start where it carries their own weight.
void lay_on_obstacles(const ObstacleContact& contact, double weight_per_area, const Supports& supports,
                      std::vector<Vector3>& positions) {
  const Vector nothing;
  const State start{0, nothing, nothing};
  const double reach = contact.law().smoothing(), rest = contact.law().gap_under(weight_per_area);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto [gap, normal, body] = contact.closest(start, positions[i]);
    if (!(std::abs(gap) <= reach) || gap >= rest) continue;
    for (int k = 0; k < 3; ++k)
      if (!supports.position[i][static_cast<std::size_t>(k)]) positions[i][k] += (rest - gap) * normal[k];
  }
}

/// Where an earlier result ended.
ShapeAtRest start_of(const StartCase& start, const QuadMesh& mesh) {
  try {
    return last_shape(ResultReader(start.file), mesh);
  } catch (const FileError& problem) {
    throw CaseError(start.source, problem.what());
  }
}

/// How much of the weight acts first: an equilibrium path begins under its first increment.
double first_share(const Case& c) {
  return c.analysis == Analysis::arc_length ? c.arc_length.first_increment.front() : 1;
}

// Rates of directors matter through the sheet's motion only, and ring at the frequencies of transverse shear.
constexpr double director_rate_slack = 100;

}  // namespace

RigidPlacement placement(const Place& place) {
  return {Eigen::AngleAxisd(place.angle, place.axis.normalized()).matrix(), place.translate};
}

std::vector<Vector3> place(const std::vector<Vector3>& rest, const Place& place) {
  const auto stands = placement(place);
  std::vector<Vector3> placed;
  placed.reserve(rest.size());
  for (const auto& x : rest) placed.emplace_back(stands(x));
  return placed;
}

std::vector<int> CaseModel::turned_points(const Gripper& gripper, const std::vector<int>& nodes) const {
  std::vector<int> points;
  if (gripper.turns && has_directors())
    for (const int n : nodes) points.push_back(mesh.nodes() + n);
  return points;
}

Vector CaseModel::directors_of(const ConstVectorRef& all) const {
  if (!has_directors()) return {};
  return all.tail(3 * static_cast<Eigen::Index>(mesh.nodes())) / director_length;
}

Vector CaseModel::folded(const Vector& of_points) const {
  const Eigen::Index nodes = mesh.nodes();
  Vector of_nodes = of_points.head(nodes);
  if (has_directors()) of_nodes += of_points.tail(nodes);
  return of_nodes;
}

bool is_wavy_at_rest(const Case& c, const PieceCase& piece) {
  return piece.cloth.waviness_at_rest.value_or(c.analysis == Analysis::arc_length);
}

double default_waviness(const PieceCase& piece) { return std::min(1e-5, 0.02 * piece.fabric.thickness); }

CaseModel build_model(const Case& c, FrictionMatrix friction) {
  CaseModel model;
  model.has_inertia = c.analysis == Analysis::dynamics;
  const auto cloth = build_cloth(c);
  const auto& placed = cloth.placed;
  model.mesh = cloth.mesh;
  model.pieces = cloth.pieces;
  model.size = cloth.size;
  model.placement = cloth.placement;
  const auto threads = find_threads(model.mesh);
  const SupportBuilder built(c, model, placed);
  const auto& supports = built.at_the_start();
  for (const auto& probe : c.output.probes)
    model.probes.push_back({probe.name, pick(Near{probe.near}, model.mesh, placed, probe.source).front()});

  auto sheet = c.model == Model::particle ? net_sheet(c, cloth, threads, supports) : shell_sheet(c, cloth);
  model.edge_strains = EdgeStrains(model.mesh);
  const auto areas = tributary_areas(model.mesh);
  model.node_area = Eigen::Map<const Vector>(areas.data(), std::ssize(areas));
  model.director_length = sheet.director_length;
  model.gauges = std::move(sheet.gauges);
  for (const auto& term : sheet.terms) {
    if (const auto* bends = dynamic_cast<const BendSprings*>(term.get())) model.bends.push_back(bends);
    if (auto* clamps = dynamic_cast<ClampSprings*>(term.get())) {
      for (const auto& motion : c.motions)
        if (motion.rotation && !motion.grip.from)
          clamps->turn_with(pick(motion.nodes, model.mesh, placed, motion.source), course_of(motion.course));
      model.clamps.push_back(clamps);
    }
    if (const auto* directors = dynamic_cast<const DirectorLength*>(term.get())) model.directors = directors;
  }
  add_loads(c, model, threads, placed, sheet);
  add_drag(c, model, sheet);
  add_contact(c, cloth, friction, model, sheet.terms);
  model.surface = SheetSurface(model.mesh);
  add_cloth_contact(c, cloth, friction, model, sheet.terms);

  const auto earlier = c.sheet().cloth.start ? start_of(*c.sheet().cloth.start, model.mesh) : ShapeAtRest{placed, {}};
  auto start = c.sheet().cloth.start ? wavy(model.mesh, earlier.positions, c.sheet().cloth.waviness_amplitude,
                                            c.sheet().cloth.waviness_seed)
                                     : cloth.initial;
  for (std::size_t i = 0; i < start.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (supports.position[i][static_cast<std::size_t>(k)]) start[i][k] = placed[i][k];
  if (model.contact != nullptr && !c.sheet().cloth.start)
    lay_on_obstacles(*model.contact, first_share(c) * model.area_weight, supports, start);
  auto points = start;
  if (model.has_directors()) {
    const auto carried = earlier.directors.empty()
                             ? carried_directors(model.mesh, sheet.directors, placed, start)
                             : carried_directors(model.mesh, earlier.directors, earlier.positions, start);
    for (std::size_t i = 0; i < carried.size(); ++i) {
      const auto& held = supports.director[i];
      Vector3 director = carried[i];
      const bool any_held = held[0] || held[1] || held[2];
      for (std::size_t k = 0; k < 3; ++k)  // of a sheet at its start a director that is held at all stands as placed
        if (held[k] || (any_held && !c.sheet().cloth.start))
          director[static_cast<int>(k)] = sheet.directors[i][static_cast<int>(k)];
      points.emplace_back(model.director_length * director);
    }
  }
  model.initial = flatten(points);
  require_untangled(c, model);
  Unknowns unknowns(built.lasting().of_points(model.has_directors()), sheet.order);
  if (unknowns.rows() == 0)
    throw CaseError(c.fixes.empty() ? c.motions.front().source : c.fixes.front().source,
                    "every node of the cloth is held: nothing is left to move");
  if (model.has_directors()) {
    model.rate_slack = Vector::Ones(unknowns.rows());
    for (int r = 0; r < unknowns.rows(); ++r)
      if (unknowns.point_of_row()[static_cast<std::size_t>(r)] >= model.mesh.nodes())
        model.rate_slack[r] = director_rate_slack;
  }
  model.system = std::make_unique<System>(std::move(sheet.mass), std::move(sheet.terms), std::move(unknowns),
                                          model.initial, built.motions());
  const Vector still = Vector::Zero(model.initial.size());
  for (const auto& gripper : model.grippers)
    if (!gripper.grip.from)
      model.system->take_hold(gripper.motion, gripper.at_start, model.turned_points(gripper, gripper.at_start),
                              {0, model.initial, still});
  return model;
}

Reaction reaction(const CaseModel& model, const State& all, const std::vector<int>& nodes) {
  const auto& unknowns = model.system->unknowns();
  Vector f = Vector::Zero(all.q.size());
  model.system->force(all, f);
  if (model.has_inertia && model.system->has_motions()) {
    const Vector acceleration = model.system->held_acceleration(all.time);
    for (int p = 0; p < unknowns.points(); ++p) point(f, p) -= model.system->mass()[p] * point(acceleration, p);
  }
  const auto held = [&](int p) {
    Vector3 force = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
      if (unknowns.is_held(p, k)) force[k] = f[3 * p + k];
    return force;
  };
  Vector3 centre = Vector3::Zero();
  for (const int n : nodes) centre += point(all.q, n) / static_cast<double>(nodes.size());
  std::vector<bool> chosen(static_cast<std::size_t>(model.mesh.nodes()), false);
  Reaction r{Vector3::Zero(), Vector3::Zero()};
  for (const int n : nodes) {
    chosen[static_cast<std::size_t>(n)] = true;
    const Vector3 force = held(n);
    r.force += force;
    r.moment += (point(all.q, n) - centre).cross(force);
    if (!model.has_directors()) continue;
    const int director = model.mesh.nodes() + n;
    r.moment += Vector3(point(all.q, director)).cross(held(director));
  }
  for (const auto* clamps : model.clamps) r.moment -= clamps->couple(all, chosen);
  return r;
}

}  // namespace sundrape

#include "support/shell_samples.hpp"

#include <random>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

constexpr double gf_per_cm2 = 98.0665, gf_cm = 9.80665e-5;  // [N/m²], [N m]

// the article's fit, in gf cm^k, as tests of the material room have it
std::array<double, 5> twill() {
  std::array<double, 5> alpha{1.33387, -2.23070, 2.36510, -1.08471, 0.17876};
  double unit = 0.980665;  // gf·cm/cm in N
  for (auto& a : alpha) a *= unit *= 0.01;
  return alpha;
}

}  // namespace

std::vector<Vector3> ShellSample::points() const {
  auto all = mesh.reference;
  for (const auto& t : directors) all.emplace_back(director_length * t);
  return all;
}

ShellSample shell_sample(const QuadMesh& mesh, const ShellSampleOptions& options) {
  using Law = ShellSampleOptions::Law;
  const double h = 0.489e-3, e = 60446 * gf_per_cm2;
  ShellSample s;
  s.mesh = mesh;
  s.directors = node_normals(mesh, mesh.reference);
  s.membrane = e * h;
  s.bending = 0.589 * gf_cm;
  Fabric fabric = isotropic_fabric(e, options.poisson, h, 0.26);
  if (options.law == Law::orthotropic) {
    fabric.weft_membrane *= 0.4;
    fabric.shear_membrane *= 0.2;
    fabric.weft_bending *= 0.5;
    fabric.bending_coupling *= 0.5;
  }
  if (options.law == Law::energy || options.law == Law::paper) {
    const auto alpha = twill();
    const auto warp = MomentCurvature::polynomial(alpha, 250), weft = MomentCurvature::linear(0.9 * alpha[0]);
    fabric.measured_bending = Fabric::MeasuredBending{
        warp, weft, options.law == Law::energy ? PlateBending::Form::energy : PlateBending::Form::paper};
  }
  const ShellSection section{.membrane = membrane_stiffness(fabric),
                             .shear = 5.0 / 6 * fabric.transverse_shear,
                             .bending = plate_bending(fabric),
                             .membrane_damping = options.membrane_damping,
                             .bending_damping = options.bending_damping};
  s.shell = std::make_unique<Shell>(shell_elements(mesh, s.directors), section,
                                    ShellOptions{options.membrane, options.curvature, ShellSample::director_length});
  std::vector<DirectorSpring> springs;
  const auto areas = tributary_areas(mesh);
  for (int i = 0; i < mesh.nodes(); ++i)
    springs.push_back({mesh.nodes() + i, s.membrane * areas[static_cast<std::size_t>(i)]});
  s.length = std::make_unique<DirectorLength>(springs, ShellSample::director_length, options.membrane_damping);
  return s;
}

QuadMesh distorted_patch(bool curved) {
  auto mesh = rectangle(0.03, 0.02, 3, 2);
  std::mt19937 random(4);
  std::uniform_real_distribution<> noise(-0.0025, 0.0025);
  for (std::size_t i = 0; i < mesh.reference.size(); ++i) {
    auto& x = mesh.reference[i];
    x += Vector3(noise(random), noise(random), 0);
    mesh.material[i] = x.head<2>();  // threads stay straight
    if (curved) x[2] = 8 * x[0] * x[0] - 5 * x[1] * x[1] + 6 * x[0] * x[1];
  }
  return mesh;
}

}  // namespace sundrape

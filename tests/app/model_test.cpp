#include "sundrape/app/model.hpp"

#include <cmath>
#include <fstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <omp.h>

#include "sample_cases.hpp"

namespace sundrape {
namespace {

using samples::sheet_case;
using samples::sheet_weight;

const std::string hung = "[[fix]]\nnodes = \"left\"\ncomponents = [\"x\", \"y\", \"z\"]\n";

TEST(Model, HasTheMassOfTheSheetAndItsSize) {
  const auto model = samples::model_of(sheet_case(""));
  EXPECT_EQ(model.mesh.nodes(), 20);
  EXPECT_NEAR(model.system->mass().sum(), 0.2 * 0.08 * 0.06, 1e-12);
  EXPECT_NEAR(model.weight, sheet_weight, 1e-9);
  EXPECT_DOUBLE_EQ(model.size, 0.08);
}

TEST(Model, IsPlacedByTurningFirst) {
  const auto model = samples::model_of(sheet_case("",
                                                  "shape = \"rectangle\"\nsize = [0.08, 0.06]\ncells = [4, "
                                                  "3]\nwaviness = { amplitude = 0 }\nplace = { translate = [1, 0, 0], "
                                                  "rotate = { axis = [0, 1, 0], angle = \"90 deg\" } }"));
  for (int i = 0; i < model.mesh.nodes(); ++i) {
    const auto& rest = model.mesh.reference[static_cast<std::size_t>(i)];
    EXPECT_LT((point(model.initial, i) - Vector3(1, rest.y(), -rest.x())).norm(), 1e-15);
  }
}

TEST(Model, HeldNodesStartWithoutWaviness) {
  const auto model = samples::model_of(
      sheet_case(hung, "shape = \"rectangle\"\nsize = [0.08, 0.06]\ncells = [4, 3]\nwaviness = { amplitude = 1e-3 }"));
  double largest = 0;
  for (int i = 0; i < model.mesh.nodes(); ++i) {
    const double height = std::abs(point(model.initial, i).z());
    if (model.mesh.reference[static_cast<std::size_t>(i)].x() < -0.039)
      EXPECT_EQ(height, 0);
    else
      largest = std::max(largest, height);
  }
  EXPECT_GT(largest, 1e-4);
}

TEST(Model, TakesItsMeshAndItsNodeSetsFromAFileBesideTheCase) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "sundrape_model_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "sheet.obj")
      << "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 20 0 0\nv 20 10 0\ng hem\nf 1 2 3 4\ng rest\nf 2 5 6 3\n";
  const auto model = samples::model_of(
      sheet_case("[[fix]]\nnodes = \"hem\"\n", "shape = \"mesh\"\nfile = \"sheet.obj\"\nunits = \"cm\""),
      folder / "CASE.toml");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(model.mesh.nodes(), 6);
  EXPECT_EQ(model.system->unknowns().rows(), 2);  // the hem has four nodes
  EXPECT_NEAR(model.system->mass().sum(), 0.2 * 0.2 * 0.1, 1e-12);
  EXPECT_EQ(model.reactions.at(0).name, "hem");
}

/// Both models of a sheet.
std::vector<std::string> models() { return {"", "model = \"shell\"\n"}; }

TEST(Model, ShareOfTheStrainEnergyAtEachNodeSumsToTheEnergies) {
  for (const auto& kind : models()) {
    const auto model = samples::model_of(kind + sheet_case("[[fix]]\nnodes = \"left\"\n"));
    Vector q = model.initial;
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] += 2e-4 * std::sin(7.0 * static_cast<double>(i));
    const Vector still = Vector::Zero(q.size());
    const auto energies = model.system->energies({0, q, still});
    const Vector of_nodes = model.folded(model.system->strain_energy({0, q, still}));
    const double stored = energies.membrane + energies.shear + energies.bending;
    EXPECT_NEAR(of_nodes.sum() / stored, 1, 1e-12) << kind;
    EXPECT_GT(of_nodes.minCoeff(), 0) << kind;
  }
}

TEST(Model, ItsSupportCarriesTheWeightOfAHangingSheet) {
  for (const auto& kind : models()) {
    const auto model = samples::model_of(kind + sheet_case(hung));
    const Vector q = samples::equilibrium(model, 1e-7), still = Vector::Zero(q.size());
    const Vector3 carried = reaction(model, {0, q, still}, model.reactions.at(0).nodes).force;
    EXPECT_NEAR(carried.z() / sheet_weight, -1, 1e-4) << kind;  // the cloth pulls its support down
    EXPECT_LT(std::hypot(carried.x(), carried.y()), 1e-4 * sheet_weight) << kind;
  }
}

TEST(Model, AClampCarriesTheMomentOfTheWeightAboutIt) {
  for (const auto& kind : models()) {
    const auto model = samples::model_of(kind + sheet_case("[[fix]]\nnodes = \"left\"\n"));
    const Vector q = samples::equilibrium(model, 1e-8), still = Vector::Zero(q.size());
    const auto carried = reaction(model, {0, q, still}, model.reactions.at(0).nodes);
    Vector3 centre = Vector3::Zero(), moment = Vector3::Zero();
    for (const int n : model.reactions.at(0).nodes) centre += 0.25 * point(q, n);
    for (int i = 0; i < model.mesh.nodes(); ++i)
      moment += (point(q, i) - centre).cross(Vector3(0, 0, -9.80665 * model.system->mass()[i]));
    EXPECT_GT(moment.norm(), 0.1 * sheet_weight * 0.04) << kind;
    EXPECT_LT((carried.moment - moment).norm(), 1e-4 * moment.norm()) << kind;
  }
}

TEST(Model, AHingeCarriesNoMomentAboutItsAxis) {
  // directors may turn about y alone, and do
  const auto model = samples::model_of("model = \"shell\"\n" +
                                       sheet_case("[[fix]]\nnodes = \"left\"\ncomponents = [\"x\", \"y\", \"z\", "
                                                  "\"director-y\"]\n"));
  const Vector q = samples::equilibrium(model, 1e-8), still = Vector::Zero(q.size());
  const auto carried = reaction(model, {0, q, still}, model.reactions.at(0).nodes);
  EXPECT_LT(std::abs(carried.moment.y()), 1e-6 * sheet_weight * 0.04);
  const Vector directors = model.directors_of(q);
  for (const int n : model.reactions.at(0).nodes) {
    EXPECT_EQ(point(directors, n).y(), 0);
    EXPECT_LT(point(directors, n).z(), 0.1);  // the sheet hangs down
  }
}

TEST(Model, OfAShellHasDirectorsWithRotaryInertiaOrWithout) {
  const std::string plain =
      "model = \"shell\"\nanalysis = \"dynamics\"\n[dynamics]\nduration = 1\nintegrator = \"ida\"\n";
  const auto text = [&](const std::string& director) {
    auto of_sheet = sheet_case(hung + "[shell]\ndirector = \"" + director + "\"\n");
    return plain + of_sheet.substr(of_sheet.find('\n') + 1);  // without its analysis
  };
  const auto heavy = samples::model_of(text("inertia")), light = samples::model_of(text("massless"));
  const auto nodes = heavy.mesh.nodes();
  // ρ h³/12 over the square of the directors' length
  const double expected = 0.2 * 0.08 * 0.06 * std::pow(0.5e-3, 2) / 12 / std::pow(heavy.director_length, 2);
  EXPECT_NEAR(heavy.system->mass().tail(nodes).sum(), expected, 1e-12 * expected);
  EXPECT_EQ(light.system->mass().tail(nodes).sum(), 0);
  EXPECT_NEAR(light.weight, sheet_weight, 1e-9);
  EXPECT_EQ(heavy.directors_of(heavy.initial).size(), 3 * nodes);
}

TEST(Model, TheFloorCarriesTheWeightOfASheetAtRest) {
  const auto model = samples::model_of(sheet_case(
      "[[fix]]\nnodes = { near = [0, 0, 0] }\ncomponents = [\"x\", \"y\"]\n[[obstacle]]\nkind = \"plane\"\n"));
  const Vector q = samples::equilibrium(model, 1e-7), still = Vector::Zero(q.size());
  const auto report = model.contact->report({0, q, still});
  EXPECT_NEAR(model.contact->total_forces({0, q, still}).at(0).z() / sheet_weight, 1, 1e-4);
  EXPECT_EQ(report.contacts, 7 * 9);               // 4 × 5 nodes, and a point between any two neighbours
  EXPECT_LT(report.deepest_penetration, 0.05e-3);  // a tenth of the thickness, which is what the stiffness is for
}

TEST(Model, ForcesAndTangentsAreTheSameBitsForAnyNumberOfThreads) {
  const auto model = samples::model_of(sheet_case(hung, "shape = \"rectangle\"\nsize = [0.4, 0.4]\ncells = [40, 40]"));
  Vector q = model.initial, v(q.size());
  for (int i = 0; i < q.size(); ++i) {
    q[i] += 1e-3 * std::sin(37.0 * i);
    v[i] = 0.1 * std::cos(11.0 * i);
  }
  const auto computed = [&](int threads) {
    omp_set_num_threads(threads);
    Vector f(q.size());
    model.system->force({0, q, v}, f);
    BlockMatrix matrix(model.system->structure(), Symmetry::symmetric);
    model.system->add_tangent({0, q, v}, -1, -600, matrix);
    const auto values = matrix.lower_values();
    return std::pair(f, std::vector<double>(values.begin(), values.end() - 9));  // without the scratch block
  };
  const auto one = computed(1);
  for (const int threads : {2, 3}) {
    const auto more = computed(threads);
    EXPECT_EQ(more.first, one.first) << threads;
    EXPECT_EQ(more.second, one.second) << threads;
  }
  omp_set_num_threads(1);
}

TEST(Model, StaticLoadsHaveTheirFullSizeWhateverTheirRamp) {
  const auto at_start = [](const std::string& more) {
    const auto model = samples::model_of(sheet_case(hung + more));
    const Vector still = Vector::Zero(model.initial.size());
    return model.system->external_force_norm({0, model.initial, still});
  };
  const std::string force = "[[load]]\nkind = \"force\"\nnodes = \"right\"\ntotal = [0, 1, 0]\n";
  EXPECT_GT(at_start(force), 0.1);
  EXPECT_DOUBLE_EQ(at_start(force + "ramp = \"1 s\"\n"), at_start(force));
}

}  // namespace
}  // namespace sundrape

#include "sundrape/app/continuation.hpp"

#include <gtest/gtest.h>

#include "sundrape/app/solver_choice.hpp"

#include "sample_cases.hpp"

namespace sundrape {
namespace {

/// A limp square sheet, as fine as asked for; its bending length is (1 MPa (0.5 mm)³/12 / 1.96 N/m²)^(1/3) = 1.8 cm.
std::string square_sheet(int cells, const std::string& more, const std::string& top = "", double size = 0.2) {
  return top +
         samples::sheet_case(more, fmt::format("shape = \"rectangle\"\nsize = [{1}, {1}]\ncells = [{0}, {0}]\n"
                                               "place = {{ rotate = {{ axis = [1, 0, 0], angle = \"80 deg\" }} }}",
                                               cells, size));
}

const std::string hung = "[[fix]]\nnodes = \"top\"\n";

struct Built {
  Case c;
  CaseModel model;
  explicit Built(const std::string& text) : c(parse_case(text, "CASE.toml")), model(build_model(c)) {}
  [[nodiscard]] std::vector<int> nodes_of_coarser() const {
    std::vector<int> nodes;
    for (const auto& level : coarser_cases(c, model)) nodes.push_back(level.model.mesh.nodes());
    return nodes;
  }
};

TEST(CoarserCases, HalveTheCellsUntilAMeshIsCoarseEnough) {
  EXPECT_EQ(Built(square_sheet(40, hung)).nodes_of_coarser(), std::vector<int>({21 * 21}));
  EXPECT_EQ(Built(square_sheet(80, hung)).nodes_of_coarser(), std::vector<int>({41 * 41, 21 * 21}));
}

TEST(CoarserCases, ResolveTheFolds) {
  // cells of 1 cm are 0.55 bending lengths long, enough for a net and too much for a shell
  EXPECT_EQ(Built(square_sheet(40, hung, "model = \"shell\"\n")).nodes_of_coarser(), std::vector<int>());
  EXPECT_EQ(Built(square_sheet(80, hung, "model = \"shell\"\n")).nodes_of_coarser(), std::vector<int>({41 * 41}));
}

TEST(CoarserCases, AreNotForSmallMeshes) { EXPECT_TRUE(Built(square_sheet(16, hung)).nodes_of_coarser().empty()); }

TEST(CoarserCases, KeepSupportsWhereTheyAre) {
  const auto pinned = [](double x) { return fmt::format("[[fix]]\nnodes = {{ near = [{}, 0, 0] }}\n", x); };
  EXPECT_EQ(Built(square_sheet(40, pinned(0.05))).nodes_of_coarser(), std::vector<int>({21 * 21}));
  EXPECT_TRUE(
      Built(square_sheet(40, pinned(0.055))).nodes_of_coarser().empty());  // between two nodes of the coarser mesh
  EXPECT_EQ(Built(square_sheet(50, pinned(0))).nodes_of_coarser(),
            std::vector<int>({27 * 27}));  // 25 cells have no middle
}

TEST(Continuation, EndsInTheSameEquilibriumWhereThereIsOne) {
  for (const std::string model : {"particle", "shell"}) {
    const Built hanging(square_sheet(model == "shell" ? 36 : 24, hung, "model = \"" + model + "\"\n", 0.1));
    const auto coarser = coarser_cases(hanging.c, hanging.model);
    ASSERT_EQ(coarser.size(), 1U);
    const auto start = start_on_coarser_meshes(
        hanging.c, hanging.model, coarser, [](const QuadMesh&, const RelaxationStep&) {}, [] { return false; });
    EXPECT_EQ(start.problem, "");
    EXPECT_GT(start.iterations, 0);
    UnseenRelaxation unseen;
    Vector continued = start.q, direct = hanging.model.initial;
    const auto solver = statics_solver(hanging.c, *hanging.model.system);
    auto options = continued_options(hanging.c, hanging.model);
    options.tolerance = 1e-9;
    const auto from_coarse = relax(*hanging.model.system, *solver, options, continued, unseen);
    const auto from_flat = relax(*hanging.model.system, *solver, options, direct, unseen);
    EXPECT_EQ(from_coarse.end, RelaxationEnd::converged) << from_coarse.diagnosis;
    EXPECT_LT(from_coarse.iterations, from_flat.iterations);
    // residuals of 1e-9 on a sheet that bends under its weight by centimetres
    EXPECT_LT((continued - direct).cwiseAbs().maxCoeff(), 1e-6) << model;
  }
}

TEST(Continuation, CarriesHeldNodesAndDirectorsOfTheRightLength) {
  const Built hanging(square_sheet(36, hung, "model = \"shell\"\n", 0.1));
  const auto coarser = coarser_cases(hanging.c, hanging.model);
  ASSERT_EQ(coarser.size(), 1U);
  const auto& model = hanging.model;
  const Vector q = carried(coarser.front().model, coarser.front().model.initial, model);
  for (const int i : model.mesh.sets.at("top")) EXPECT_EQ(point(q, i), point(model.initial, i));
  for (int i = 0; i < model.mesh.nodes(); ++i) {
    EXPECT_NEAR(point(q, model.mesh.nodes() + i).norm(), model.director_length, 1e-12);
    EXPECT_LT((point(q, i) - point(model.initial, i)).norm(), 5e-5);  // a few times the waviness of 10 µm
  }
}

TEST(Continuation, StopsWhenAskedToWithWhatItHas) {
  const Built hanging(square_sheet(24, hung));
  const auto coarser = coarser_cases(hanging.c, hanging.model);
  ASSERT_EQ(coarser.size(), 1U);
  int steps = 0;
  const auto start = start_on_coarser_meshes(
      hanging.c, hanging.model, coarser, [&](const QuadMesh&, const RelaxationStep&) { ++steps; },
      [&] { return steps == 3; });
  EXPECT_TRUE(start.stopped);
  EXPECT_EQ(start.iterations, 3);
  EXPECT_EQ(start.q.size(), hanging.model.initial.size());
}

}  // namespace
}  // namespace sundrape

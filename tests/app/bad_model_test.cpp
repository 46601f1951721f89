// Cases that read well and only turn out to be impossible once the mesh is there.
#include <string>

#include <gtest/gtest.h>

#include "sundrape/io/case_error.hpp"

#include "sample_cases.hpp"

namespace sundrape {
namespace {

/// Tables that the sample cannot be run with, and what the user must be told.
struct Impossible {
  std::string name;
  std::string more;  // begins on line 13
  int line;
  std::string key;
  std::string message;  // part of it
};

void PrintTo(const Impossible& impossible, std::ostream* out) { *out << impossible.name; }

class ImpossibleModel : public testing::TestWithParam<Impossible> {};

TEST_P(ImpossibleModel, IsRefusedWithFileLineAndKey) {
  const auto& impossible = GetParam();
  try {
    (void)samples::model_of(samples::sheet_case(impossible.more), "folder/CASE.toml");
    FAIL() << "accepted";
  } catch (const CaseError& error) {
    EXPECT_EQ(error.file(), "folder/CASE.toml");
    EXPECT_EQ(error.line(), impossible.line) << error.what();
    EXPECT_EQ(error.key(), impossible.key) << error.what();
    EXPECT_NE(error.message().find(impossible.message), std::string::npos) << error.what();
  }
}

const std::string far_away = "{ box = [[1, 1, 1], [2, 2, 2]] }\n";
const std::string inside = "{ sphere = { centre = [0, 0, 0], radius = 0.021 } }\n";

const std::vector<Impossible> impossible{
    {"SupportOfNoNode", "[[fix]]\nnodes = " + far_away, 14, "fix.0.nodes", "selects no node"},
    {"ForceOnNoNode", "[[load]]\nkind = \"force\"\ntotal = [1, 0, 0]\nnodes = " + far_away, 16, "load.1.nodes",
     "selects no node"},
    {"UnknownSet", "[[fix]]\nnodes = \"hem\"\n", 14, "fix.0.nodes", "hem"},
    {"MisspeltSet", "[[fix]]\nnodes = \"lefft\"\n", 14, "fix.0.nodes", "left"},
    {"MomentInside", "[[load]]\nkind = \"moment\"\ntotal = [0, 1e-6, 0]\nnodes = " + inside, 16, "load.1.nodes",
     "edge"},
    {"TractionInside", "[[load]]\nkind = \"traction\"\nper_length = [1, 0, 0]\nnodes = " + inside, 16, "load.1.nodes",
     "edge"},
    {"AllHeld", "[[fix]]\nnodes = \"all\"\n", 14, "fix.0.nodes", "every node of the cloth is held"},
    {"AllHeldTogether",
     "[[fix]]\nnodes = \"all\"\ncomponents = [\"x\", \"y\"]\n[[fix]]\nname = \"down\"\nnodes = { box = [[-1, -1, -1], "
     "[1, 1, 1]] }\ncomponents = [\"z\"]\n",
     14, "fix.0.nodes", "every node of the cloth is held"},
};

INSTANTIATE_TEST_SUITE_P(Of, ImpossibleModel, testing::ValuesIn(impossible),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sundrape

#include <gtest/gtest.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/study.hpp"

namespace sundrape {
namespace {

const std::string beside = std::string(SUNDRAPE_SOURCE_DIR) + "/cases/STUDY.toml";
const std::string head = "case = \"tablecloth_static.toml\"\n";

Study study_of(const std::string& text) { return parse_study(head + text, beside); }

/// What the values of an axis over a key set.
std::vector<std::string> values_of(const std::string& values) {
  const auto study = study_of("[[axis]]\nkey = \"cloth.waviness.seed\"\nvalues = " + values + "\n");
  std::vector<std::string> set;
  for (const auto& value : study.axes.at(0).values) {
    EXPECT_EQ(value.settings.size(), 1U);
    EXPECT_TRUE(value.settings.at(0).starts_with("cloth.waviness.seed="));
    set.push_back(value.settings.at(0).substr(20));
  }
  return set;
}

using Texts = std::vector<std::string>;

TEST(Study, TakesListsAsTheyStandAndRangesByStepOrCount) {
  EXPECT_EQ(values_of("[1, 2, 5]"), (Texts{"1", "2", "5"}));
  EXPECT_EQ(values_of("{ from = 1, to = 4 }"), (Texts{"1", "2", "3", "4"}));
  EXPECT_EQ(values_of("{ from = 0, to = 1, step = 0.4 }"), (Texts{"0", "0.4", "0.8"}));
  EXPECT_EQ(values_of("{ from = 0, to = 0.3, step = 0.1 }"), (Texts{"0", "0.1", "0.2", "0.3"}));  // despite round-off
  EXPECT_EQ(values_of("{ from = 1, to = 2, count = 3, unit = \"mm\" }"), (Texts{"\"1 mm\"", "\"1.5 mm\"", "\"2 mm\""}));
  EXPECT_EQ(values_of("{ from = 0.01, to = 1, count = 3, spacing = \"log\" }"), (Texts{"0.01", "0.1", "1"}));
  EXPECT_EQ(values_of("{ from = 2, to = 1, count = 2 }"), (Texts{"2", "1"}));
}

TEST(Study, IsTheProductOfItsAxesWithTheLastOneFastest) {
  const auto study = study_of(
      "title = \"T\"\nset = [\"relaxation.tolerance=1e-7\"]\n[[axis]]\nkey = \"material.poisson\"\nvalues = [0, 0.3]\n"
      "[[axis]]\nkey = \"cloth.waviness.seed\"\nvalues = [7, 8, 9]\n");
  EXPECT_EQ(study.runs(), 6U);
  EXPECT_EQ(study.combination(4), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(study.settings(4), (Texts{"relaxation.tolerance=1e-7", "material.poisson=0.3", "cloth.waviness.seed=8"}));
  EXPECT_EQ(study.branches->same_shape, 0.01);
  EXPECT_FALSE(study.resume);
}

TEST(Study, GroupsByAxesThatChangeTheCaseUnlessToldOtherwise) {
  const std::string axes =
      "[[axis]]\nkey = \"cloth.waviness.seed\"\nvalues = [1, 2]\n[[axis]]\nkey = \"material.poisson\"\nvalues = [0, "
      "0.3]\n"
      "[[axis]]\nkey = \"relaxation.first_step\"\nvalues = [1e-3, 1e-2]\n";
  EXPECT_EQ(study_of(axes).branches->group_axes, (std::vector<std::size_t>{1}));
  EXPECT_EQ(study_of(axes + "[branches]\ngroup_by = []\n").branches->group_axes, (std::vector<std::size_t>{}));
  EXPECT_EQ(study_of(axes + "[branches]\ngroup_by = [\"relaxation.first_step\", \"cloth.waviness.seed\"]\n")
                .branches->group_axes,
            (std::vector<std::size_t>{0, 2}));
}

const std::string axis_of_cells = "[[axis]]\nkey = \"cloth.cells\"\nvalues = [[10, 10], [20, 20]]\n";

TEST(Study, KnowsNumbersOfValuesThatHaveThemInOneUnit) {
  const auto axis = [](const std::string& values) {
    return study_of("[[axis]]\nkey = \"material.thickness\"\nvalues = " + values + "\n").axes.at(0);
  };
  const auto lengths = axis("[\"0.5 mm\", \"1 mm\"]");
  EXPECT_EQ(lengths.unit, "mm");
  EXPECT_EQ(lengths.values.at(0).label, "0.5 mm");
  EXPECT_EQ(lengths.values.at(0).number, 0.5);
  EXPECT_EQ(axis("[1e-3, 2e-3]").values.at(1).number, 2e-3);
  EXPECT_FALSE(axis("[\"0.5 mm\", \"1 cm\"]").values.at(0).number);
  EXPECT_FALSE(study_of(axis_of_cells).axes.at(0).values.at(0).number);
}

TEST(Study, HasAxesOfSeveralKeysWithLabels) {
  const auto study = study_of(
      "[[axis]]\nname = \"net\"\nsettings = [[\"model=particle\", \"cloth.cells=[20, 20]\"], [\"model=shell\"]]\n"
      "labels = [\"fine net\", \"shell\"]\n" +
      std::string("[[axis]]\nkey = \"cloth.waviness.seed\"\nvalues = [1, 2]\n"));
  EXPECT_EQ(study.runs(), 4U);
  EXPECT_EQ(study.axes.at(0).keys, (Texts{"model", "cloth.cells"}));
  EXPECT_EQ(study.value(0, 0).label, "fine net");
  EXPECT_EQ(study.settings(1), (Texts{"model=particle", "cloth.cells=[20, 20]", "cloth.waviness.seed=2"}));
  EXPECT_EQ(study.settings(2), (Texts{"model=shell", "cloth.waviness.seed=1"}));
}

TEST(Study, ReadsOutputsFiguresAndAReference) {
  const auto study = study_of("resume = true\n" + axis_of_cells +
                              "[[output]]\nname = \"tip\"\nvalue = \"at(probe.tip.z, 0.3 s) / 2\"\nunit = \"cm\"\n"
                              "[[figure]]\nname = \"f\"\nx = \"cloth.cells\"\ny = [\"tip\"]\nlog_y = true\n"
                              "[reference]\nset = [\"relaxation.tolerance=1e-9\"]\n");
  ASSERT_EQ(study.outputs.size(), 1U);
  EXPECT_DOUBLE_EQ(study.outputs.front().scale, 0.01);
  EXPECT_EQ(study.outputs.front().expression.reductions().at(0).at, 0.3);
  EXPECT_EQ(study.figures.at(0).y, (Texts{"tip"}));
  EXPECT_TRUE(study.figures.at(0).log_y);
  EXPECT_EQ(study.reference_settings(), (Texts{"relaxation.tolerance=1e-9"}));
  EXPECT_TRUE(study.resume);
  EXPECT_FALSE(study.branches);  // outputs are asked for instead
}

TEST(Study, FiguresDrawAllValuesOrThoseThatTheyName) {
  const std::string text = axis_of_cells +
                           "labels = [\"a\", \"b\"]\n[[output]]\nname = \"o\"\nvalue = \"steps\"\n"
                           "[[figure]]\nname = \"f\"\nx = \"o\"\ny = [\"o\"]\n";
  const std::string by = "by = \"cloth.cells\"\n";
  EXPECT_EQ(study_of(text).figures.at(0).curves, (Texts{}));
  EXPECT_EQ(study_of(text + by).figures.at(0).curves, (Texts{"a", "b"}));
  EXPECT_EQ(study_of(text + by + "curves = [\"b\", \"a\"]\n").figures.at(0).curves, (Texts{"b", "a"}));
}

struct Bad {
  std::string text;  // from line 2 on
  int line;
  std::string key, message;
};

TEST(Study, RefusesWhatIsWrongWithFileLineAndKey) {
  const std::string axis = "[[axis]]\nkey = \"cloth.waviness.seed\"\nvalues = ";
  const std::string figure =
      "[[output]]\nname = \"o\"\nvalue = \"steps\"\n[[figure]]\nname = \"f\"\nx = \"o\"\ny = [\"o\"]\n";
  const std::string by = "by = \"cloth.waviness.seed\"\n";
  const std::vector<Bad> all{
      {"", 1, "axis", "missing"},
      {"axis = []\n", 2, "axis", "needs an axis"},
      {"[[axs]]\n", 2, "axs", "did you mean 'axis'"},
      {axis + "[]\n", 4, "axis.0.values", "empty"},
      {axis + "3\n", 4, "axis.0.values", "a list of values or a range"},
      {axis + "[1, 2, 1]\n", 4, "axis.0.values", "1 stands there twice"},
      {axis + "{ from = 1, too = 3 }\n", 4, "axis.0.values.too", "did you mean 'to'"},
      {axis + "{ from = 1 }\n", 4, "axis.0.values.to", "missing"},
      {axis + "{ from = 3, to = 1 }\n", 4, "axis.0.values.to", "below `from`"},
      {axis + "{ from = 1, to = 9, step = 0 }\n", 4, "axis.0.values.step", "outside (0"},
      {axis + "{ from = 1, to = 9, step = 1, count = 2 }\n", 4, "axis.0.values.step", "not both"},
      {axis + "{ from = 0, to = 9, count = 3, spacing = \"log\" }\n", 4, "axis.0.values.spacing", "above 0"},
      {axis + "{ from = 0, to = 9e9 }\n", 4, "axis.0.values", "more than 100000"},
      {axis + "[1]\n" + axis + "[2]\n", 6, "axis.1.key", "the name of two axes"},
      {axis + "[1]\n" + axis + "[2]\nname = \"other\"\n", 6, "axis.1.key", "the key of two axes"},
      {axis + "[1]\nsettings = [[\"a=1\"]]\n", 5, "axis.0.settings", "not both"},
      {"[[axis]]\n", 2, "axis.0.key", "`key` with `values`, or `settings`"},
      {"[[axis]]\nsettings = [[\"a=1\"]]\n", 2, "axis.0.name", "needs a name"},
      {"[[axis]]\nname = \"n\"\nsettings = [[\"a\"]]\n", 4, "axis.0.settings", "'a' is no setting"},
      {"[[axis]]\nname = \"n\"\nsettings = [\"a=1\"]\n", 4, "axis.0.settings.0", "a list of strings"},
      {axis + "[1, 2]\nlabels = [\"a\"]\n", 5, "axis.0.labels", "1 labels of 2 values"},
      {axis + "[1]\n[[output]]\nname = \"o\"\nvalue = \"steps +\"\n", 7, "output.0.value", "cannot be read"},
      {axis + "[1]\n[[output]]\nname = \"o\"\nvalue = \"steps\"\nunit = \"cmm\"\n", 8, "output.0.unit",
       "unknown unit 'cmm'"},
      {axis + "[1]\n[[output]]\nname = \"status\"\nvalue = \"steps\"\n", 6, "output.0.name", "another column"},
      {axis + "[1]\n[[output]]\nname = \"o\"\nvalue = \"steps\"\n[[figure]]\nname = \"f\"\nx = \"o\"\ny = [\"oo\"]\n",
       11, "figure.0.y", "did you mean 'o'"},
      {axis + "[1, 2]\n" + figure + "curves = [\"1\"]\n", 12, "figure.0.curves", "with `by`"},
      {axis + "[1, 2]\n" + figure + by + "curves = []\n", 13, "figure.0.curves", "empty"},
      {axis + "[1, 2]\n" + figure + by + "curves = [\"1\", \"3\"]\n", 13, "figure.0.curves", "accepted: 1, 2"},
      {axis + "[1, 2]\n" + figure + by + "curves = [\"2\", \"2\"]\n", 13, "figure.0.curves", "2 stands there twice"},
      {axis + "[1]\n[branches]\nsame_shape = 2\n", 6, "branches.same_shape", "outside (0, 1]"},
      {axis + "[1]\n[branches]\ngroup_by = [\"cloth.waviness.sed\"]\n", 6, "branches.group_by", "did you mean"},
      {axis + "[1]\n[branches]\ngroup_by = [3]\n", 6, "branches.group_by.0", "a string is expected"},
      {"set = \"a=1\"\n" + axis + "[1]\n", 2, "set", "a list of strings"},
      {"thickness = 1\n", 2, "thickness", "unknown key"},
  };
  for (const auto& bad : all) {
    try {
      (void)study_of(bad.text);
      ADD_FAILURE() << "accepted:\n" << bad.text;
    } catch (const CaseError& error) {
      EXPECT_EQ(error.file(), beside);
      EXPECT_EQ(error.line(), bad.line) << error.what();
      EXPECT_TRUE(error.key().starts_with(bad.key)) << error.what();
      EXPECT_NE(error.message().find(bad.message), std::string::npos) << error.what();
    }
  }
}

TEST(Study, NeedsItsCase) {
  try {
    (void)parse_study("case = \"absent.toml\"\n[[axis]]\nkey = \"a\"\nvalues = [1]\n", beside);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.line(), 1);
    EXPECT_EQ(error.message(), "'absent.toml' is not there (sought beside the study file)");
  }
}

}  // namespace
}  // namespace sundrape

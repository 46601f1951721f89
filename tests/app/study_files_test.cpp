#include <filesystem>

#include <gtest/gtest.h>

#include "sundrape/app/study_table.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {
namespace {

// That each of them is worth its time is for the slow tests; that each can be run is for this one.
TEST(StudyFiles, AreReadWithAllTheirCasesAndOutputs) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SUNDRAPE_SOURCE_DIR) + "/cases/studies")) {
    ++files;
    try {
      const auto study = read_study(entry.path());
      for (std::size_t run = 0; run < study.runs(); ++run)
        require_outputs(study, read_case(study.case_file, study.settings(run)));
      if (study.reference) (void)read_case(study.case_file, study.reference_settings());
    } catch (const CaseError& problem) {
      ADD_FAILURE() << problem.what();
    }
  }
  EXPECT_GE(files, 10);
}

}  // namespace
}  // namespace sundrape

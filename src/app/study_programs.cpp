#include "sundrape/app/study_programs.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <fstream>
#include <list>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/child_process.hpp"

#include "last_line.hpp"

namespace sundrape {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// One call of a program on one result.
struct Call {
  std::size_t run, program;
  fs::path report, log;
};

std::string replaced(std::string word, const std::string& mark, const std::string& by) {
  for (auto at = word.find(mark); at != std::string::npos; at = word.find(mark, at + by.size()))
    word.replace(at, mark.size(), by);
  return word;
}

std::vector<std::string> words(const StudyProgram& program, const Call& call, const fs::path& result) {
  std::vector<std::string> all{"/usr/bin/env"};  // finds the program as a shell would
  for (const auto& word : program.command)
    all.push_back(replaced(replaced(word, "{result}", result.string()), "{json}", call.report.string()));
  return all;
}

void read_report(const StudyProgram& program, const Call& call, ProgramNumbers& numbers) {
  std::ifstream stream(call.report);
  const auto report = nlohmann::json::parse(stream, nullptr, false);
  for (const auto& [name, pointer] : program.numbers) {
    const nlohmann::json::json_pointer place(pointer);
    if (report.is_discarded() || !report.contains(place) || !report.at(place).is_number())
      numbers.problems.push_back(fmt::format("{}: no number at {} of {}", name, pointer, call.report.string()));
    else
      numbers.values[name] = report.at(place).get<double>();
  }
}

std::deque<Call> calls(const Study& study, const std::vector<BatchOutcome>& runs) {
  std::deque<Call> all;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (runs[run].status != BatchStatus::done) continue;
    for (std::size_t k = 0; k < study.programs.size(); ++k) {
      auto stem = runs[run].result;
      stem.replace_extension();
      if (study.programs.size() > 1) stem += fmt::format(".{}", k + 1);
      auto report = stem, log = stem;
      report += ".json";
      log += ".program.log";
      all.push_back({run, k, report, log});
    }
  }
  return all;
}

}  // namespace

std::vector<ProgramNumbers> run_programs(const Study& study, const std::vector<BatchOutcome>& runs, int jobs) {
  std::vector<ProgramNumbers> numbers(runs.size());
  if (jobs <= 0) jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  auto waiting = calls(study, runs);
  std::list<std::pair<Call, ChildProcess>> working;
  while (!waiting.empty() || !working.empty()) {
    while (!waiting.empty() && static_cast<int>(working.size()) < jobs) {
      const auto call = waiting.front();
      waiting.pop_front();
      fs::remove(call.report);
      working.emplace_back(call,
                           ChildProcess(words(study.programs[call.program], call, runs[call.run].result), call.log));
    }
    std::this_thread::sleep_for(5ms);
    for (auto work = working.begin(); work != working.end();) {
      const auto status = work->second.status();
      if (!status) {
        ++work;
        continue;
      }
      const auto& call = work->first;
      const auto& program = study.programs[call.program];
      if (*status == 0) {
        read_report(program, call, numbers[call.run]);
        fs::remove(call.log);
      } else {
        numbers[call.run].problems.push_back(
            fmt::format("{} failed: {}", program.command.front(), last_line(call.log)));
      }
      work = working.erase(work);
    }
  }
  return numbers;
}

}  // namespace sundrape

#include "slurm_executor.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/file_error.hpp"

#include "write_text.hpp"

namespace sundrape {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr std::size_t largest_array = 1000;  // Slurm's own default limit is 1001
constexpr auto between_looks = 2s;           // at the queue
constexpr int most_misses = 3;               // looks: a file may take some seconds to appear on another machine
constexpr const char* array_script = R"(#!/bin/sh
exec /bin/sh "$1/$SLURM_ARRAY_TASK_ID.sh"
)";

std::string identity(const std::string& name, const std::string& key) { return name + "\n" + key; }

}  // namespace

SlurmExecutor::SlurmExecutor(const ExecutorOptions& options, const fs::path& folder)
    : options_(options),
      folder_(fs::absolute(folder) / ".slurm"),
      job_name_(fmt::format("sundrape-{:016x}", std::hash<std::string>()(fs::absolute(folder).string()))) {
  for (const auto* program : {"sbatch", "squeue", "scancel"})
    if (!is_on_path(program))
      throw std::invalid_argument(fmt::format(
          "--executor slurm: '{}' is not on the path: start this on a machine of the cluster (Debian's package is "
          "slurm-client), or use --executor local",
          program));
  fs::create_directories(folder_);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const auto name = entry.path().filename().string();
    int array = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), array).ec == std::errc())
      arrays_ = std::max(arrays_, array);
  }
  adopt();
}

ScriptedTasks SlurmExecutor::scripts(int array) const { return ScriptedTasks(folder_ / std::to_string(array)); }

std::optional<std::set<SlurmExecutor::Place>> SlurmExecutor::queued() const {
  const auto answer = ask({"squeue", "--noheader", "--array", "--format=%j %K"}, folder_ / "squeue.txt");
  if (answer.status != 0) return std::nullopt;
  std::set<Place> places;
  std::istringstream lines(answer.out);
  for (std::string name, number; lines >> name >> number;) {
    if (!name.starts_with(job_name_ + "-")) continue;
    Place place;
    const auto array = name.substr(job_name_.size() + 1);
    std::from_chars(array.data(), array.data() + array.size(), place.array);
    std::from_chars(number.data(), number.data() + number.size(), place.number);
    places.insert(place);
  }
  return places;
}

void SlurmExecutor::adopt() {
  const auto there = queued();
  if (!there) throw std::invalid_argument("--executor slurm: squeue does not answer: is the cluster up?");
  for (const auto& place : *there) {
    if (scripts(place.array).status(place.number)) continue;
    const auto [name, key] = scripts(place.array).owner(place.number);
    orphans_.emplace(place, identity(name, key));
  }
}

void SlurmExecutor::submit(const Task& task) {
  const auto orphan =
      std::ranges::find(orphans_, identity(task.name, task.key), &decltype(orphans_)::value_type::second);
  if (orphan == orphans_.end()) {
    unsent_.push_back(task);
    return;
  }
  working_.emplace(orphan->first, Working{.id = task.id});
  orphans_.erase(orphan);
}

void SlurmExecutor::send() {
  if (!orphans_.empty()) {  // work of an earlier process that nobody wants any more, or not so
    std::set<Place> unwanted;
    for (const auto& [place, what] : orphans_) unwanted.insert(place);
    cancel(unwanted);
    for (;;) {  // two must not write one result
      const auto there = queued();
      if (there && std::ranges::none_of(unwanted, [&](const auto& place) { return there->contains(place); })) break;
      std::this_thread::sleep_for(500ms);
    }
    orphans_.clear();
  }
  for (std::size_t first = 0; first < unsent_.size(); first += largest_array) {
    const auto from = unsent_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(largest_array, unsent_.size() - first);
    send_array({from, from + static_cast<std::ptrdiff_t>(count)});
  }
  unsent_.clear();
}

void SlurmExecutor::send_array(const std::vector<Task>& tasks) {
  const int array = ++arrays_;
  const auto written = scripts(array);
  fs::create_directories(written.folder());
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const Place place{array, static_cast<int>(k) + 1};
    written.write(place.number, tasks[k]);
    working_.emplace(place, Working{.id = tasks[k].id});
  }
  write_text(written.folder() / "array", array_script);
  std::vector<std::string> command{
      "sbatch",
      "--parsable",
      "--no-requeue",
      fmt::format("--array=1-{}{}", tasks.size(), options_.jobs > 0 ? fmt::format("%{}", options_.jobs) : ""),
      fmt::format("--job-name={}-{}", job_name_, array),
      "--ntasks=1",
      "--output=" + (written.folder() / "slurm-%a.log").string()};
  std::istringstream more(options_.slurm_options);
  for (std::string word; more >> word;) command.push_back(word);
  command.push_back((written.folder() / "array").string());
  command.push_back(written.folder().string());
  const auto answer = ask(command, written.folder() / "sbatch.txt");
  if (answer.status != 0)
    throw FileError(fmt::format("sbatch refuses the jobs of {}: {}", folder_.string(),
                                answer.out.substr(0, answer.out.find_last_not_of('\n') + 1)));
  last_look_ = Clock::now();
}

std::vector<EndedTask> SlurmExecutor::ended() {
  send();
  std::vector<EndedTask> all;
  for (auto work = working_.begin(); work != working_.end();) {
    if (const auto status = scripts(work->first.array).status(work->first.number)) {
      all.push_back({work->second.id, *status});
      work = working_.erase(work);
    } else {
      ++work;
    }
  }
  if (!working_.empty() && Clock::now() - last_look_ > between_looks) look_for_the_lost(all);
  return all;
}

void SlurmExecutor::look_for_the_lost(std::vector<EndedTask>& ended) {
  last_look_ = Clock::now();
  const auto there = queued();
  if (!there) return;
  for (auto work = working_.begin(); work != working_.end();) {
    work->second.missed = there->contains(work->first) ? 0 : work->second.missed + 1;
    if (work->second.missed >= most_misses && !scripts(work->first.array).status(work->first.number)) {
      ended.push_back({work->second.id, EndedTask::lost});
      work = working_.erase(work);
    } else {
      ++work;
    }
  }
}

void SlurmExecutor::cancel(const std::set<Place>& places) const {
  std::map<int, std::vector<int>> by_array;
  for (const auto& place : places) by_array[place.array].push_back(place.number);
  for (const auto& [array, numbers] : by_array) {
    const auto name = fmt::format("--name={}-{}", job_name_, array);
    const auto log = folder_ / "scancel.txt";
    (void)ask({"scancel", "--quiet", "--state=PENDING", name}, log);
    (void)ask({"scancel", "--quiet", "--full", "--signal=INT", "--state=RUNNING", name}, log);
  }
}

void SlurmExecutor::interrupt() {
  unsent_.clear();
  std::set<Place> places;
  for (const auto& [place, work] : working_) places.insert(place);
  cancel(places);
}

}  // namespace sundrape

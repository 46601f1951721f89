#include "traced_path.hpp"

#include "sundrape/app/solver_choice.hpp"

namespace sundrape {
namespace {

class Notes final : public PathObserver {
 public:
  explicit Notes(TracedPath& path) : path_(path) {}
  void step(const PathPosition& at, const PathStep& step) override {
    path_.steps.push_back({at.stage, at.load_factor, at.q, step});
  }
  void iteration(const PathPosition& from, int /*iteration*/, double load_factor, double residual) override {
    path_.iterations.push_back({from.steps + 1, load_factor, residual});
  }
  void critical_point(const CriticalPoint& point) override { path_.critical.push_back(point); }
  void remark(const std::string& text) override { path_.remarks.push_back(text); }
  void warn(const std::string& text) override { path_.warnings.push_back(text); }
  [[nodiscard]] bool wants_to_stop() override { return false; }

 private:
  TracedPath& path_;
};

}  // namespace

TracedPath trace(const Benchmark& b) {
  TracedPath path;
  Notes notes(path);
  PathPosition at;
  at.q = b.model.initial;
  path.result = follow_path(*b.model.system, path_options(b.c, b.model), at, notes);
  return path;
}

}  // namespace sundrape

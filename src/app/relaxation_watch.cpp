#include "relaxation_watch.hpp"

#include <fmt/format.h>

namespace sundrape {
namespace {

constexpr int frame_every = 5;  // iterations

}  // namespace

RelaxationWatch::RelaxationWatch(const Case& c, const CaseModel& model, Recorder& recorder, Progress& progress,
                                 double first_step)
    : case_(c),
      model_(model),
      recorder_(recorder),
      progress_(progress),
      still_(Vector::Zero(model.initial.size())),
      initial_load_(model.system->energies({0, model.initial, still_}).load),
      stop_(c.relaxation.time_limit) {
  now_.step_size = first_step;
  if (const auto& restart = recorder.restart())
    before_ = now_ = {restart->time, restart->step_size, restart->totals.at(0), restart->totals.at(1)};
}

void RelaxationWatch::step(const State& all, const RelaxationStep& step) {
  if (due_) {  // not at once: what turns out to be the last frame is written with its stability
    frame(*due_);
    checkpoint(*due_);
    due_.reset();
  }
  const int factored = case_.relaxation.scheme == "chapter" ? 0 : 1 + step.refused;
  now_ = {before_.time + step.time, step.step_size, before_.iterations + step.iteration,
          now_.factorizations + factored};
  is_new_ = true;
  const auto contact = recorder_.step({now_.time, all.q, all.v});
  recorder_.step_values({{"time", now_.time},
                         {"step_size", step.step_size},
                         {"residual", step.residual},
                         {"newton_iterations", 1},
                         {"contacts", contact.contacts},
                         {"negative_pivots", -1}});
  if (++steps_ % frame_every == 0) due_ = all.q;
  if (progress_.due())
    progress_.show(fmt::format("iteration {}, residual {:.2e}, step {:.2e} s, {} contacts", now_.iterations,
                               step.residual, step.step_size, contact.contacts),
                   -1);
}

void RelaxationWatch::coarse_step(const QuadMesh& mesh, const RelaxationStep& step) {
  if (progress_.due())
    progress_.show(fmt::format("coarser mesh of {} nodes: iteration {}, residual {:.2e}, step {:.2e} s", mesh.nodes(),
                               step.iteration, step.residual, step.step_size),
                   -1);
}

void RelaxationWatch::begin_again(const Vector& q, double time, double step_size) {
  due_.reset();
  now_.time = time;
  now_.step_size = step_size;
  before_ = now_;
  frame(q);
  checkpoint(q);
}

EnergyAudit::Balance RelaxationWatch::balance_of(const State& all) const {
  EnergyAudit::Balance b;
  b.energies = model_.system->energies(all);
  // Loads without a potential do no work that a fictitious motion could account for; what dead loads did is exact.
  b.external_work = initial_load_ - b.energies.load;
  return b;
}

void RelaxationWatch::frame(const Vector& q, std::optional<int> pivots) {
  const State all{now_.time, q, still_};
  recorder_.frame(all, balance_of(all), pivots);
  is_new_ = false;
}

void RelaxationWatch::checkpoint(const Vector& q) {
  const State all{now_.time, q, still_};
  recorder_.checkpoint(all, balance_of(all), 0, now_.step_size, {now_.iterations, now_.factorizations});
}

}  // namespace sundrape

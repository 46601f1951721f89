#include "sundrape/integrate/dynamics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sundrape {

Dynamics::Dynamics(const System& system, Integrator& integrator, std::vector<double> frame_times,
                   DynamicsObserver& observer, EventSource* events, Timetable* timetable)
    : system_(system),
      integrator_(integrator),
      frame_times_(std::move(frame_times)),
      observer_(observer),
      events_(events),
      timetable_(timetable) {
  if (frame_times_.empty()) throw std::invalid_argument("a dynamic run needs at least one frame time: its end");
  const auto all = 3 * static_cast<Eigen::Index>(system.unknowns().points());
  for (auto* x : {&q_, &v_, &frame_q_, &frame_v_}) x->setZero(all);
  for (auto* x : {&rows_q_, &rows_v_}) x->setZero(system.unknowns().size());
}

void Dynamics::carry_over(const EnergyAudit::Balance& before, double initial_energy) {
  carried_ = {before, initial_energy};
}

void Dynamics::expand_last() {
  integrator_.state(rows_q_, rows_v_);
  system_.expand(time_, rows_q_, rows_v_, q_, v_);
}

void Dynamics::emit_frames(std::size_t& next) {
  for (; next < frame_times_.size() && frame_times_[next] <= time_; ++next) {
    const double at = frame_times_[next];
    if (at == time_) {
      frame_q_ = q_;
      frame_v_ = v_;
    } else {
      integrator_.interpolate(at, rows_q_, rows_v_);
      system_.expand(at, rows_q_, rows_v_, frame_q_, frame_v_);
    }
    const State frame{at, frame_q_, frame_v_};
    observer_.frame(frame, audit_->at(frame));
  }
}

void Dynamics::restart() {
  system_.unknowns().gather(q_, rows_q_);
  system_.unknowns().gather(v_, rows_v_);
  system_.unknowns().clear_held(rows_v_);
  system_.expand(time_, rows_q_, rows_v_, q_, v_);
  integrator_.start(time_, rows_q_, rows_v_);
  if (sensitivity_ != nullptr) sensitivity_->restart(time_);
}

void Dynamics::let_supports_change() {
  const auto e = system_.energies(last());
  timetable_->happen(last());
  restart();
  audit_->supports_changed(last(), e.total() - e.load);
}

DynamicsEnd Dynamics::run(double time, ConstVectorRef q, ConstVectorRef v, bool first_frame) {
  time_ = time;
  q_ = q;
  v_ = v;
  restart();
  audit_ = std::make_unique<EnergyAudit>(system_, last());
  if (carried_) audit_->resume(carried_->first, carried_->second);
  if (is_due()) let_supports_change();

  std::size_t next = 0;
  while (next < frame_times_.size() && (frame_times_[next] < time || (!first_frame && frame_times_[next] <= time)))
    ++next;
  emit_frames(next);

  const double end = frame_times_.back();
  while (time_ < end) {
    const double stop = timetable_ ? std::min(end, timetable_->next()) : end;
    const auto report = integrator_.step(stop);
    // the last step may end a rounding error short of the stop
    time_ = std::abs(report.time - stop) < 1e-12 * std::abs(stop) ? stop : report.time;
    expand_last();
    if (!q_.allFinite() || !v_.allFinite())
      throw IntegrationFailure(fmt::format("the motion is no longer finite at t = {:.6g} s", time_));
    if (sensitivity_ != nullptr) sensitivity_->step(report, last());
    audit_->advance(last(), events_ ? events_->dissipated() : 0.0);
    emit_frames(next);
    if (report.event && events_ && events_->happen(time_, q_, v_, integrator_.fired())) {
      restart();
      audit_->advance(last(), events_->dissipated());
    }
    if (is_due()) let_supports_change();
    if (events_) events_->accepted(last());
    observer_.step(last(), report, integrator_);
    if (time_ < end && observer_.wants_to_stop()) return DynamicsEnd::stopped;
  }
  return DynamicsEnd::reached;
}

}  // namespace sundrape

#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "sundrape/app/model.hpp"

#include "sheet.hpp"

namespace sundrape {

/// What holds a case's sheet, from when to when, and along which paths what moves is carried. Reactions and grippers of
/// the model are listed on the way.
class SupportBuilder {
 public:
  /// @param placed  where the nodes stand at the start, N
  /// @throws CaseError  selectors that pick nothing; a gripper that is to carry away what is held for good
  SupportBuilder(const Case& c, CaseModel& model, const std::vector<Vector3>& placed);

  [[nodiscard]] const Supports& at_the_start() const { return start_; }
  /// Without those that let go.
  [[nodiscard]] const Supports& lasting() const { return lasting_; }
  /// One a `[[motion]]`, and one a `[[fix]]` that is not there all the time; those of grippers carry nothing yet.
  [[nodiscard]] const std::vector<PrescribedMotion>& motions() const { return motions_; }

 private:
  struct Which {
    const std::string& name;
    const Selector& nodes;
    const GripCase& grip;
    const SourceLine& source;
  };
  struct What {
    Unknowns::Held position;
    bool clamps;
    Unknowns::Held director;
  };
  void add(const Which& which, const What& what, std::optional<PrescribedMotion> motion);
  [[nodiscard]] bool held_for_good(int node) const {
    return lasting_.position[static_cast<std::size_t>(node)] == Unknowns::Held{true, true, true};
  }
  static void hold(Supports& supports, const std::vector<int>& nodes, const What& what);

  const Case& case_;
  CaseModel& model_;
  const std::vector<Vector3>& placed_;
  Supports start_, lasting_;
  std::vector<PrescribedMotion> motions_;
  std::vector<std::pair<SourceLine, std::vector<int>>> taken_;  // by grippers that move
};

}  // namespace sundrape

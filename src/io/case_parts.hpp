#pragma once
#include "case_section.hpp"

namespace sundrape {

/// Resolvers of a case's parts, each from sections that have been checked key by key. All throw CaseError where values
/// that are right by themselves do not go together.
[[nodiscard]] ClothCase resolve_cloth(const CaseSection& cloth, const std::filesystem::path& folder);
[[nodiscard]] Place resolve_place(const CaseSection& place);
[[nodiscard]] Fabric resolve_fabric(const CaseSection& material);
[[nodiscard]] std::vector<FixCase> resolve_fixes(const std::vector<CaseSection>& fixes);
[[nodiscard]] std::vector<LoadCase> resolve_loads(const std::vector<CaseSection>& loads);
[[nodiscard]] std::vector<ObstacleCase> resolve_obstacles(const std::vector<CaseSection>& obstacles);
[[nodiscard]] ContactCase resolve_contact(const CaseSection& contact, double thickness);
[[nodiscard]] DynamicsCase resolve_dynamics(const CaseSection& dynamics);
[[nodiscard]] RelaxationCase resolve_relaxation(const CaseSection& relaxation);
[[nodiscard]] OutputCase resolve_output(const CaseSection& output, double duration);

}  // namespace sundrape

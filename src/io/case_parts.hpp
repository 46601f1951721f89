#pragma once
#include "case_section.hpp"

namespace sundrape {

/// Resolvers of a case's parts, each from sections that have been checked key by key. All throw CaseError where values
/// that are right by themselves do not go together.
[[nodiscard]] ClothCase resolve_cloth(const CaseSection& cloth, const std::filesystem::path& folder);
[[nodiscard]] Place resolve_place(const CaseSection& place);
[[nodiscard]] Fabric resolve_fabric(const CaseSection& material);
void resolve_bending(const CaseSection& bending, Fabric& fabric);
[[nodiscard]] ShellCase resolve_shell(const CaseSection& section);
[[nodiscard]] std::vector<FixCase> resolve_fixes(const std::vector<CaseSection>& sections, Model model,
                                                 Analysis analysis);
/// A path with its timing, of a gripper or an obstacle; its stages are left to the caller.
[[nodiscard]] PathCase resolve_course(const CaseSection& section, Analysis analysis);
/// Names of motions are told from those of supports too.
[[nodiscard]] std::vector<MotionCase> resolve_motions(const std::vector<CaseSection>& sections,
                                                      const std::vector<FixCase>& fixes, Model model,
                                                      Analysis analysis);
/// What a selector is called where the case gives no name.
[[nodiscard]] std::string name_of(const Selector& selector);
[[nodiscard]] std::vector<LoadCase> resolve_loads(const std::vector<CaseSection>& sections);
/// Relative files count from `folder`.
[[nodiscard]] std::vector<ObstacleCase> resolve_obstacles(const std::vector<CaseSection>& sections, Analysis analysis,
                                                          const std::filesystem::path& folder);
/// The absolute path that a key names; it must be there.
[[nodiscard]] std::filesystem::path file_beside(const CaseSection& section, const char* key,
                                                const std::filesystem::path& folder);
/// @param thickness  of the thickest fabric [m]
/// @param layers     there are several pieces of cloth
[[nodiscard]] ContactCase resolve_contact(const CaseSection& section, double thickness, bool layers);
[[nodiscard]] DynamicsCase resolve_dynamics(const CaseSection& section);
[[nodiscard]] RelaxationCase resolve_relaxation(const CaseSection& section);
[[nodiscard]] ArcLengthCase resolve_arc_length(const CaseSection& section);
/// @param top  of the whole case, whose keys the parameters are; @param resolved  the rest of it
[[nodiscard]] std::vector<ParameterCase> resolve_sensitivities(const CaseSection& top, const Case& resolved);
/// A key of the case whose value is a continuous number; `asked` is who asks for it, for messages.
[[nodiscard]] ParameterCase find_parameter(const CaseSection& top, const std::string& key, const SourceLine& asked);
[[nodiscard]] OutputCase resolve_output(const CaseSection& section, double duration);

/// Grips and releases in time, which dynamics alone follows.
[[nodiscard]] GripCase resolve_grip(const CaseSection& section, Analysis analysis);
/// Refuses a grip in time that holds a slope where the model is a particle net.
void require_directors(const CaseSection& section, Model model);
/// What is left out where supports or obstacles move, and what cannot be with them.
void resolve_moving_defaults(const CaseSection& top, Case& resolved);
/// Refuses what only a shell has where the model is another.
void require_shell_model(const CaseSection& top, const Case& resolved);
/// Refuses massless directors where the integrator needs an ODE.
void require_integrator_of_director(const CaseSection& top, const Case& resolved);
void require_scheme_of_shell(const CaseSection& top, const Case& resolved);
void require_damping_of_massless_directors(const CaseSection& top, const Case& resolved);

}  // namespace sundrape

#pragma once
#include <string>

#include "sundrape/io/case.hpp"
#include "sundrape/io/key_table.hpp"

namespace sundrape {

/// Finds a key of a resolved case whose value is a continuous number: a number, a quantity, or an entry of a list of
/// them ("material.bending.coefficients.0", "load.0.acceleration.2").
/// @param key    dotted, as for --set
/// @param asked  who asks for it, for messages
/// @throws CaseError  no such key, no number, a whole number, or a value that the case leaves to be worked out
[[nodiscard]] ParameterCase find_parameter(const Case& resolved, const std::string& key, const SourceLine& asked);

/// The case with a parameter at another value, all else as it was read.
/// @throws CaseError  a value that the key does not accept
[[nodiscard]] Case with_parameter(const Case& resolved, const ParameterCase& parameter, double value);

/// A setting KEY=VALUE, as for --set, that gives a parameter a value in SI.
[[nodiscard]] std::string parameter_setting(const std::string& key, double value);

}  // namespace sundrape

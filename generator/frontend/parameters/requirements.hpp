// Requirements in a manifest on parameters, ports and rate.
#pragma once

#include <optional>

#include "generator/frontend/library/condition.hpp"
#include "generator/frontend/parameters/config.hpp"

namespace eagerx::gen {

/// Adds the value of each parameter under its name.
void add_config(Facts& facts, const Config& config);

/// E0328 for each requirement that does not hold of `facts` and `config`; one whose facts are not
/// all known says nothing.
void check_requirements(const Entity& entity, const Config& config, Facts facts, Span span,
                        Diagnostics& diagnostics);
/// The same, where only parameters and the rate are known.
void check_requirements(const Entity& entity, const Config& config,
                        const std::optional<Rational>& rate_hz, Span span,
                        Diagnostics& diagnostics);

/// Whether all requirements that are about parameters alone hold.
bool meets_requirements(const Entity& entity, const Config& config);

}  // namespace eagerx::gen

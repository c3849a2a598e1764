// The settings of a composite where a graph or another composite uses it.
#pragma once

#include "generator/frontend/compose/scope.hpp"
#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// A rate is needed where something inside is of it.
FormatPtr composite_node_format();

/// Its parameters and its rate, as references of `scope`. False after a problem: those of
/// parameters, and E0202 without a rate that something inside refers to.
bool take_parameters(const Library& library, const YamlValue& settings, const Entity& entity,
                     Span span, Scope& scope, Diagnostics& diagnostics);

/// Whether the ports that are named under `key` ("inputs", "sensors", …) are in its manifest; if
/// not, E0307.
bool knows_ports(const YamlValue& settings, const Entity& entity, const char* key,
                 Diagnostics& diagnostics);

}  // namespace eagerx::gen

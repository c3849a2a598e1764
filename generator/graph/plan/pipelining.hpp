// How far the hub of a placed graph may run ahead while a part calculates.
#pragma once

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Writes into the links of `split` which parts are asked for messages before these are needed, how
/// many exchanges may be in flight, and why no more; and into `split` how much waits for them.
/// Needs everything else of both.
void plan_pipelining(const Plan& plan, Split& split);

}  // namespace eagerx::gen

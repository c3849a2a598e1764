// How far the hub of a placed graph may run ahead while a part calculates.
#pragma once

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Sets in the links of `split` the parts whose messages are requested before they are needed, how
/// many exchanges may be in flight, and the reason for that limit; and in `split` the size of the
/// pending trace. Needs all other members of both.
void plan_pipelining(const Plan& plan, Split& split);

}  // namespace eagerx::gen

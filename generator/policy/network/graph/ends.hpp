// Beginning and end of a policy: the observation and its parts, and the action.
#pragma once

#include <optional>
#include <string>

#include "generator/policy/network/graph/call.hpp"

namespace eagerx::gen {

/// The next part of an observation of several; `shape` has numbers.
NetValue observation_part(NetCall::State& state, const std::string& name, Dims shape);

struct NetAction {
  std::int32_t step = -1;               // that gives it; -1: the observation itself
  bool is_choice = false;               // it is the index of the largest number
  std::vector<std::uint32_t> groups{};  // of several choices: how many numbers each is among
};
/// `value` as an action; E0620 with `help` if it is constant, or why it is none.
std::optional<NetAction> action_of(const NetValue& value, const char* help, PolicyProblem& problem);

/// Where the layer of `part` takes that part of its state from; nullptr if it starts from zeros, or
/// has no memory.
const NetStateSource* state_before(const std::vector<NetStep>& steps, const NetRemembered& part);

}  // namespace eagerx::gen

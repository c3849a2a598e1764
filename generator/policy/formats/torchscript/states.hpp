// What a TorchScript module keeps in buffers from one observation to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/policy/formats/torchscript/archive.hpp"
#include "generator/policy/formats/torchscript/interpreter.hpp"

namespace eagerx::gen {

/// Where each number of `part` lies in `whole`, of which it is a view; nothing if that is unknown.
std::optional<Integers> places_of(NetCall::State& state, const NetValue& part,
                                  const NetValue& whole);
/// `whole` with `values` at these places; `part` has the shape that they are broadcast to.
std::optional<NetValue> with_part(const TorchCall& call, const NetValue& whole,
                                  const Integers& places, const NetValue& part,
                                  const NetValue& values);

/// Buffers that are written hold what cells remember, each its own, or the last values of
/// something; all begin with zeros. E0756 for others. Completes the layers of histories, and puts
/// the steps in an order in which each comes after those that it takes; `*action` is one of them.
bool check_torch_states(TorchArchive& archive, const TorchInterpreter& interpreter,
                        NetCall::State& state, std::int32_t& action, PolicyProblem& problem);

}  // namespace eagerx::gen

// Blocks of a slot: groups of nodes with one rate, and the calls of each node.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// Groups consecutive nodes with one rate under one condition; omits nodes without work in this
/// program.
View groups_view(const Plan& plan, const ProgramNames& names,
                 const std::vector<std::size_t>& nodes);

/// How a hub reads the messages of its parts' nodes that it requests before it needs them.
View takes_view(const Plan& plan, const ProgramNames& names);

/// Into `view`: `lag`, how many ticks later the messages of `node` come into this program, or
/// false.
void add_lag(const ProgramNames& names, std::size_t node, View& view);

/// How the hub requests the messages of `node` without waiting; false if it waits.
View ask_view(const Plan& plan, const ProgramNames& names, std::size_t node);

/// Where a message is written, by an expression that is cheap to repeat.
struct MessagePlace {
  std::string expression;  // "smooth_filtered_[0]", "new_filtered"
  std::string local;       // a reference to be made first: "new_filtered", or empty
  std::string ring;        // to this
};
MessagePlace message_place(const Plan& plan, const ProgramNames& names, std::size_t ring,
                           const std::string& seq);
/// The references among them.
View slots_view(const std::vector<MessagePlace>& places);

/// A message of a channel's ring, by its number and an expression for its value; `raw`: the value
/// before the processor of its output.
struct WrittenMessage {
  std::size_t ring = 0;
  std::string seq, value, raw = {};
};
/// Whether this is of an action that has to be moved into the space of its actuator.
bool is_kept_within(const Plan& plan, const Ring& ring);

/// Other rings that take it as the processor of one of its readers converts it, or as it was
/// before its own.
View conversions_view(const Plan& plan, const ProgramNames& names, const WrittenMessage& message);

}  // namespace eagerx::gen

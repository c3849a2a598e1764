// Blocks of a slot: groups of nodes with one rate, and the calls of each node.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// Neighbours of one rate under one condition; what has nothing to do in this program is left out.
View groups_view(const Plan& plan, const ProgramNames& names,
                 const std::vector<std::size_t>& nodes);

/// How a hub takes what nodes of its parts send, of those that it asks for before it needs them.
View takes_view(const Plan& plan, const ProgramNames& names);

/// Into `view`: `lag`, how many ticks later the messages of `node` come into this program, or
/// false.
void add_lag(const ProgramNames& names, std::size_t node, View& view);

/// How the hub asks for what `node` sends, without waiting for it; false if it waits.
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

/// A message of a channel's ring, by its number and an expression for its value; `raw`: what it was
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

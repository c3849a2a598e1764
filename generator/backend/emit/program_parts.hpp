// C++ names in a program for each rate, node, ring and object of a plan, by kind.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

/// Functions of more nodes take the optimizer more than linear time (templates/README.md); below
/// 100 nodes one function is easier to read.
inline constexpr std::size_t kMostNodesInOneFunction = 100;
inline constexpr std::size_t kNodesInPart = 32;
/// Programs of more nodes take g++ so much memory that it is worth a few percent of its time to
/// free it earlier.
inline constexpr std::size_t kMostNodesForFastCollection = 2000;

/// A data member of the program: "servo_", "drawing_.overlay_", "now.force_" or "servo_[3]".
struct EmitMember {
  /// Which struct has it.
  enum class Owner {
    program,
    drawing,   // what only pictures need
    one_step,  // vectorized messages that only the step needs that writes them
  };
  std::string name;  // "servo_"
  Owner owner = Owner::program;

  /// Members of equal chains are elements of one array.
  struct Element {
    std::size_t index, count;
    bool is_loops = false;  // inside a loop the index is `i`
  };
  std::optional<Element> element{};

  /// As the step calls it: "servo_[3]", "servo_[i]" inside a loop.
  [[nodiscard]] std::string expression() const;
  /// As its struct declares it, "servo_[12]"; empty for the elements of an array but the first.
  [[nodiscard]] std::string declaration() const;
};

struct EmitRate {
  std::string due;      // "k30Hz"
  std::string counter;  // "n30Hz_"
};

/// An input. Unneeded names are empty.
struct EmitInput {
  std::string processor;     // type
  std::string cursor;        // member: which messages it has received
  std::string fresh;         // member: whether a message is new, for windows of any length
  std::string delay_member;  // of a delay that may change
  std::string delay_state;   // field of States that sets it
};

struct EmitOutput {
  std::string processor;  // type; may be empty
  std::string channel;    // constant of the trace; a table's element inside a loop
  std::string port;       // what the trace calls it; empty without a channel
};

struct EmitState {
  std::string field;      // of States
  std::string processor;  // type; may be empty
  std::string type;       // of objects' engine states
};

struct EmitNode {
  std::string io;            // type: "SmoothIo"; nodes of equal structure share one
  std::size_t io_owner = 0;  // the node that it is named after
  EmitMember member;
  std::string label;  // an expression: "\"smooth\"", "kNamesOfServo[i]" inside a loop
  std::string sent;   // where inputs go by the clock: "smooth_sent_"
  std::vector<EmitInput> inputs;
  std::vector<EmitOutput> outputs;
  std::vector<EmitState> states;
  std::vector<std::string> target_processors;  // types, by target of a reset node
  std::string targets_member, done_member;     // of reset nodes
  std::vector<std::size_t> reader_rings;       // of its messages, each for one reader
};

struct EmitObject {
  std::string simulator_type, simulator_member;
  std::vector<EmitState> states;
};

}  // namespace eagerx::gen

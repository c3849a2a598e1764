// The C++ names of everything in a plan, given once and used by every template.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/backend/emit/literals.hpp"
#include "generator/backend/emit/marks.hpp"
#include "generator/backend/emit/namer.hpp"
#include "generator/backend/emit/render.hpp"
#include "generator/backend/emit/repeats.hpp"
#include "generator/backend/emit/shared_io.hpp"
#include "generator/graph/plan/packs.hpp"
#include "generator/graph/plan/plan.hpp"
#include "generator/graph/plan/split.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/policy/agent/use.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// What messages of packs are members of that only the step needs that writes them.
inline constexpr const char* kPassing = "now.";

struct ProgramNames {
  /// `loops`: equal chains of nodes are loops over arrays, as packs have none.
  ProgramNames(const Plan& plan, Part part, Numbers of = Numbers::plain, bool loops = false);

  Numbers numbers;

  std::vector<std::string> io;           // of nodes: "SmoothIo"; nodes of equal structure share one
  std::vector<std::size_t> io_owner;     // of nodes: the one that theirs is named after
  std::vector<std::string> node_member;  // "smooth_"
  std::vector<std::string> ring_member;  // "smooth_filtered_"
  std::vector<std::string> due, counter;                      // of rates: "k30Hz", "n30Hz_"
  std::vector<std::string> simulator_type, simulator_member;  // of objects
  std::vector<std::vector<std::string>> engine_state_type;    // of objects' states
  std::vector<std::vector<std::string>> output_processor,
      input_processor;                                  // types, by node and port
  std::vector<std::vector<std::string>> cursor, fresh;  // members, by node and input
  std::vector<std::string> sent;  // of nodes, where inputs go by the clock: "smooth_sent_"
  std::vector<std::vector<std::string>> node_state, object_state;  // fields of States
  std::vector<std::vector<std::string>> node_state_processor, object_state_processor,
      target_processor;  // types, by owner and state or target
  std::map<std::string, std::vector<std::string>> processor_stages;  // types in one of these
  std::vector<std::string> targets_member, done_member;              // of reset nodes
  std::vector<std::vector<std::string>> delay_member, delay_state;   // of delays that may change
  std::vector<std::vector<std::string>> channel;  // constants, by node and output
  std::vector<std::string> part_constant;         // of parts: "kVision"

  /// Equal chains of nodes. Their members and rings are elements of arrays: "servo_[3]".
  struct Loop {
    Repeat repeat;
    std::vector<std::string> labels;                 // tables of nodes' names, by node of a chain
    std::vector<std::vector<std::string>> channels;  // expressions, by node of a chain and output
    std::vector<std::pair<std::string, std::vector<std::string>>> tables;  // of channels
  };
  std::vector<Loop> loops;
  std::map<std::string, std::size_t> size_of_array;  // "servo_" → 12
  std::vector<std::string> label;                    // of nodes: "\"smooth\"", "kServo[i]"

  /// As the body of a loop calls everything: "servo_[i]".
  [[nodiscard]] ProgramNames inside(const Loop& loop) const;
  /// "servo_" of "servo_[3]".
  [[nodiscard]] static std::string array_of(const std::string& member) {
    return member.substr(0, member.find('['));
  }
  /// The declaration of a member, "servo_[12]"; empty for the elements of an array but the first.
  [[nodiscard]] std::string declared(const std::string& member) const;

  /// What there is in this program of a split graph; of a whole one everything.
  [[nodiscard]] bool is_split() const { return part_ != Part::whole; }
  [[nodiscard]] bool is_placed() const { return part_.is_placed(); }
  [[nodiscard]] bool is_hub() const { return part_ == Part::hub; }
  [[nodiscard]] const Part& program() const { return part_; }
  [[nodiscard]] bool runs(std::size_t node) const {
    return !left_out(node) && runs_here(*plan_.graph, part_, node);
  }
  [[nodiscard]] bool receives(std::size_t node) const {
    return !left_out(node) && receives_here(*plan_.graph, part_, node);
  }
  [[nodiscard]] bool has_packs() const { return numbers == Numbers::packs; }
  /// Whether packs run a node one lane after the other; what it is then compiled for, of the
  /// environment's own program.
  [[nodiscard]] bool by_lane(std::size_t node) const {
    return has_packs() && runs_lane_by_lane(plan_.graph->nodes[node]);
  }
  [[nodiscard]] const CppClass& class_of(const Entity& entity) const {
    return has_packs() && entity.cpp_of_packs ? *entity.cpp_of_packs : entity.cpp;
  }
  [[nodiscard]] std::string one(std::size_t node) const { return in_own_program(io[node]); }
  /// A type as the environment's own program has it.
  [[nodiscard]] std::string in_own_program(const std::string& type) const {
    return "graphs::" + plan_.graph->name + "::" + type;
  }
  [[nodiscard]] std::string message(const Space& space) const {
    return message_type(space, numbers);
  }
  /// What engines and nodes calculate in.
  [[nodiscard]] std::string real() const {
    return std::string(
        element_type(plan_.graph->double_precision ? Dtype::float64 : Dtype::float32, numbers));
  }
  /// The number of the message that a node sends next.
  [[nodiscard]] std::string seq_of(std::size_t node) const {
    return sent[node].empty() ? counter[plan_.nodes[node].rate] + " - 1" : sent[node] + ".count()";
  }
  [[nodiscard]] bool has_io(std::size_t node) const;
  [[nodiscard]] bool has_engine() const {
    return plan_.graph->has_engine() && runs(Graph::kEngine);
  }
  [[nodiscard]] bool has_ring(std::size_t ring) const;
  /// What this program does with an output at its links; whether it does anything.
  [[nodiscard]] LinkUse links(std::size_t node, std::size_t output) const;
  [[nodiscard]] bool crosses(std::size_t node, std::size_t output) const;
  /// Whether this program is a hub that asks for the messages of a node before it needs them, and
  /// for those of any node.
  [[nodiscard]] bool posts(std::size_t node) const;
  [[nodiscard]] bool posts() const;
  /// How many ticks later than `node` sends them its messages come into this program, the first
  /// aside.
  [[nodiscard]] std::uint64_t lag(std::size_t node) const {
    return part_.is_placed() ? plan_.split->links[part_.index()].lags[node] : 0;
  }
  /// How many of the nodes before this one it asks for: the node's place in `taken_`.
  [[nodiscard]] std::size_t place_in_taken(std::size_t node) const;
  /// `count` messages of a node, once so many are there where they may be on their way.
  [[nodiscard]] std::string awaited(std::size_t node, const std::string& count) const;
  /// Which link, before the arguments of its functions: "part::kVision, "; empty where there is
  /// one.
  [[nodiscard]] std::string link_argument(std::size_t part) const;

 private:
  /// Packs show no pictures.
  [[nodiscard]] bool left_out(std::size_t node) const {
    return has_packs() && plan_.graph->nodes[node].drawn;
  }

  const Plan& plan_;
  Part part_;
};

/// Whether only pictures need what is in a ring; the names of its member and of its node's then
/// begin with that of the member that has all of it.
bool is_drawn(const Plan& plan, const Ring& ring);

/// packs/draws.hpp: what several episodes begin with.
View draws_view(const Plan& plan, const ProgramNames& names);

/// What the templates of one program are rendered with.
View messages_view(const Plan& plan, const ProgramNames& names);
/// Where headers are: those below `builtin_root` in angle brackets, others relative to `here`.
struct IncludePaths {
  std::string builtin_root, here;
};
View includes_view(const Plan& plan, const ProgramNames& names, const IncludePaths& paths);
View io_view(const Plan& plan, const ProgramNames& names, const IncludePaths& paths);
/// Whether this program has the guard of a graph without engine. It is where the main loop is; the
/// half of a split graph that a board runs has none.
bool guards_outputs(const Plan& plan, const ProgramNames& names);
/// Spaces and `safety:`.
View limits_view(const Plan& plan, const ProgramNames& names);
/// The header of a library: what a main loop of one's own needs to know.
View library_view(const Plan& plan, bool has_policy, bool has_memory);
/// Of the main loops of packages, and of the two functions that their users write.
View loop_view(const Plan& plan, bool has_policy, bool has_memory);
/// The class of the graph's task, and what other files say of its outputs: false without one.
View task_view(const Plan& plan);
View outcome_view(const Plan& plan, const ProgramNames& names);
/// `stages:` of the task: false without them.
View stages_view(const Plan& plan, const ProgramNames& names);
/// `telemetry:` in graph.hpp and in telemetry.json: false without it.
View telemetry_view(const Plan& plan);
View program_view(const Plan& plan, const ProgramNames& names);
/// What of the rendered program.hpp belongs to which node.
ProgramMap program_map(const Plan& plan, const ProgramNames& names, const MarkedText& program);
View graph_view(const Plan& plan, const ProgramNames& names, const std::optional<Network>& network,
                const std::vector<NodePolicy>& node_policies);

/// A space of limits.hpp or graph.hpp: "field", "type", "constant" (its name, "k" and `prefix`
/// before the field's), "literal".
View space_view(const std::string& field, const Space& space, const std::string& prefix,
                Names& constants);

}  // namespace eagerx::gen

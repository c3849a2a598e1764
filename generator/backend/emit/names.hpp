// The C++ names of everything in a plan, given once and used by every template.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/backend/emit/literals.hpp"
#include "generator/backend/emit/marks.hpp"
#include "generator/backend/emit/namer.hpp"
#include "generator/backend/emit/program_parts.hpp"
#include "generator/backend/emit/render.hpp"
#include "generator/backend/emit/repeats.hpp"
#include "generator/backend/emit/shared_io.hpp"
#include "generator/graph/plan/plan.hpp"
#include "generator/graph/plan/split.hpp"
#include "generator/graph/plan/vectorized.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/policy/agent/use.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

struct ProgramNames {
  /// `loops`: equal chains of nodes are loops over arrays; vectorized programs have none.
  ProgramNames(const Plan& plan, Part part, Numbers of = Numbers::plain, bool loops = false);

  Numbers numbers;

  std::vector<EmitRate> rates;      // by rate of the plan
  std::vector<EmitNode> nodes;      // by node of the graph
  std::vector<EmitMember> rings;    // by ring of the plan
  std::vector<EmitObject> objects;  // by object of the graph
  std::vector<std::string> parts;   // constants, by part: "kVision"
  std::map<std::string, std::vector<std::string>> processor_stages;  // types in one of these

  /// Equal chains of nodes. Their members and rings are elements of arrays: "servo_[3]".
  struct Loop {
    Repeat repeat;
    std::vector<std::string> labels;                 // tables of nodes' names, by node of a chain
    std::vector<std::vector<std::string>> channels;  // expressions, by node of a chain and output
    std::vector<std::pair<std::string, std::vector<std::string>>> tables;  // of channels
  };
  std::vector<Loop> loops;
  /// As the body of a loop calls everything: "servo_[i]".
  [[nodiscard]] ProgramNames inside(const Loop& loop) const;
  /// The contents of this program of a split graph; of a whole one, everything.
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
  [[nodiscard]] bool is_vectorized() const { return numbers == Numbers::simd; }
  [[nodiscard]] bool has_derivatives() const { return numbers == Numbers::dual; }
  /// Whether the vectorized program runs a node one lane after the other, compiled for the
  /// environment's own program.
  [[nodiscard]] bool by_lane(std::size_t node) const {
    return is_vectorized() && runs_lane_by_lane(plan_.graph->nodes[node]);
  }
  [[nodiscard]] const CppClass& class_of(const Entity& entity) const {
    return is_vectorized() && entity.vectorized_cpp ? *entity.vectorized_cpp : entity.cpp;
  }
  [[nodiscard]] std::string one(std::size_t node) const { return in_own_program(nodes[node].io); }
  /// A type as the environment's own program has it.
  [[nodiscard]] std::string in_own_program(const std::string& type) const {
    return "graphs::" + plan_.graph->name + "::" + type;
  }
  [[nodiscard]] std::string message(const Space& space) const {
    return message_type(space, numbers);
  }
  /// The number type of engines and nodes.
  [[nodiscard]] std::string real() const {
    return std::string(
        element_type(plan_.graph->double_precision ? Dtype::float64 : Dtype::float32, numbers));
  }
  /// The number of the message that a node sends next.
  [[nodiscard]] std::string seq_of(std::size_t node) const {
    const std::string& sent = nodes[node].sent;
    return sent.empty() ? rates[plan_.nodes[node].rate].counter + " - 1" : sent + ".count()";
  }
  [[nodiscard]] bool has_io(std::size_t node) const;
  [[nodiscard]] bool has_engine() const {
    return plan_.graph->has_engine() && runs(Graph::kEngine);
  }
  [[nodiscard]] bool has_ring(std::size_t ring) const;
  /// This program's use of an output at its links; false if there is none.
  [[nodiscard]] LinkUse links(std::size_t node, std::size_t output) const;
  [[nodiscard]] bool crosses(std::size_t node, std::size_t output) const;
  /// Whether this program is a hub that requests the messages of a node, or of any node, before it
  /// needs them.
  [[nodiscard]] bool is_pipelined(std::size_t node) const;
  [[nodiscard]] bool is_pipelined() const;
  /// How many ticks later than `node` sends them its messages come into this program, the first
  /// aside.
  [[nodiscard]] std::uint64_t lag(std::size_t node) const {
    return part_.is_placed() ? plan_.split->links[part_.index()].lags[node] : 0;
  }
  /// The node's place in `taken_`: the number of such nodes before it.
  [[nodiscard]] std::size_t place_in_taken(std::size_t node) const;
  /// An expression for `count` that waits until this number of a node's messages has arrived, if
  /// they may be in flight.
  [[nodiscard]] std::string awaited(std::size_t node, const std::string& count) const;
  /// Which link, before the arguments of its functions: "part::kVision, "; empty where there is
  /// one.
  [[nodiscard]] std::string link_argument(std::size_t part) const;

 private:
  void name_rates(Names& members);
  void name_parts();
  void name_nodes(Names& members, Names& types);
  void name_rings(Names& members);
  void name_objects(Names& members, Names& types, Names& fields);
  void name_ports(Names& members, Names& types, Names& fields);
  void name_input(std::size_t node, std::size_t input, const std::string& owner, Names& members,
                  Names& fields);
  void name_channels();
  void name_loops(Names& members);
  void name_loop(const Repeat& repeat, Names& members, Names& tables);
  /// The type of a processor and those of its stages; empty without one.
  std::string processor_type(const std::optional<Processor>& processor, const std::string& wanted,
                             Names& types);
  /// Vectorized programs, and those of derivatives, show no pictures.
  [[nodiscard]] bool left_out(std::size_t node) const {
    return numbers != Numbers::plain && plan_.graph->nodes[node].drawn;
  }

  const Plan& plan_;
  Part part_;
};

/// Whether only pictures need the messages of a ring. The names of its member and its node's member
/// then begin with that of the member that contains them.
bool is_drawn(const Plan& plan, const Ring& ring);

/// vectorized/sampler.hpp: initial states of several episodes.
View sampler_view(const Plan& plan, const ProgramNames& names);

/// The view of the templates of one program.
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
/// The header of a library: facts for your own main loop.
View library_view(const Plan& plan, bool has_policy, bool has_memory);
/// Of the main loops of packages, and of the two functions that their users write.
View loop_view(const Plan& plan, bool has_policy, bool has_memory);
/// The class of the graph's task, and references to its outputs in other files; false without a
/// task.
View task_view(const Plan& plan);
View outcome_view(const Plan& plan, const ProgramNames& names);
/// `stages:` of the task: false without them.
View stages_view(const Plan& plan, const ProgramNames& names);
/// `telemetry:` in graph.hpp and in telemetry.json: false without it.
View telemetry_view(const Plan& plan);
View program_view(const Plan& plan, const ProgramNames& names);
/// The ranges of the rendered program.hpp, by node.
ProgramMap program_map(const Plan& plan, const ProgramNames& names, const MarkedText& program);
View graph_view(const Plan& plan, const ProgramNames& names, const std::optional<Network>& network,
                const std::vector<NodePolicy>& node_policies);

/// A space of limits.hpp or graph.hpp: "field", "type", "constant" (its name, "k" and `prefix`
/// before the field's), "literal".
View space_view(const std::string& field, const Space& space, const std::string& prefix,
                Names& constants);

}  // namespace eagerx::gen

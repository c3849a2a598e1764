// What `eagerx-gen design` does with a graph, whatever it designs: builds its program, asks it what
// a node sees and how stable its loops are, with the gains that the graph has and with new ones.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/linear/design_report.hpp"

namespace eagerx::gen {

struct DesignOptions : LinearOptions {
  std::string of, open;
  bool json = false, write = false;
};

class DesignRun {
 public:
  explicit DesignRun(DesignOptions options) : options_(std::move(options)) {}

  /// Reads the graph; false with a problem: what cannot be linearized, and E0522 for a node that is
  /// none, or is not of one of these types.
  bool begin(std::initializer_list<const char*> types);
  /// Where the loop is opened: `--open`, or every element of a channel. False with E0520.
  bool open_at(std::optional<std::size_t> channel);

  /// Builds the program if it is needed, for plant() or margins, and finds the margins before.
  /// False with a problem.
  bool build(bool for_plant = true);
  /// What happens from each tick of the node to the next, with what `cut` carries as the input;
  /// `seen`: further channels. Nothing with a problem.
  std::optional<std::string> plant(std::optional<std::size_t> cut,
                                   const std::vector<std::size_t>& seen);
  /// The margins with these parameters, in `report`; E0522 where a loop is unstable with them.
  bool verify(DesignReport& report);
  /// Prints the report, writes the graph where that is asked for, and prints problems. The exit
  /// code.
  int end(const DesignReport& report);
  /// The same with a problem: E0522 unless it is empty.
  int refuse(const std::string& problem = {}, const std::string& help = {});

  [[nodiscard]] const Plan& plan() const { return *run_.plan; }
  [[nodiscard]] const GraphNode& node() const { return run_.graph->nodes[node_]; }
  [[nodiscard]] std::size_t index() const { return node_; }
  [[nodiscard]] Diagnostics& diagnostics() { return run_.diagnostics; }
  /// Its input; nullptr without a connection.
  [[nodiscard]] const Input* input(std::string_view name) const;
  /// The unit and the number of elements of what an input receives.
  [[nodiscard]] std::string unit(std::size_t channel) const;
  /// The channel of what an input receives, and of what the node sends.
  [[nodiscard]] std::size_t channel(const Input& input) const;
  [[nodiscard]] std::size_t sent() const;
  /// Whether `name` is what a graph calls an input of the node, or its output.
  [[nodiscard]] bool is_input(const std::string& name, const Input& input) const;
  [[nodiscard]] bool is_sent(const std::string& name) const;
  /// With its name, type and rate.
  [[nodiscard]] DesignReport report(const char* method) const;

 private:
  std::vector<std::string> words() const;
  std::optional<std::string> print(const std::vector<std::string>& words);
  std::optional<Margins> margins(const PortElement& at);
  std::string help_for_unstable() const;

  DesignOptions options_;
  Run run_;
  std::size_t node_ = 0;
  std::vector<PortElement> opened_;
  std::vector<Margins> before_;
  std::string image_;
  int code_ = kDone;
};

}  // namespace eagerx::gen

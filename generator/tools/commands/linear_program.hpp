// The program of target linearize: the ports and states that its command line names, its build, and
// what it prints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/driver/build/built.hpp"
#include "generator/tools/linear/hyperperiod.hpp"

namespace eagerx::gen {

/// Options of all commands that start it.
struct LinearOptions : GenerateOptions {
  std::vector<std::string> at;  // NAME=VALUE,…
  std::optional<std::uint64_t> steps, seed;
};

/// Reads and checks the graph; false with a problem, E0520 for what cannot be linearized.
bool make_linear_graph(Run& run, LinearOptions& options);

/// A name of what a channel carries.
struct NamedChannel {
  std::string name;
  std::size_t channel;
};
/// All ports that send, and then those that receive, which stand for what they get.
std::vector<NamedChannel> port_names(const Plan& plan);
/// The channel of what a node sends.
std::size_t channel_at(const Plan& plan, std::size_t node, std::size_t output);
/// The channel of a port whose messages have derivatives; nothing with E0520. `about`: what it is
/// for, as the command line says it.
std::optional<std::size_t> channel_of(const std::string& port, const std::string& about,
                                      const Plan& plan, Diagnostics& diagnostics);
/// Its space.
const Space& space_of(const Plan& plan, std::size_t channel);

/// A port with or without the index of an element: "motor.y[2]".
struct PortElement {
  std::size_t channel = 0;
  std::uint64_t element = 0;
};
/// Where a loop is opened: "motor.y[2]" or, of a message of one number, "motor.u"; nothing with a
/// problem.
std::optional<PortElement> opened_port(const std::string& text, const Plan& plan,
                                       Diagnostics& diagnostics);

/// A state that a reset sets, "pendulum.model_state".
struct NamedState {
  std::string name;
  std::uint64_t size = 1;
};
std::vector<NamedState> states_of(const Graph& graph);
/// Checks NAME=VALUE,… of a state: E0520, as a wrong command line.
void check_state(const std::string& text, const Graph& graph, Diagnostics& diagnostics);

/// `--steps N --seed N`, and nodes whose own numbers, such as a covariance, are those to which they
/// settle: all that `settles`, unless the command line chooses the steps.
std::vector<std::string> first_words(const LinearOptions& options, const Plan& plan, bool settles);
inline std::vector<std::string> first_words(const LinearOptions& options, const Plan& plan) {
  return first_words(options, plan, !options.steps);
}

/// Builds it for a graph that was made; the file of the program. Nothing with a problem; then
/// `code` is the least that the exit code may be.
std::optional<std::string> build_linear_program(Run& run, const LinearOptions& options, int& code);
/// What it prints with these words; nothing where it fails, with its messages in `failure`.
std::optional<std::string> printed_by(const std::string& image,
                                      const std::vector<std::string>& words, std::string& failure,
                                      int& code);
/// The same, read: nothing where it fails or prints none, which has been reported; then `code` is
/// the least that the exit code may be.
std::optional<SampledSystem> system_of(Run& run, const std::string& image,
                                       const std::vector<std::string>& words, int& code);
std::optional<Hyperperiod> hyperperiod_of(Run& run, const std::string& image,
                                          const std::vector<std::string>& words, int& code);

}  // namespace eagerx::gen

// Builds the programs of a graph.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/driver/build/build_tree.hpp"
#include "generator/driver/build/packages.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Where a graph was generated, and for what.
struct Generated {
  std::string folder;
  std::vector<const Target*> targets;  // of a placed graph those of the hub
  std::vector<Package> packages;
  std::size_t written = 0, unchanged = 0, kept = 0;
  std::optional<std::uint64_t> graph_hash;  // that its programs say
};

/// Reads, checks and writes the graph of `options`. From then on until this process ends, or
/// executes the built program, no other eagerx-gen writes or builds there. nullopt after a problem,
/// which is in `run`; `code` is then the minimum exit code.
std::optional<Generated> generate_graph(Run& run, const GenerateOptions& options, int& code);

/// A program's description for its observers.
struct ProgramFacts {
  std::uint64_t hash = 0;  // of the graph
  std::string telemetry;   // the text of telemetry.json; empty: it sends none
};
/// Of the program of a graph that was made, or of all of a placed one. Nothing if there is a
/// problem, which is in `run`.
std::optional<ProgramFacts> facts_of_program(Run& run, const GraphOptions& options);

/// Compiles the classes of the graph's entities with this machine's compiler under the rules of
/// boards: the whole program, also for a split graph. Adds problems to `diagnostics`
/// (check_entities()).
void compile_entities(Run& run, const std::vector<const Target*>& targets,
                      Diagnostics& diagnostics);

/// build_tree() of a graph's program for `target`. Reports build errors in the class of an entity
/// at their place in that entity, like compile_entities().
bool build_program(Run& run, const Tree& tree, const Target& target, const std::string& name,
                   bool quiet, const std::string& cmake_target = {});

/// The program of a target, built.
struct BuiltProgram {
  const Target* target = nullptr;
  std::string build;                 // its build folder
  std::string image;                 // its file
  const PlacedPart* part = nullptr;  // of a placed graph: which part; without one, the hub
  std::optional<std::uint64_t> graph_hash = {};  // that it says, if it was built from this graph
};

/// make(), and build_made_graph(). Nothing if there is a problem, which is in `run`.
std::optional<std::vector<BuiltProgram>> build_graph(Run& run, GenerateOptions options, int& code,
                                                     std::vector<std::string>* to_run = nullptr);

/// generate_graph(), in a separate folder for each target that is not this machine, and
/// build_tree() of every program, for a graph that make() has read. For a placed graph, the parts
/// come first. `to_run`: the options of the last program, if it will be run; E0515 if nothing here
/// can run it, E0516 for an option that it does not have. The remaining options are passed to it.
std::optional<std::vector<BuiltProgram>> build_made_graph(
    Run& run, GenerateOptions options, int& code, std::vector<std::string>* to_run = nullptr);

/// The command that starts a program, without its options; nothing if nothing here can (its
/// target's manifest has no `run:`).
std::vector<std::string> command_to_start(const Run& run, const BuiltProgram& program);

/// Whether a target has something to compile: in another language than C++, if it makes a project
/// of CMake.
bool is_compiled(const Target& target);

/// Programs started from now on refuse to run if one was built from another graph.
void expect_graph(const BuiltProgram& program);

/// Executes the program, or the command that starts it; `words` are the program's own options.
int exec_built(const Run& run, const BuiltProgram& program, const std::vector<std::string>& words);

/// The file of a target's program in a build folder.
std::string image_of(const Run& run, const Target& target, const std::string& build);

}  // namespace eagerx::gen

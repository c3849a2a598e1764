// Turns a plan into files. Nothing here depends on YAML.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/policy/agent/use.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// One generated file; the path is relative to the output folder.
struct GeneratedFile {
  std::string path;
  std::string text;
  bool yours = false;  // written once: what is there then is the user's
};

/// A template in addition to those of the program.
struct ExtraTemplate {
  std::string output;  // path in the output
  std::string path;    // of the template
  bool yours = false;  // as GeneratedFile::yours
};

struct EmitOptions {
  std::string templates;               // folder of the templates
  std::vector<const Target*> targets;  // the first is the default; without any, a library
  std::string version;                 // of the generator
  std::string builtin_root;            // headers below it are included as <models/…>
  std::string output;                  // others are included relative to the output folder
  std::string header_folder;           // of the graph's headers in it: empty, or such as `src/`
  std::vector<ExtraTemplate> extra;    // of packages
  bool cmake = true;                   // with a CMakeLists.txt and program.map
  bool tables_as_text = false;         // also those of large policies, for any compiler
  Part part = Part::whole;             // of a placed graph: which of its programs
  std::uint64_t graph_hash = 0;        // of a placed graph: what its programs tell each other;
                                       // otherwise 0, and it is made of this program's headers
};

/// A hash of all headers, for EmitOptions::graph_hash. It excludes additions of targets, because a
/// part sends the same messages in every language and on every machine, and the paths of the
/// graph's own headers, which depend on the output's path.
std::uint64_t hash_of(const std::vector<GeneratedFile>& files);

/// The kGraphHash of an emitted program. Nothing if it says none.
std::optional<std::uint64_t> hash_in(const std::vector<GeneratedFile>& files);

/// A class of an entity that the program uses.
struct UsedClass {
  std::string header;  // its path
  std::string name;    // with namespaces
  std::string system;  // the operating system that its entity needs; empty: none
  Span span;           // of the name in the manifest
};
/// Each once, in the order of the plan; without those that are generated along with the program.
std::vector<UsedClass> used_classes(const Plan& plan);

/// `here`: the folder that will include them, if it is known. Problems: E0301 a header that a
/// manifest names and that is not there, or whose path C++ cannot write.
void check_headers(const Plan& plan, const std::string& here, Diagnostics& diagnostics);

/// Makes all files of a program. `network` is set if the agent is a policy. Problems: E0501 a
/// template that cannot be read or is wrong.
std::optional<std::vector<GeneratedFile>> emit(const Plan& plan,
                                               const std::optional<Network>& network,
                                               const std::vector<NodePolicy>& node_policies,
                                               const EmitOptions& options,
                                               Diagnostics& diagnostics);

}  // namespace eagerx::gen

// Packages for other build systems: what `--package NAME` adds to an output, and where it goes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// A folder of templates/packages, as its package.yaml describes it.
struct Package {
  std::string name;
  std::string folder;   // of its templates
  std::string headers;  // where the graph's headers go with --library: "src"
  // Places in the output of templates that several packages have in common.
  std::map<std::string, std::string> library;  // with --library: the main loop
  std::map<std::string, std::string> program;  // without it: an episode
  std::map<std::string, std::string> yours;    // with --library: written once, then the user's
  std::vector<std::string> taken;              // names that a graph cannot have
};

/// Those there are, by name.
std::vector<std::string> names_of_packages(const Run& run);

/// The packages that the command line names. Problems: E0502 an unknown package, E02xx errors in
/// its package.yaml.
std::vector<Package> read_packages(Run& run, const GenerateOptions& options);

/// Whether the graph's name is free there: E0504.
void check_names(Run& run, const std::vector<Package>& packages);

/// Whether the output has all headers that it needs.
bool is_standalone(const GenerateOptions& options);
/// Whether the output is only these packages: with --library, and without --standalone.
bool is_bare(const GenerateOptions& options);

/// Refuses graphs that cannot be a package's main loop: E0503 an engine, E0330 a node that needs an
/// operating system.
void check_for_packages(Run& run, const GenerateOptions& options);

/// Their templates.
std::vector<ExtraTemplate> templates_of(const Run& run, const GenerateOptions& options,
                                        const std::vector<Package>& packages);

/// With --library, puts the graph's headers into their place in each package, and nowhere else if
/// the output consists of packages only. `others`: the templates of packages, whose files are in
/// place already.
void place_headers(const Run& run, const GenerateOptions& options,
                   const std::vector<Package>& packages, const std::vector<ExtraTemplate>& others,
                   std::vector<GeneratedFile>& files);

/// The next commands, for each package: its next.library.sh or next.program.sh.
std::string next_steps(Run& run, const GenerateOptions& options,
                       const std::vector<Package>& packages, const std::string& folder);

}  // namespace eagerx::gen

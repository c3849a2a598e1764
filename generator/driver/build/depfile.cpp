#include "generator/driver/build/depfile.hpp"

#include <algorithm>
#include <filesystem>

#include "generator/driver/build/write.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Everything that the output was made from, in the form that make and ninja read.
std::string depfile_text(const Run& run, const GenerateOptions& options) {
  const auto escaped = [](const std::string& path) {
    return make_path(absolute_path(path).lexically_normal().string());
  };
  const std::string target = options.depfile.ends_with(".d")
                                 ? options.depfile.substr(0, options.depfile.size() - 2)
                                 : options.depfile;
  std::vector<std::string> inputs = {options.graph};
  for (const auto& [id, entity] : run.library.entities) inputs.push_back(entity.path);
  inputs.insert(inputs.end(), run.tables.begin(), run.tables.end());
  if (run.policies.agent) inputs.push_back(run.graph->agent.path);
  for (const auto& file : run.graph->agent.other_files) inputs.push_back(file);
  const fs::path folder = fs::path(run.spec->path).parent_path();
  for (const auto& node : run.spec->nodes) {
    if (!node.policy) continue;
    for (const auto& file : {node.policy->normalize, node.policy->golden})
      if (file) inputs.push_back((folder / file->value).string());
  }
  std::error_code ignored;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(run.root) / "templates", ignored)) {
    if (entry.is_regular_file(ignored)) inputs.push_back(entry.path().string());
  }
  for (const auto& [id, item] : run.library.targets) {
    for (const auto& [file, output] : item.templates) inputs.push_back(file);
    for (const auto& [file, output] : item.partner) inputs.push_back(file);
    for (const auto& [file, output] : item.yours) inputs.push_back(file);
  }
  std::sort(inputs.begin() + 1, inputs.end());
  std::string text = escaped(target) + ":";
  for (const auto& input : inputs) {
    if (is_make_path(input)) text += " \\\n  " + escaped(input);
  }
  return text + "\n";
}

}  // namespace

bool write_depfile(Run& run, const GenerateOptions& options) {
  return options.depfile.empty() ||
         write_file(options.depfile, depfile_text(run, options), run.diagnostics);
}

}  // namespace eagerx::gen

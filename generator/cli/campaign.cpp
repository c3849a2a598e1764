// eagerx-gen campaign: many runs are the work of eagerx-campaign (targets/environments/campaign).
#include <algorithm>
#include <string_view>

#include "generator/cli/commands.hpp"
#include "generator/cli/environments.hpp"

namespace eagerx::gen {
namespace {

/// As a shell reads it back.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+:,=@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// What runs one episode of the same graph in its program for Linux.
std::string command_of_one_run(const Options& options) {
  std::string text = "eagerx-gen run " + quoted(options.graph);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + name + " " + quoted(value);
  };
  add("--policy", options.agent_policy);
  add("--engine", options.engine);
  add("--rate", options.rate_hz ? options.rate_hz->to_string() : "");
  add("--engine-rate", options.engine_rate_hz ? options.engine_rate_hz->to_string() : "");
  for (const std::string& path : options.paths) add("--path", path);
  return text;
}

}  // namespace

int campaign_command(const Options& options) {
  Options campaign = options;
  campaign.purpose = Purpose::campaign;
  std::vector<std::string> words = options.program_options;
  if (options.json_output) words.emplace_back("--json");
  words.insert(words.end(), {"--replay", command_of_one_run(options)});
  return become_with_environments("eagerx-campaign", campaign, std::move(words));
}

}  // namespace eagerx::gen

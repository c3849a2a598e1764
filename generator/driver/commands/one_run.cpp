#include "generator/driver/commands/one_run.hpp"

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

std::string command_on_graph(const GraphOptions& options, const char* command) {
  std::string text = std::string("eagerx-gen ") + command + " " + shell_word(options.graph);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + name + " " + shell_word(value);
  };
  add("--policy", options.agent_policy);
  add("--variant", options.variant);
  add("--engine", options.engine);
  add("--rate", options.rate_hz ? options.rate_hz->to_string() : "");
  add("--engine-rate", options.engine_rate_hz ? options.engine_rate_hz->to_string() : "");
  for (const std::string& path : options.paths) add("--path", path);
  return text;
}

}  // namespace eagerx::gen

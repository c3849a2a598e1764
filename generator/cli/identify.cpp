// eagerx-gen identify: what a log says of parameters and delays. Only the program can repeat the
// log, so the work is its own: runtime/host/identify, which it links.
#include "generator/cli/become.hpp"
#include "generator/cli/commands.hpp"

namespace eagerx::gen {

int identify_command(const Options& options) {
  std::vector<std::string> arguments = {"--identify", options.log};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {name, value});
  };
  add("--identify-out", options.output);
  add("--identify-sensors", options.sensors);
  add("--identify-horizon", options.horizon_s);
  add("--identify-delay", options.longest_delay_s);
  return become(options.program, arguments);
}

}  // namespace eagerx::gen

#include <algorithm>
#include <runtime/host/base/nearest.hpp>
#include <targets/linux-sim/channel_names.hpp>
#include <targets/linux-sim/say.hpp>

namespace eagerx::linux_sim {
namespace {

/// Words of `--replay-given` that are no channels.
bool is_word(std::string_view name) {
  return name == "actions" || name == "sensors" || name == "none";
}

std::string named(const std::string& written, const std::vector<std::string>& channels) {
  const std::string* const meant = host::name_meant(written, channels);
  if (meant == nullptr || *meant == written) return written;
  say_other_spelling(written, *meant);
  return *meant;
}

/// Of a list separated by commas.
std::string all_named(std::string_view list, const std::vector<std::string>& channels) {
  std::string result;
  while (!list.empty()) {
    const std::string word(list.substr(0, list.find(',')));
    list.remove_prefix(std::min(word.size() + 1, list.size()));
    if (!result.empty()) result += ",";
    result += is_word(word) ? word : named(word, channels);
  }
  return result;
}

}  // namespace

Options with_channels_named(Options options, const GraphFacts& facts) {
  std::vector<std::string> channels;
  for (std::size_t i = 0; i < facts.channel_count; ++i)
    channels.emplace_back(facts.channels[i].name);
  options.replay_given = all_named(options.replay_given, channels);
  options.identify_sensors = all_named(options.identify_sensors, channels);
  for (std::string& each : options.publish_only) each = named(each, channels);
  return options;
}

}  // namespace eagerx::linux_sim

#include <algorithm>
#include <targets/linux-sim/channel_names.hpp>
#include <targets/linux-sim/say.hpp>

namespace eagerx::linux_sim {
namespace {

/// Words of `--replay-given` that are no channels.
bool is_word(std::string_view name) {
  return name == "actions" || name == "sensors" || name == "none";
}

std::vector<host::Named> names_of(const GraphFacts& facts) {
  std::vector<host::Named> known;
  for (std::size_t i = 0; i < facts.channel_count; ++i) {
    const std::string name = facts.channels[i].name;
    known.push_back({name, name});
    for (const std::string& port : ports_of(facts.channels[i])) known.push_back({port, name});
    for (const std::string& alias : aliases_of(facts, i)) known.push_back({alias, name});
    const std::string port = name.substr(0, name.rfind('/'));
    known.push_back({port, name, false});
    known.push_back({port.substr(port.rfind('/') + 1), name, false});
  }
  return known;
}

/// Writes a name as traces spell it.
std::string spell(std::string& name, const std::vector<host::Named>& known) {
  const std::string* const meant = host::name_meant(name, known);
  if (meant == nullptr) {
    return "error: this program has no channel `" + name +
           "`\nhelp: " + host::suggestion(name, known);
  }
  if (*meant != name) say_other_spelling(name, *meant);
  name = *meant;
  return {};
}

/// Of a list separated by commas.
std::string spell_all(std::string& list, const std::vector<host::Named>& known) {
  std::string result, problem;
  for (std::string_view rest = list; !rest.empty() && problem.empty();) {
    std::string word(rest.substr(0, rest.find(',')));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    if (!is_word(word)) problem = spell(word, known);
    result += (result.empty() ? "" : ",") + word;
  }
  list = result;
  return problem;
}

}  // namespace

std::vector<std::string> ports_of(const Channel& channel) {
  constexpr std::string_view kBetween = ", ";
  std::string_view port = channel.port;
  std::vector<std::string> names;
  for (std::size_t end = 0; (end = port.find(kBetween)) != std::string_view::npos;
       port.remove_prefix(end + kBetween.size()))
    names.emplace_back(port.substr(0, end));
  names.emplace_back(port);
  return names;
}

std::vector<std::string> aliases_of(const GraphFacts& facts, std::size_t channel) {
  std::vector<std::string> aliases;
  for (std::size_t i = 0; i < facts.alias_count; ++i)
    if (facts.aliases[i].channel == channel) aliases.emplace_back(facts.aliases[i].port);
  return aliases;
}

std::string name_channels(Options& options, const GraphFacts& facts) {
  const std::vector<host::Named> known = names_of(facts);
  std::string problem = spell_all(options.replay_given, known);
  if (problem.empty()) problem = spell_all(options.identify_sensors, known);
  for (std::string& each : options.publish_only)
    if (problem.empty()) problem = spell(each, known);
  return problem;
}

}  // namespace eagerx::linux_sim

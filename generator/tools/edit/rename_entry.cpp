// Names of actions and observations, wherever a graph has them.
#include <fmt/format.h>

#include <utility>

#include "generator/tools/edit/changes.hpp"

namespace eagerx::gen {
namespace {

/// The places that name an action or an observation: `actions.voltage`, and the name alone where
/// only such can stand.
class AgentUses {
 public:
  AgentUses(std::string_view text, std::string section, std::string name)
      : text_(text), section_(std::move(section)), name_(std::move(name)) {}

  std::vector<Splice> replaced_by(const std::string& to) {
    graph(outline_of(text_));
    std::vector<Splice> splices;
    for (const Bytes& place : found_) splices.push_back({place, to});
    return splices;
  }

 private:
  void graph(const OutlineNode& top) {
    for (const OutlineEntry& section : top.entries) {
      if (section.key == section_) names_of(section.value);
      if (section.key == "variants") {
        for (const OutlineEntry& variant : section.value.entries) graph(variant.value);
      }
      if (section.key == "agent" && section_ == "observations")
        if (const OutlineNode* const order = section.value.find(section_)) names_of(*order);
      if (section.key == "safety") safety(section.value);
      if (section.key != "variants") ports_in(section.value);
    }
  }
  void safety(const OutlineNode& node) {
    for (const OutlineEntry& entry : node.entries) {
      const bool of_actions = entry.key == "actions" || entry.key == "frozen";
      const bool of_observations = entry.key == "outputs";
      if (section_ == "actions" ? of_actions : of_observations) names_of(entry.value);
    }
  }
  /// Keys, or items, that are the name.
  void names_of(const OutlineNode& node) {
    for (const OutlineEntry& entry : node.entries) {
      if (entry.key == name_) add(entry.key_place, 0);
      if (entry.key.empty() && entry.value.text == name_) add(entry.value.place, 0);
    }
  }
  /// `actions.name`, and what follows it.
  void ports_in(const OutlineNode& node) {
    if (node.kind == OutlineNode::Kind::scalar) port_at(node.place);
    for (const OutlineEntry& entry : node.entries) {
      if (!entry.key.empty()) port_at(entry.key_place);
      ports_in(entry.value);
    }
  }
  void port_at(Bytes place) {
    const std::string port = section_ + "." + name_;
    std::string_view scalar = text_.substr(place.begin, place.end - place.begin);
    const std::size_t quote = !scalar.empty() && (scalar[0] == '"' || scalar[0] == '\'') ? 1 : 0;
    scalar.remove_prefix(quote);
    if (!scalar.starts_with(port)) return;
    const std::string_view rest = scalar.substr(port.size());
    if (rest.empty() || std::string_view("[.\"'").find(rest[0]) != std::string_view::npos)
      add(place, section_.size() + 1);
  }
  void add(Bytes place, std::size_t skip) {
    const char first = text_[place.begin];
    const std::size_t begin = place.begin + (first == '"' || first == '\'' ? 1 : 0) + skip;
    found_.push_back({begin, begin + name_.size()});
  }

  std::string_view text_;
  std::string section_, name_;
  std::vector<Bytes> found_;
};

}  // namespace

Change rename_entry(std::string_view text, const OutlinePath& path, const std::string& name) {
  const std::string section = key_at(path, 0), from = key_at(path, 1);
  const bool is_entity = is_among(kEntitySections, section);
  if (path.size() != 2 || from.empty() || (!is_entity && !is_among(kAgentSections, section)))
    return refused(fmt::format("`{}` has no name that others use", shown(path)));
  const Written written(text);
  if (!has_name(written, section, from)) return refused(fmt::format("there is no `{}`", from));
  if (!is_name(name))
    return refused(fmt::format("`{}` is not a name", name),
                   "a name has letters, digits and `_`, and begins with no digit");
  if (is_taken(written, section, name))
    return refused(fmt::format("there is `{}` already", name), "choose another name");
  if (is_entity) {
    auto edit = rename(text, from, name);
    return edit ? Change{std::move(edit)}
                : refused(fmt::format("`{}` cannot be the name of an object or a node", name));
  }
  Edit edit{fmt::format("Rename `{}` to `{}`", from, name),
            AgentUses(text, section, from).replaced_by(name)};
  return {std::move(edit)};
}

}  // namespace eagerx::gen

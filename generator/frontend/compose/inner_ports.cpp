#include "generator/frontend/compose/inner_ports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::optional<std::vector<std::string>> InnerPorts::known(const PortName& name, bool sends) const {
  std::vector<std::string> known;
  if (const CompositePorts* ports = ends.find(name.owner)) {
    for (const auto& [port, source] : ports->sources)
      if (sends) known.push_back(port);
    for (const auto& [port, sinks] : ports->sinks)
      if (!sends) known.push_back(port);
    return known;
  }
  const auto found = entity_of.find(name.owner);
  if (found == entity_of.end()) return known;
  if (found->second == nullptr) return std::nullopt;
  const Entity& entity = *found->second;
  for (const auto* ports :
       {sends ? &entity.outputs : &entity.inputs, sends ? &entity.sensors : &entity.actuators})
    for (const auto& port : *ports) known.push_back(port.name.value);
  return known;
}

bool InnerPorts::is_there(const Spanned<std::string>& bound, const std::string& port, bool sends,
                          Diagnostics& diagnostics) const {
  const PortName name = parse_port(port);
  const auto known = this->known(name, sends);
  if (!known || contains(*known, name.name) || name.section == "targets" ||
      name.section == "feedthroughs")
    return true;
  auto& problem = diagnostics.error(
      "E0390", bound.span,
      fmt::format("there is no {} `{}` inside", sends ? "output" : "input", bound.value));
  const std::string near = nearest(name.name, *known);
  problem.help = near.empty() ? "a port of a composite is bound to `NAME.PORT` of its own graph"
                              : meaning(fmt::format("{}.{}", parse_port(bound.value).owner, near));
  return false;
}

bool InnerPorts::has_port(const Spanned<std::string>& written, const std::string& port, bool sends,
                          Diagnostics& diagnostics) const {
  const PortName name = parse_port(port);
  if (ends.find(name.owner) == nullptr) return true;
  const auto known = this->known(name, sends);
  if (contains(*known, name.name)) return true;
  if (sends && ends.find(name.owner)->broken.contains(name.name)) return false;
  auto& problem = diagnostics.error(
      "E0307", written.span,
      fmt::format("`{}` has no {} `{}`", name.owner, sends ? "output" : "input", name.name));
  std::string inside = port;  // `robot.body/v`: of what is in it
  std::ranges::replace(inside, '.', '/');
  if (const std::size_t end = inside.rfind('/'); end > name.owner.size()) {
    inside[end] = '.';
    problem.help = meaning(inside);
    return false;
  }
  const std::string near = nearest(name.name, *known);
  problem.help = near.empty() ? fmt::format("it has {}", join(*known, ", "))
                              : meaning(fmt::format("{}.{}", name.owner, near));
  return false;
}

void Feeds::add_connection(const YamlValue& connection) {
  const YamlValue* to = connection.find("to");
  if (to != nullptr) connected_.emplace(to->text, to->span);
}

void Feeds::bind(const std::string& port, const Spanned<std::string>& written,
                 Diagnostics& diagnostics) {
  const auto connection = connected_.find(port);
  const auto [first, is_new] = bound_.emplace(port, written.span);
  if (is_new && connection == connected_.end()) return;
  const bool twice = !is_new;
  auto& problem = diagnostics.error(
      "E0390", written.span,
      fmt::format("`{}` is bound {}", written.value, twice ? "twice" : "and connected inside"));
  problem.notes.push_back(twice ? Diagnostic::Note{"first here", first->second, ""}
                                : Diagnostic::Note{"connected here", connection->second, ""});
  problem.help = "an input takes one connection: add a node that puts two together, such as `Sum`";
}

}  // namespace eagerx::gen

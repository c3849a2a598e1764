#include "generator/graph/resolve/unknown_owners.hpp"

#include <fmt/format.h>

#include <runtime/host/base/nearest.hpp>
#include <utility>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::size_t elements_of(std::string_view array, const std::vector<std::string>& known) {
  const std::string begin = fmt::format("{}[", array);
  std::size_t count = 0;
  for (const std::string& name : known) count += name.starts_with(begin) ? 1 : 0;
  return count;
}

/// The object or the node that the graph file calls so; nullptr without one.
const EntitySpec* declaration(const GraphSpec& spec, std::string_view name) {
  const EntitySpec* object = find_named(spec.objects, name);
  return object != nullptr ? object : find_named(spec.nodes, name);
}

}  // namespace

std::string UnknownOwners::add(const PortName& port, Span span, std::vector<std::string> known) {
  const std::string written =
      port.owner + "." + (port.section.empty() ? "" : port.section + ".") + port.name;
  const auto [same, is_new] = index_of_.try_emplace(port.owner, unknown_.size());
  if (!is_new) {
    unknown_[same->second].places.push_back({port.name, span, written});
    return unknown_[same->second].near;
  }
  if (!helps()) known.clear();
  const std::size_t elements = elements_of(port.owner, known);
  std::string near = elements > 0 ? std::string() : nearest(port.owner, known);
  unknown_.push_back({port.owner, {{port.name, span, written}}, std::move(known), elements, near});
  return near;
}

void UnknownOwners::report() {
  for (const Unknown& each : unknown_) {
    const EntitySpec* declared = each.near.empty() ? nullptr : declaration(draft_.spec, each.near);
    if (each.places.size() > 1 && declared != nullptr && !is_used(each.near)) {
      report_declared(each, declared->name.span);
      continue;
    }
    for (const Place& place : each.places) report_used(each, place);
  }
}

std::string UnknownOwners::spelled(const Unknown& unknown, const Place& place) {
  const std::string& whole = place.written;
  for (std::size_t end = whole.size();
       (end = whole.find_last_of("./", end - 1)) != std::string::npos;) {
    const std::string* const owner = host::name_meant(whole.substr(0, end), unknown.known);
    if (owner != nullptr) return *owner + "." + whole.substr(end + 1);
    if (end == 0) break;
  }
  return {};
}

bool UnknownOwners::is_used(std::string_view owner) const {
  return ranges::any_of(draft_.spec.connections, [&](const ConnectionSpec& connection) {
    return parse_port(connection.from.value).owner == owner ||
           parse_port(connection.to.value).owner == owner;
  });
}

/// All who use the name agree on it, so it is the other one that is mistyped.
void UnknownOwners::report_declared(const Unknown& unknown, Span declared) {
  auto& problem = error(unknown, unknown.places.front());
  problem.label = fmt::format("here, and at {}", counted(unknown.places.size() - 1, "other place"));
  problem.notes.push_back({fmt::format("nothing uses `{}`", unknown.near), declared, ""});
  problem.help = fmt::format("did you mean to call that `{}`?", unknown.owner);
  draft_.erroneous.insert(unknown.owner);
}

void UnknownOwners::report_used(const Unknown& unknown, const Place& place) {
  auto& problem = error(unknown, place);
  if (++helped_ > kMostHelped) return;
  if (const std::string port = spelled(unknown, place); !port.empty()) {
    problem.help = write_instead(port);
  } else if (unknown.elements > 0) {
    problem.help = fmt::format(
        "`{0}` has {1}: write `\"{0}[*].{2}\"` for all of them, or `\"{0}[0].{2}\"` for one",
        unknown.owner, counted(unknown.elements, "element"), place.port);
  } else if (!unknown.near.empty()) {
    problem.help = meaning(fmt::format("{}.{}", unknown.near, place.port));
  } else if (!unknown.known.empty()) {
    problem.help = fmt::format("available: {}", join(unknown.known, ", "));
  }
}

Diagnostic& UnknownOwners::error(const Unknown& unknown, const Place& place) {
  return draft_.diagnostics.error(
      "E0309", place.span,
      fmt::format("there is nothing called `{}` in this graph", unknown.owner));
}

}  // namespace eagerx::gen

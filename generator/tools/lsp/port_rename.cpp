// Renames a port in its manifest, its header and all references.
#include <fmt/format.h>

#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/uri.hpp"
#include "generator/tools/edit/rename_port.hpp"
#include "generator/tools/lsp/convert.hpp"
#include "generator/tools/lsp/errors.hpp"
#include "generator/tools/lsp/server.hpp"

namespace eagerx::gen::lsp {
namespace {

std::vector<Splice> splices_of(const std::vector<Bytes>& places, const std::string& to) {
  std::vector<Splice> splices;
  splices.reserve(places.size());
  for (const Bytes& place : places) splices.push_back({place, to});
  return splices;
}

}  // namespace

std::optional<Server::PortToRename> Server::port_at(const Document& document, Position position) {
  const std::size_t at = byte_at(document.text, position);
  if (is_manifest(document.path)) {
    const auto port = port_in_manifest(document.text, at);
    if (!port || port->type.empty()) return std::nullopt;
    PortToRename found{port->type, port->port, document.path, {}, port->place};
    for (const auto& [uri, graph] : documents_) {
      const auto files = is_manifest(graph.path)
                             ? std::nullopt
                             : analyst_.files_of(graph.path, graph.text, port->type);
      if (files && files->manifest == document.path && files->is_own) found.header = files->header;
    }
    return found;
  }
  const auto port = port_in_graph(document.text, at);
  if (!port) return std::nullopt;
  const auto files = analyst_.files_of(document.path, document.text, port->type);
  if (!files || !files->is_own) return std::nullopt;
  return PortToRename{port->type, port->port, files->manifest, files->header, port->place};
}

std::vector<Server::Change> Server::changes_of(const PortToRename& port, const std::string& to) {
  std::vector<Change> changes;
  const auto add = [&](const std::string& path, const std::vector<Bytes>& places,
                       std::string text) {
    const bool is_known =
        ranges::any_of(changes, [&](const Change& each) { return each.path == path; });
    if (places.empty() || is_known) return;
    const auto open =
        ranges::find_if(documents_, [&](const auto& each) { return each.second.path == path; });
    changes.push_back({path, open != documents_.end() ? open->first : uri_of_path(path),
                       std::move(text), splices_of(places, to)});
  };
  const auto add_manifest = [&](const std::string& path) {
    if (auto text = analyst_.text_of(path))
      add(path, uses_of_port_in_manifest(*text, port.id, port.port), *text);
  };
  add_manifest(port.manifest);
  if (const auto header = port.header.empty() ? std::nullopt : analyst_.text_of(port.header))
    add(port.header, uses_of_port_in_header(*header, port.port), *header);
  for (const auto& [uri, document] : documents_) {
    if (is_manifest(document.path)) continue;
    const auto files = analyst_.files_of(document.path, document.text, port.id);
    if (!files || files->manifest != port.manifest) continue;
    add(document.path, uses_of_port(document.text, port.id, port.port), document.text);
    for (const std::string& other : analyst_.own_manifests(document.path, document.text))
      add_manifest(other);
  }
  return changes;
}

/// A name that the rename missed is an error now: the first error that was not there before.
std::string Server::why_not(const std::vector<Change>& changes) {
  std::vector<std::size_t> before;
  for (const auto& [uri, document] : documents_)
    before.push_back(analyst_.try_out(document.path, document.text).diagnostics.error_count());
  for (const Change& each : changes) analyst_.set_text(each.path, applied(each.text, each.splices));
  std::string why;
  std::size_t i = 0;
  for (const auto& [uri, document] : documents_) {
    const std::string now = analyst_.text_of(document.path).value_or(document.text);
    const Analyst::Checked checked = analyst_.try_out(document.path, now);
    if (checked.diagnostics.error_count() > before[i++] && why.empty())
      why = fmt::format("there would be an error: {}", checked.diagnostics.all().front().message);
  }
  for (const Change& each : changes) {
    const auto open =
        ranges::find_if(documents_, [&](const auto& one) { return one.second.path == each.path; });
    analyst_.set_text(each.path,
                      open != documents_.end() ? std::optional(open->second.text) : std::nullopt);
  }
  return why;
}

Server::Answer Server::port_renamed(const PortToRename& port, const std::string& to) {
  const auto manifest = analyst_.text_of(port.manifest);
  if (!manifest) return {{}, kInvalidParams, fmt::format("`{}` cannot be read", port.manifest)};
  std::string why = why_no_port(*manifest, port.port, to);
  const std::vector<Change> changes = why.empty() ? changes_of(port, to) : std::vector<Change>();
  if (why.empty()) why = why_not(changes);
  if (!why.empty()) return {{}, kInvalidParams, why};
  std::vector<std::pair<std::string, Json>> edits;
  edits.reserve(changes.size());
  for (const Change& each : changes)
    edits.emplace_back(each.uri, splices_json(each.splices, each.text));
  return {edits_json(edits)};
}

}  // namespace eagerx::gen::lsp

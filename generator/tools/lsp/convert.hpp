// Between the server's values and LSP's JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/frontend/outline/outline.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"
#include "generator/tools/edit/edit.hpp"
#include "generator/tools/lsp/complete.hpp"
#include "generator/tools/lsp/fold.hpp"
#include "generator/tools/lsp/resolved.hpp"
#include "generator/tools/lsp/text.hpp"

namespace eagerx::gen::lsp {

bool is_manifest(std::string_view path);
Json range_of(std::string_view text, Bytes bytes);
Json location_json(const std::string& uri, std::string_view text, Bytes bytes);
std::optional<Position> position_in(const Json* json);
/// A diagnostic of a file with this text, without its notes.
Json diagnostic_json(const Diagnostic& diagnostic, std::string_view text);
Json completion_json(const Completion& completion, std::string_view text);
/// The keys of a graph as an editor's outline shows them: sections, objects, nodes, connections.
Json symbols_json(const OutlineNode& top, std::string_view text);
Json splices_json(const std::vector<Splice>& splices, std::string_view text);
/// Changes of documents, by their URIs: lists as splices_json() makes them.
Json edits_json(const std::vector<std::pair<std::string, Json>>& of_documents);
Json hints_json(const std::vector<InlayHint>& hints, std::string_view text);
Json folds_json(const std::vector<Fold>& folds);
/// A change of one document.
Json edit_json(const Edit& edit, const std::string& uri, std::string_view text);

}  // namespace eagerx::gen::lsp

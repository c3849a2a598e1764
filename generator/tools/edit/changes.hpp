// Helpers for changes of a graph's structure. Inside edit/ only.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/edit/structure.hpp"
#include "generator/tools/edit/written.hpp"

namespace eagerx::gen {

inline constexpr std::array kEntitySections = {"objects", "nodes"};
inline constexpr std::array kAgentSections = {"actions", "observations"};
inline constexpr const char* kByHand = "change it in the text of the file";

template <std::size_t N>
bool is_among(const std::array<const char*, N>& words, std::string_view word) {
  return ranges::contains(words, word);
}

Change refused(std::string problem, std::string help = {});
Change made(std::string reason, std::string_view before, const Written& after);

/// "connections[2].from"
std::string shown(const OutlinePath& path);
/// The key at a place of a path; empty: there is none.
std::string key_at(const OutlinePath& path, std::size_t index);
/// The problem of one of them, or "".
std::string problem_of(const std::vector<KeyValue>& values);
/// "a: 1, b: {c: 2}"
std::string flow_of(const std::vector<KeyValue>& values);
/// Whether only the value at `path` differs.
bool differs_only_at(const Written& before, const Written& after, const OutlinePath& path);
/// Whether a section has a key or an item of this name.
bool has_name(const Written& written, const std::string& section, const std::string& name);
/// Letters, digits and `_`, no digit first.
bool is_name(const std::string& name);
/// Whether another one of the section, or of those that share its names, has it.
bool is_taken(const Written& written, const std::string& section, const std::string& name);
/// Adds a name to a list of names, or to a mapping of them.
bool add_name(Written& written, const OutlinePath& path, const std::string& name);

}  // namespace eagerx::gen

// Facts about a graph beyond its text: rates, spaces, delays, ages. They come from the last text
// without errors and are found by name, so that they stay available during typing.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/outline.hpp"

namespace eagerx::gen::lsp {

struct Resolved {
  /// Of a connection, by where it goes: "pendulum.u".
  struct Connection {
    std::string per_tick;   // "1 a tick", "1 in 2 ticks", "1.5 a tick"
    std::string age;        // of the newest message, at most: "33.3 ms"
    std::string defaulted;  // what is not written at the connection, but holds: "window 3"
    std::string about;      // all of it, in Markdown
  };
  std::map<std::string, Connection, std::less<>> connections;
  std::map<std::string, std::string, std::less<>> ports;   // by names: rate and space, in Markdown
  std::map<std::string, std::string, std::less<>> owners;  // objects and nodes: rate and more
  std::map<std::string, std::string, std::less<>> rates;   // of nodes, in Hz
};

/// A name without the indices of elements: "leg[0].torque" and "leg[*].torque" are "leg.torque".
std::string without_indices(std::string_view name);

/// A few words after a place in the text.
struct InlayHint {
  std::size_t at = 0;  // byte
  std::string text, about;
};
/// Hints in the bytes `within`: messages per tick and their age after the ends of connections,
/// defaults, and rates of nodes without a `rate`.
std::vector<InlayHint> inlay_hints(const OutlineNode& graph, const Resolved& resolved,
                                   Bytes within);

}  // namespace eagerx::gen::lsp

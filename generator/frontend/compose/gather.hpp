// Elements of messages that are connected one by one: `robot.torque[*]`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// The connections to one element.
struct GatheredElement {
  std::int64_t element = 0;
  Spanned<std::string> from;
  YamlValue connection;  // with its settings
};

/// `Mux` nodes and connections that join elements into one message, and the sender of that message.
struct Gathered {
  std::vector<YamlValue::Entry> nodes;
  std::vector<YamlValue> connections;
  Spanned<std::string> from;
  YamlValue connection;  // from there, with its settings
};
/// `rate`: of the nodes. Problems: E0391 an element twice or never.
std::optional<Gathered> gather(const Spanned<std::string>& to,
                               std::vector<GatheredElement> elements, const YamlValue& rate,
                               Diagnostics& diagnostics);

/// A connection that reads one element of its source's message.
YamlValue with_element(YamlValue connection, std::int64_t element, Span span);

}  // namespace eagerx::gen

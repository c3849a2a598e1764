// The ports of a graph that is being flattened, by the full names of their owners.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/port_name.hpp"

namespace eagerx::gen {

struct InnerPorts {
  PortBindings ends;  // of composites
  std::map<std::string, const Entity*>
      entity_of;  // of other composites; nullptr: unknown, or a policy

  /// Names of the ports of an owner that send, or receive; nullopt where they are not known.
  [[nodiscard]] std::optional<std::vector<std::string>> known(const PortName& name,
                                                              bool sends) const;
  /// Whether the inner port that a composite's port is bound to exists (E0390). Unknown entities
  /// are not reported.
  bool is_there(const Spanned<std::string>& bound, const std::string& port, bool sends,
                Diagnostics& diagnostics) const;
  /// Whether a composite that a graph connects has the port (E0307).
  bool has_port(const Spanned<std::string>& written, const std::string& port, bool sends,
                Diagnostics& diagnostics) const;
};

/// The sources of the inputs in a composite: its connections and its ports.
class Feeds {
 public:
  void add_connection(const YamlValue& connection);
  /// E0390 if something else feeds the input.
  void bind(const std::string& port, const Spanned<std::string>& written, Diagnostics& diagnostics);

 private:
  std::map<std::string, Span> bound_, connected_;
};

}  // namespace eagerx::gen

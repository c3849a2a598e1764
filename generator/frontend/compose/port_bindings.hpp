// The inner ports of a composite's ports, by their full names.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// An inner input, and the settings of the enclosing composites for connections to it, the
/// outermost first: mappings with `window`, `delay`, `processor` …
struct PortBinding {
  std::string port;
  std::vector<YamlValue> settings;
};

/// The ports of one composite.
struct CompositePorts {
  std::map<std::string, std::vector<PortBinding>> sinks;
  std::map<std::string, std::string> sources;
  std::set<std::string, std::less<>> broken;  // those that send, and what is wrong has been said
};

class PortBindings {
 public:
  void add(const std::string& composite, CompositePorts ports) {
    composites_[composite] = std::move(ports);
  }
  [[nodiscard]] const CompositePorts* find(const std::string& composite) const {
    const auto found = composites_.find(composite);
    return found == composites_.end() ? nullptr : &found->second;
  }

  /// All of them, by their full names.
  [[nodiscard]] const std::map<std::string, CompositePorts>& composites() const {
    return composites_;
  }

  /// The port that sends where a full name such as `arm.u` is written.
  [[nodiscard]] std::string source(const std::string& port) const;
  /// The receiving ports. A port that is not a composite's is unchanged.
  [[nodiscard]] std::vector<PortBinding> sinks(const std::string& port) const;

 private:
  std::map<std::string, CompositePorts> composites_;
};

/// The pictures of the composite `name`, with its ports in the order of its manifest.
CompositeSpec shown_composite(const std::string& name, Span span, const Entity& entity,
                              const YamlValue* rate, const CompositePorts& ports);

/// `connection` between two inner ports, with the settings of both ends; its own settings take
/// precedence.
YamlValue joined(const YamlValue& connection, const Spanned<std::string>& from,
                 const Spanned<std::string>& to, const std::vector<YamlValue>& settings);

/// `map` with `value` under `key`, which replaces a previous value.
void set_entry(YamlValue& map, const std::string& key, Span span, YamlValue value);
/// The value under `key`, made if it is not there, as an empty mapping.
YamlValue& map_at(YamlValue& map, const std::string& key, Span span);

/// Makes all of a tree a part of `file`.
void move_file(YamlValue& yaml, FileId file);

}  // namespace eagerx::gen

// Settings of an entity, a port or a connection, as written in graphs and manifests.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/reference.hpp"

namespace eagerx::gen {

/// A value and where it was written.
template <class T>
struct Spanned {
  T value{};
  Span span;
};

/// A key with a value that only a manifest can check.
struct Setting {
  std::string name;
  Span span;
  YamlValue value;
};

struct ProcessorSpec {
  Spanned<std::string> type;
  std::vector<Setting> config;
  std::vector<ProcessorSpec> before = {};  // of a list: those that convert before it, in order
};

/// How a state or a delay gets its value at a reset.
struct RandomSpec {
  enum class Kind : std::uint8_t { value, uniform, normal, log_uniform, choice };
  Kind kind = Kind::uniform;
  Span span;
  std::optional<YamlValue> first;   // value; low; mean; list of choices
  std::optional<YamlValue> second;  // high; std
};

/// An exact rate in Hz, time in seconds or number of messages; in a manifest possibly an expression
/// of references, `$(config limit)`.
struct QuantitySpec {
  std::variant<Rational, YamlValue> value;
  Span span;
  bool with_unit = false;  // one was written
  bool is_option = false;  // an option of the command line, instead of what is written

  /// nullptr: it is an expression.
  [[nodiscard]] const Rational* number() const { return std::get_if<Rational>(&value); }
  /// nullptr: it is a number.
  [[nodiscard]] const YamlValue* expression() const { return std::get_if<YamlValue>(&value); }
};

/// Settings of a connection. A manifest's port, the graph's port and the connection may each give
/// some; `overlay` puts one on top of the other.
struct ConnectionSettings {
  std::optional<QuantitySpec> window;      // in messages
  std::optional<QuantitySpec> delay;       // in seconds
  std::optional<RandomSpec> random_delay;  // sampled at every reset, replaces `delay`
  std::optional<QuantitySpec> max_delay;   // a reset may change the delay up to these seconds
  std::optional<Spanned<bool>> skip;
  std::optional<ProcessorSpec> processor;
};

/// `base` with everything that `over` says.
ConnectionSettings overlay(ConnectionSettings base, const ConnectionSettings& over);

// Values of settings, or their defaults.
/// 1 if not set; nullopt for a reference.
std::optional<std::uint32_t> window_of(const ConnectionSettings& settings);
/// In seconds; 0 if not set; nullopt for a reference.
std::optional<Rational> delay_of(const ConnectionSettings& settings);
bool skips(const ConnectionSettings& settings);

// Of trees that `check` has accepted.
/// A copy of the value under `key`, if there is one.
std::optional<YamlValue> value_at(const YamlValue& yaml, std::string_view key);
std::vector<Setting> read_config(const YamlValue* yaml);
ProcessorSpec read_processor(const YamlValue& yaml);
QuantitySpec read_quantity(const YamlValue& yaml);
/// The reference in an expression that contains nothing else.
std::optional<Reference> reference_in(const QuantitySpec& quantity);
/// nullopt without a value; E0206 if there are several.
std::optional<RandomSpec> read_random(const YamlValue& yaml, Diagnostics& diagnostics);
/// Of the mapping of a connection, or of a port in a graph or a manifest.
ConnectionSettings read_connection_settings(const YamlValue& yaml, Diagnostics& diagnostics);

}  // namespace eagerx::gen

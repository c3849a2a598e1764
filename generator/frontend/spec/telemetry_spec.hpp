// The contents of `telemetry:` as written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

inline constexpr const char* kTelemetry = "telemetry";

struct TelemetrySpec {
  Span span;                                   // of the key
  std::vector<Spanned<std::string>> channels;  // ports
  std::optional<Spanned<Rational>> share;      // of the line
  std::optional<Spanned<Rational>> rate;       // most messages a second of a channel
  std::optional<Spanned<Rational>> baud;       // of the line
};

}  // namespace eagerx::gen

// The contents of `render:` as written.
#pragma once

#include <optional>
#include <string>

#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// The name of the drawing node in connections.
inline constexpr const char* kRender = "render";

struct RenderSpec {
  Span span;
  Spanned<std::string> source;
  std::optional<Spanned<Rational>> rate;  // of pictures; default: that of the environment
};

}  // namespace eagerx::gen

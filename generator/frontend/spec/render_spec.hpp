// The contents of `render:` as written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// The name of the drawing node in connections.
inline constexpr const char* kRender = "render";

/// A key of a keyboard that adds to a tunable parameter while it is held.
struct RenderKey {
  Spanned<std::string> key;        // as browsers name it, such as ArrowUp
  Spanned<std::string> parameter;  // `commands.y`
  std::vector<double> add;         // [numbers of the parameter]
};

struct RenderSpec {
  Span span;
  Spanned<std::string> source;
  std::optional<Spanned<Rational>> rate;  // of pictures; default: that of the environment
  std::vector<RenderKey> keys;
};

}  // namespace eagerx::gen

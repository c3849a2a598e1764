// The drawing of a graph as text: SVG in our own layout, or input for Graphviz and Mermaid, which
// do the layout.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/tools/drawing/drawing.hpp"
#include "generator/tools/drawing/layout.hpp"

namespace eagerx::gen {

enum class DrawingFormat : std::uint8_t { svg, dot, mermaid };

/// By the end of a file's name: .svg, .dot or .gv, .mmd or .mermaid.
std::optional<DrawingFormat> drawing_format_of(std::string_view path);

/// The same bytes on every machine. Names are data: they become text in the format's language.
std::string drawing_text(const Drawing& drawing, DrawingFormat format);

/// The `d` of a wire's path in SVG.
std::string wire_path(const PlacedWire& wire);

std::string svg_of(const Drawing& drawing);
std::string dot_of(const Drawing& drawing);
std::string mermaid_of(const Drawing& drawing);

}  // namespace eagerx::gen

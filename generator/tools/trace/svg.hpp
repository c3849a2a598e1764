// Shared parts of plots: paper, colours and text, as SVG.
#pragma once

#include <cstddef>
#include <string>

namespace eagerx::gen {

/// Colours of lines (class `lN`, below this) and of areas and text (`tN`).
inline constexpr std::size_t kSvgColours = 6;

/// The element with its style and an empty paper; "</svg>" ends it. In pixels.
std::string svg_begin(int width, int height);
/// `anchor`: start, middle, end; `look`: its classes, "name" for titles.
std::string svg_label(double x, double y, const char* anchor, const std::string& text,
                      const std::string& look);

}  // namespace eagerx::gen

#include "generator/tools/drawing/format.hpp"

namespace eagerx::gen {

std::optional<DrawingFormat> drawing_format_of(std::string_view path) {
  if (path.ends_with(".svg")) return DrawingFormat::svg;
  if (path.ends_with(".dot") || path.ends_with(".gv")) return DrawingFormat::dot;
  if (path.ends_with(".mmd") || path.ends_with(".mermaid")) return DrawingFormat::mermaid;
  return std::nullopt;
}

std::string drawing_text(const Drawing& drawing, DrawingFormat format) {
  switch (format) {
    case DrawingFormat::dot:
      return dot_of(drawing);
    case DrawingFormat::mermaid:
      return mermaid_of(drawing);
    case DrawingFormat::svg:
      break;
  }
  return svg_of(drawing);
}

}  // namespace eagerx::gen

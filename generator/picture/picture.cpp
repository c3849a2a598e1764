#include "generator/picture/picture.hpp"

namespace eagerx::gen {

std::optional<PictureFormat> picture_format_of(std::string_view path) {
  if (path.ends_with(".svg")) return PictureFormat::svg;
  if (path.ends_with(".dot") || path.ends_with(".gv")) return PictureFormat::dot;
  if (path.ends_with(".mmd") || path.ends_with(".mermaid")) return PictureFormat::mermaid;
  return std::nullopt;
}

std::string picture_of(const Drawing& drawing, PictureFormat format) {
  switch (format) {
    case PictureFormat::dot:
      return dot_of(drawing);
    case PictureFormat::mermaid:
      return mermaid_of(drawing);
    case PictureFormat::svg:
      break;
  }
  return svg_of(drawing);
}

}  // namespace eagerx::gen

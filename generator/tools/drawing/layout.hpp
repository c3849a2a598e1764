// Layout of a drawing: layers from left to right, few crossings, short wires.
//
// After Sugiyama, Tagawa, Toda, "Methods for visual understanding of hierarchical system
// structures" (1981): break circles, choose layers, order within layers, then places. All places
// are whole numbers and every choice between equals is by number, so the same graph gives the same
// drawing on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/tools/drawing/drawing.hpp"

namespace eagerx::gen {

/// In pixels; y grows downwards.
struct Point {
  std::int64_t x = 0, y = 0;
};

struct Layout;

struct PlacedBox {
  Point corner;  // upper left
  std::int64_t width = 0, height = 0;
  std::vector<std::int64_t> input_y, output_y;  // of the ports, from the top of the box
  std::vector<Layout> inside;  // of an open composite, one: places from its upper left corner
};

struct PlacedWire {
  std::vector<Point> points;  // from port to port; curves between them begin and end level
  bool backwards = false;  // against the direction of reading: along right angles, below the rest
};

struct Layout {
  std::int64_t width = 0, height = 0;
  std::vector<PlacedBox> boxes;   // of Drawing::boxes
  std::vector<PlacedWire> wires;  // of Drawing::wires
};

/// Whether composites are frames with their contents, or boxes.
enum class Composites : std::uint8_t { open, closed };
/// Of a drawing that is nested; of one within a composite, the places in its frame.
Layout layout_of(const Drawing& drawing, Composites composites);

/// The label of a port or a box, cut to the maximum length, because names may have any length.
std::string shown(const std::string& text);

/// Pixels that the layout reserves and svg_of() uses.
namespace px {
inline constexpr std::int64_t margin = 20, padding = 10, header = 40, row = 18, detail = 14;
inline constexpr std::int64_t between_boxes = 22, between_layers = 56, lane = 12;
}  // namespace px

}  // namespace eagerx::gen

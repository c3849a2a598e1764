#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/drawing/format.hpp"

namespace eagerx::gen {
namespace {

struct Look {
  BoxKind kind;
  const char* name;
  const char *fill, *line;            // on white paper
  const char *dark_fill, *dark_line;  // on a dark one
};

constexpr std::array<Look, 8> kLooks = {{
    {BoxKind::actions, "end", "#f2f4f7", "#667085", "#1d2939", "#98a2b3"},
    {BoxKind::observations, "end", "#f2f4f7", "#667085", "#1d2939", "#98a2b3"},
    {BoxKind::object, "object", "#e8f1fc", "#2f6fb7", "#10294a", "#7fb2ec"},
    {BoxKind::node, "node", "#e9f6ee", "#2e7d4f", "#10301f", "#7fcf9f"},
    {BoxKind::reset_node, "reset", "#f3ecfb", "#7446ad", "#2a1745", "#bd9be8"},
    {BoxKind::engine, "engine", "#fdf0e3", "#b3661b", "#3d2308", "#efb27a"},
    {BoxKind::engine_node, "engine-node", "#fef7ee", "#b3661b", "#2b1a08", "#efb27a"},
    {BoxKind::task, "task", "#fdeef2", "#b03a5b", "#3d0f1d", "#ee94ae"},
}};

const Look& look_of(BoxKind kind) {
  for (const Look& look : kLooks) {
    if (look.kind == kind) return look;
  }
  return kLooks.front();
}

/// `frames`: also that of open composites.
std::string style(bool frames) {
  std::string light, dark;
  for (const Look& look : kLooks) {
    if (look.kind == BoxKind::observations) continue;  // as the actions
    light += fmt::format(".{0}{{fill:{1};stroke:{2}}}", look.name, look.fill, look.line);
    dark += fmt::format(".{0}{{fill:{1};stroke:{2}}}", look.name, look.dark_fill, look.dark_line);
  }
  if (frames) light += ".frame{fill-opacity:.35;stroke-dasharray:2 3}";
  return fmt::format(
      "<style>text{{font:12px system-ui,'Segoe UI',Roboto,'Liberation Sans',Arial,sans-serif;"
      "fill:#1d2939}}.name{{font-weight:600;font-size:14px}}.type,.detail{{fill:#667085}}"
      ".detail{{font-size:10px}}.out{{text-anchor:end}}rect{{stroke-width:1.5}}"
      "path{{fill:none;stroke:#667085;stroke-width:1.5}}.state{{stroke-dasharray:5 4}}"
      ".tip{{fill:#667085;stroke:none}}{}"
      "@media(prefers-color-scheme:dark){{text{{fill:#f2f4f7}}.type,.detail{{fill:#98a2b3}}"
      "path{{stroke:#98a2b3}}.tip{{fill:#98a2b3}}{}}}</style>\n",
      light, dark);
}

/// With rounded corners where it runs along right angles.
std::string right_angles(const std::vector<Point>& points) {
  constexpr std::int64_t kRadius = 6;
  const auto towards = [](std::int64_t from, std::int64_t to, std::int64_t distance) {
    return to > from ? from + distance : to < from ? from - distance : from;
  };
  std::string path = fmt::format("M{} {}", points[0].x, points[0].y);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point &before = points[i - 1], &corner = points[i], &after = points[i + 1];
    const auto radius_to = [&](const Point& other) {
      const std::int64_t length = std::abs(other.x - corner.x) + std::abs(other.y - corner.y);
      return std::min(kRadius, length / 2);
    };
    const std::int64_t in = radius_to(before), out = radius_to(after);
    path += fmt::format("L{} {}Q{} {} {} {}", towards(corner.x, before.x, in),
                        towards(corner.y, before.y, in), corner.x, corner.y,
                        towards(corner.x, after.x, out), towards(corner.y, after.y, out));
  }
  return path + fmt::format("L{} {}", points.back().x, points.back().y);
}

std::string curves(const std::vector<Point>& points) {
  std::string path = fmt::format("M{} {}", points[0].x, points[0].y);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    if (a.y == b.y) {
      path += fmt::format("L{} {}", b.x, b.y);
    } else {
      const std::int64_t middle = (a.x + b.x) / 2;
      path += fmt::format("C{} {} {} {} {} {}", middle, a.y, middle, b.y, b.x, b.y);
    }
  }
  return path;
}

std::string wire_text(const Wire& wire, const PlacedWire& placed) {
  const Point end = placed.points.back();
  return fmt::format(
      "<g><title>{}</title><path{} d=\"{}\"/><path class=\"tip\" d=\"M{} {}l-8 -4v8z\"/></g>\n",
      xml_text(wire.about), wire.sets_state ? " class=\"state\"" : "", wire_path(placed), end.x,
      end.y);
}

std::string ports_text(const std::vector<BoxPort>& ports, const std::vector<std::int64_t>& at,
                       std::int64_t x, std::int64_t top, bool outputs) {
  std::string text;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const std::int64_t y = top + at[i] + 4;
    text += fmt::format("<text{} x=\"{}\" y=\"{}\">{}</text>", outputs ? " class=\"out\"" : "", x,
                        y, xml_text(shown(ports[i].name)));
    if (!ports[i].detail.empty())
      text +=
          fmt::format("<text class=\"detail{}\" x=\"{}\" y=\"{}\">{}</text>", outputs ? " out" : "",
                      x, y + px::detail - 1, xml_text(shown(ports[i].detail)));
  }
  return text;
}

std::string contents_text(const Drawing& drawing, const Layout& layout, Point origin);

std::string box_text(const Box& box, const PlacedBox& placed, Point origin) {
  const Point corner{origin.x + placed.corner.x, origin.y + placed.corner.y};
  std::string text = "<g>";
  if (!box.about.empty())
    text += fmt::format("<title>{}</title>", xml_text(box.name + ": " + box.about));
  text +=
      fmt::format("<rect class=\"{}{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"8\"/>",
                  placed.inside.empty() ? "" : "frame ", look_of(box.kind).name, corner.x, corner.y,
                  placed.width, placed.height);
  text += fmt::format(
      "<text class=\"name\" x=\"{0}\" y=\"{1}\">{2}</text>"
      "<text class=\"type\" x=\"{0}\" y=\"{3}\">{4}</text>",
      corner.x + px::padding, corner.y + 19, xml_text(shown(box.name)), corner.y + 34,
      xml_text(shown(box.subtitle)));
  text += ports_text(box.inputs, placed.input_y, corner.x + px::padding, corner.y, false);
  text += ports_text(box.outputs, placed.output_y, corner.x + placed.width - px::padding, corner.y,
                     true);
  text += "</g>\n";
  if (!placed.inside.empty()) text += contents_text(*box.inside, placed.inside.front(), corner);
  return text;
}

PlacedWire moved(PlacedWire wire, Point by) {
  for (Point& point : wire.points) point = {point.x + by.x, point.y + by.y};
  return wire;
}

std::string contents_text(const Drawing& drawing, const Layout& layout, Point origin) {
  std::string text;
  for (std::size_t w = 0; w < drawing.wires.size(); ++w)
    text += wire_text(drawing.wires[w], moved(layout.wires[w], origin));
  for (std::size_t b = 0; b < drawing.boxes.size(); ++b) {
    const BoxKind kind = drawing.boxes[b].kind;
    if (kind == BoxKind::entry || kind == BoxKind::exit) continue;  // names at the frame
    text += box_text(drawing.boxes[b], layout.boxes[b], origin);
  }
  return text;
}

}  // namespace

std::string wire_path(const PlacedWire& wire) {
  return wire.backwards ? right_angles(wire.points) : curves(wire.points);
}

std::string svg_of(const Drawing& flat) {
  const Drawing drawing = nested(flat);
  const Layout layout = layout_of(drawing, Composites::open);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\">\n<title>{2}</title>\n",
      layout.width, layout.height, xml_text(drawing.title));
  text += style(!flat.groups.empty());
  text += contents_text(drawing, layout, {});
  return text + "</svg>\n";
}

}  // namespace eagerx::gen

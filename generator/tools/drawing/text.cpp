// The languages of Graphviz and Mermaid.
#include <fmt/format.h>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/drawing/format.hpp"
#include "generator/tools/drawing/layout.hpp"

namespace eagerx::gen {
namespace {

/// A field of a record of Graphviz.
std::string field(const std::string& port, const BoxPort& each) {
  std::string text = each.name + (each.detail.empty() ? "" : " (" + each.detail + ")");
  return fmt::format("<{}> {}", port, dot_record_text(text));
}

std::string fields(const char* prefix, const std::vector<BoxPort>& ports) {
  std::string text;
  for (std::size_t i = 0; i < ports.size(); ++i)
    text += (i == 0 ? "" : " | ") + field(fmt::format("{}{}", prefix, i), ports[i]);
  return text;
}

const char* fill_of(BoxKind kind) {
  switch (kind) {
    case BoxKind::object:
      return "#e8f1fc";
    case BoxKind::node:
      return "#e9f6ee";
    case BoxKind::reset_node:
      return "#f3ecfb";
    case BoxKind::engine:
    case BoxKind::engine_node:
      return "#fdf0e3";
    case BoxKind::task:
      return "#fdeef2";
    default:
      return "#f2f4f7";
  }
}

/// Boxes, and around those of a composite what `begin` says of it, as nested as they are.
template <class F, class G>
std::string nested_text(const Drawing& drawing, std::optional<std::size_t> around,
                        const std::string& end, F&& of_box, G&& begin) {
  std::string text;
  for (std::size_t b = 0; b < drawing.boxes.size(); ++b)
    if (drawing.boxes[b].group == around) text += of_box(b);
  for (std::size_t g = 0; g < drawing.groups.size(); ++g) {
    if (drawing.groups[g].around != around) continue;
    const std::string inside = nested_text(drawing, g, end, of_box, begin);
    if (!inside.empty()) text.append(begin(g)).append(inside).append(end);
  }
  return text;
}

}  // namespace

std::string dot_of(const Drawing& drawing) {
  std::string text = fmt::format(
      "digraph {} {{\n  rankdir=LR;\n  node [shape=record, style=filled, "
      "fontname=\"sans-serif\"];\n",
      dot_string(drawing.title));
  const auto box_text = [&](std::size_t b) {
    const Box& box = drawing.boxes[b];
    const std::string middle =
        fmt::format("{}\\n{}", dot_record_text(box.name), dot_record_text(box.subtitle));
    return fmt::format("  b{} [fillcolor=\"{}\", label=\"{{{{{}}} | {} | {{{}}}}}\"];\n", b,
                       fill_of(box.kind), fields("i", box.inputs), middle,
                       fields("o", box.outputs));
  };
  const auto cluster = [&](std::size_t g) {
    const Box& box = drawing.groups[g].box;
    return fmt::format("  subgraph cluster_{} {{ label={}; style=rounded;\n", g,
                       dot_string(box.name + ": " + box.subtitle));
  };
  text += nested_text(drawing, std::nullopt, "  }\n", box_text, cluster);
  for (const Wire& wire : drawing.wires)
    text +=
        fmt::format("  b{}:o{}:e -> b{}:i{}:w [tooltip={}{}];\n", wire.from, wire.output, wire.to,
                    wire.input, dot_string(wire.about), wire.sets_state ? ", style=dashed" : "");
  return text + "}\n";
}

std::string mermaid_of(const Drawing& drawing) {
  std::string text = "flowchart LR\n";
  const auto box_text = [&](std::size_t b) {
    return fmt::format("  b{}[\"<b>{}</b><br/>{}\"]\n", b, mermaid_text(drawing.boxes[b].name),
                       mermaid_text(drawing.boxes[b].subtitle));
  };
  const auto subgraph = [&](std::size_t g) {
    const Box& box = drawing.groups[g].box;
    return fmt::format("  subgraph g{}[\"<b>{}</b> {}\"]\n", g, mermaid_text(box.name),
                       mermaid_text(box.subtitle));
  };
  text += nested_text(drawing, std::nullopt, "  end\n", box_text, subgraph);
  for (const Wire& wire : drawing.wires) {
    const BoxPort& from = drawing.boxes[wire.from].outputs[wire.output];
    const BoxPort& to = drawing.boxes[wire.to].inputs[wire.input];
    std::string label = mermaid_text(from.name);
    if (to.name != from.name) label += " → " + mermaid_text(to.name);
    for (const BoxPort* port : {&from, &to}) {
      if (!port->detail.empty()) label += "<br/>" + mermaid_text(port->detail);
    }
    text += fmt::format("  b{} {}|\"{}\"| b{}\n", wire.from, wire.sets_state ? "-.->" : "-->",
                        label, wire.to);
  }
  return text;
}

}  // namespace eagerx::gen

// The languages of Graphviz and Mermaid.
#include <fmt/format.h>

#include "generator/picture/layout.hpp"
#include "generator/picture/picture.hpp"
#include "generator/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// A field of a record of Graphviz.
std::string field(const std::string& port, const PicturePort& each) {
  std::string text = each.name + (each.detail.empty() ? "" : " (" + each.detail + ")");
  return fmt::format("<{}> {}", port, dot_record_text(text));
}

std::string fields(const char* prefix, const std::vector<PicturePort>& ports) {
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

}  // namespace

std::string dot_of(const Drawing& drawing) {
  std::string text = fmt::format(
      "digraph {} {{\n  rankdir=LR;\n  node [shape=record, style=filled, "
      "fontname=\"sans-serif\"];\n",
      dot_string(drawing.title));
  for (std::size_t b = 0; b < drawing.boxes.size(); ++b) {
    const Box& box = drawing.boxes[b];
    const std::string middle =
        fmt::format("{}\\n{}", dot_record_text(box.name), dot_record_text(box.subtitle));
    text +=
        fmt::format("  b{} [fillcolor=\"{}\", label=\"{{{{{}}} | {} | {{{}}}}}\"];\n", b,
                    fill_of(box.kind), fields("i", box.inputs), middle, fields("o", box.outputs));
  }
  for (const Wire& wire : drawing.wires)
    text +=
        fmt::format("  b{}:o{}:e -> b{}:i{}:w [tooltip={}{}];\n", wire.from, wire.output, wire.to,
                    wire.input, dot_string(wire.about), wire.sets_state ? ", style=dashed" : "");
  return text + "}\n";
}

std::string mermaid_of(const Drawing& drawing) {
  std::string text = "flowchart LR\n";
  for (std::size_t b = 0; b < drawing.boxes.size(); ++b)
    text += fmt::format("  b{}[\"<b>{}</b><br/>{}\"]\n", b, mermaid_text(drawing.boxes[b].name),
                        mermaid_text(drawing.boxes[b].subtitle));
  for (const Wire& wire : drawing.wires) {
    const PicturePort& from = drawing.boxes[wire.from].outputs[wire.output];
    const PicturePort& to = drawing.boxes[wire.to].inputs[wire.input];
    std::string label = mermaid_text(from.name);
    if (to.name != from.name) label += " → " + mermaid_text(to.name);
    for (const PicturePort* port : {&from, &to}) {
      if (!port->detail.empty()) label += "<br/>" + mermaid_text(port->detail);
    }
    text += fmt::format("  b{} {}|\"{}\"| b{}\n", wire.from, wire.sets_state ? "-.->" : "-->",
                        label, wire.to);
  }
  return text;
}

}  // namespace eagerx::gen

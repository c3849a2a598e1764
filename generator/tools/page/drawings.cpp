// The graph as the user wrote it and as it runs, each box and wire with its place.
#include "generator/tools/drawing/format.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

const char* name_of(BoxKind kind) {
  switch (kind) {
    case BoxKind::actions:
    case BoxKind::observations:
      return "end";
    case BoxKind::object:
      return "object";
    case BoxKind::node:
      return "node";
    case BoxKind::reset_node:
      return "reset";
    case BoxKind::engine:
      return "engine";
    case BoxKind::engine_node:
      return "engine-node";
    case BoxKind::entry:
      return "entry";
    case BoxKind::exit:
      return "exit";
    case BoxKind::task:
      break;
  }
  return "task";
}

Json ports_json(const std::vector<BoxPort>& ports, const std::vector<std::int64_t>& y) {
  Json list = Json::list();
  for (std::size_t i = 0; i < ports.size(); ++i)
    list.push_back(
        Json{{"name", shown(ports[i].name)}, {"detail", shown(ports[i].detail)}, {"y", y[i]}});
  return list;
}

Json number(const std::optional<std::size_t>& index) {
  return index ? Json(*index) : Json(nullptr);
}

/// Composites closed; the page opens them.
Json drawing_json(const Drawing& drawing) {
  const Layout layout = layout_of(drawing, Composites::closed);
  Json json{{"width", layout.width},
            {"height", layout.height},
            {"boxes", Json::list()},
            {"wires", Json::list()}};
  for (std::size_t b = 0; b < drawing.boxes.size(); ++b) {
    const Box& box = drawing.boxes[b];
    const PlacedBox& place = layout.boxes[b];
    Json placed{{"kind", name_of(box.kind)},
                {"name", box.name},
                {"title", shown(box.name)},
                {"subtitle", shown(box.subtitle)},
                {"about", box.about},
                {"x", place.corner.x},
                {"y", place.corner.y},
                {"width", place.width},
                {"height", place.height},
                {"node", number(box.node)},
                {"object", number(box.object)},
                {"inputs", ports_json(box.inputs, place.input_y)},
                {"outputs", ports_json(box.outputs, place.output_y)}};
    if (box.inside != nullptr) {
      placed["composite"] = box.full_name;
      placed["inside"] = drawing_json(*box.inside);
    }
    json["boxes"].push_back(std::move(placed));
  }
  for (std::size_t w = 0; w < drawing.wires.size(); ++w) {
    const Wire& wire = drawing.wires[w];
    Json points = Json::list(), readers = Json::list();
    for (const Point& point : layout.wires[w].points)
      points.push_back(Json::List{point.x, point.y});
    for (const Wire::Reader& reader : wire.readers)
      readers.push_back(Json::List{reader.node, reader.input});
    json["wires"].push_back(Json{{"from", wire.from},
                                 {"to", wire.to},
                                 {"about", wire.about},
                                 {"state", wire.sets_state},
                                 {"output", wire.output},
                                 {"input", wire.input},
                                 {"backwards", layout.wires[w].backwards},
                                 {"points", std::move(points)},
                                 {"readers", std::move(readers)}});
  }
  return json;
}

}  // namespace

Json drawings_json(const Graph& graph, const std::vector<CompositeSpec>& composites) {
  const auto json = [&](GraphView view) {
    return drawing_json(nested(drawing_of(graph, composites, view)));
  };
  return Json{{"user", json(GraphView::user)}, {"engine", json(GraphView::engine)}};
}

}  // namespace eagerx::gen

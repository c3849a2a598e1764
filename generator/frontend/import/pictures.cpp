// Removes nodes that only draw: EAGERx's nodes for pictures, and the sensors that feed them.
#include <fmt/format.h>

#include <array>
#include <set>

#include "generator/frontend/import/entity_mapping.hpp"
#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::array kDrawing = {"eagerx.core.nodes/RenderNode", "eagerx.core.nodes/ColabRender"};

/// uint8 [height, width, colours].
bool is_picture(const SavedPort& port) {
  const auto space = saved_space(port);
  return space && space->dtype && space->dtype->value == "uint8" && space->shape &&
         space->shape->items.size() == 3;
}

class PictureRemover {
 public:
  PictureRemover(SavedGraph& saved, const EntityMapping& mapping)
      : saved_(saved), mapping_(mapping) {}

  Pictures run() {
    for (const SavedEntity& entity : saved_.entities) {
      if (is_for_display(entity)) drawing_.insert(entity.name.value);
    }
    // Nodes that draw into pictures of other nodes, unless there is a counterpart.
    for (const SavedEntity& entity : saved_.entities) {
      if (entity.kind == SavedEntity::Kind::node && gives_pictures(entity) &&
          !mapping_.knows(entity.id.value))
        drawing_.insert(entity.name.value);
    }
    if (drawing_.empty()) return {};
    for (const auto& name : drawing_) sort_out(*saved_.find(name));
    std::erase_if(saved_.links, [&](const SavedLink& link) { return is_removed(link); });
    for (const std::string& port : unused_) result_.left_out.push_back(port);
    std::erase_if(saved_.entities,
                  [&](const SavedEntity& entity) { return drawing_.contains(entity.name.value); });
    return std::move(result_);
  }

 private:
  static bool is_for_display(const SavedEntity& entity) {
    return ranges::contains(kDrawing, entity.id.value);
  }

  static bool gives_pictures(const SavedEntity& entity) {
    const auto& outputs = entity.selected.at("outputs");
    return !outputs.empty() && ranges::all_of(outputs, [&](const auto& name) {
      const SavedPort* port = entity.port("outputs", name.value);
      return port != nullptr && is_picture(*port);
    });
  }

  void sort_out(const SavedEntity& node) {
    if (result_.place.line == 0) result_.place = node.name.span;
    std::string written = fmt::format("the node `{}`", node.name.value);
    if (is_for_display(node) && result_.object.empty() && find_shown(node.name.value)) {
      if (const YamlValue* rate = node.parameter("rate")) result_.rate_hz = meant_number(*rate);
      result_.shown.push_back(std::move(written));
    } else {
      result_.left_out.push_back(std::move(written));
    }
  }

  /// The object whose picture reaches a node, also through nodes that draw into it.
  bool find_shown(const std::string& node) {
    if (!seen_.insert(node).second) return false;
    for (const SavedLink& link : saved_.links) {
      const SavedEntity* source = saved_.find(link.from.entity);
      const SavedPort* port =
          source != nullptr ? source->port(link.from.section, link.from.port) : nullptr;
      if (link.to.entity != node || port == nullptr || !is_picture(*port)) continue;
      const SavedObject* owner = saved_.owner_of(link.from.entity);
      if (owner == nullptr && source->kind == SavedEntity::Kind::node) {
        if (find_shown(link.from.entity)) return true;
        continue;
      }
      result_.object = owner != nullptr ? owner->name.value : link.from.entity;
      result_.sensor = fmt::format("`{}.{}`", link.from.entity, link.from.port);
      return true;
    }
    return false;
  }

  bool is_removed(const SavedLink& link) {
    if (drawing_.contains(link.from.entity)) return true;
    if (!drawing_.contains(link.to.entity)) return false;
    for (SavedEntity& source : saved_.entities) {
      if (source.name.value != link.from.entity) continue;
      const SavedPort* port = source.port(link.from.section, link.from.port);
      if (port == nullptr || !is_picture(*port)) continue;
      const std::string written = fmt::format("`{}.{}`", link.from.entity, link.from.port);
      if (written != result_.sensor) unused_.insert(written);
      std::erase_if(source.selected[link.from.section],
                    [&](const auto& name) { return name.value == link.from.port; });
    }
    return true;
  }

  SavedGraph& saved_;
  const EntityMapping& mapping_;
  std::set<std::string> drawing_, unused_, seen_;
  Pictures result_;
};

/// The sensor of an object that is a drawing (eagerx/scene.hpp): float32 [rows, 16].
const PortManifest* drawing_of(const Entity& object) {
  for (const PortManifest& sensor : object.sensors) {
    const auto& shape = sensor.space.shape;
    if (shape && shape->items.size() == 2 && shape->items[1].text == "16" && sensor.space.dtype &&
        sensor.space.dtype->value == "float32")
      return &sensor;
  }
  return nullptr;
}

/// Where the drawing of the object that was shown comes from on the graph's engine; empty: nowhere.
std::string source_of(const Translation& t, const Pictures& pictures) {
  const Entity* object = pictures.object.empty() ? nullptr : t.entity(pictures.object);
  const PortManifest* drawing = object != nullptr ? drawing_of(*object) : nullptr;
  const ObjectEngine* made = drawing != nullptr ? t.implementation(*object) : nullptr;
  if (made == nullptr) return {};
  const bool draws = ranges::any_of(made->connections, [&](const ConnectionSpec& c) {
    return c.to.value == "sensors." + drawing->name.value;
  });
  return draws ? fmt::format("{}.{}", t.names.at(pictures.object), drawing->name.value) : "";
}

/// The engine's, where the drawing is made more often by itself: between two steps nothing is new.
std::optional<Spanned<Rational>> rate_of_drawing(const Translation& t, const Pictures& pictures,
                                                 const GraphSpec& spec, const EntitySpec& object) {
  const Entity& entity = *t.entity(pictures.object);
  const auto own = manifest_rate(entity, *drawing_of(entity), object.config);
  const Rational* engine = spec.engine.rate ? spec.engine.rate->number() : nullptr;
  if (!own || engine == nullptr || *own <= *engine) return std::nullopt;
  return Spanned<Rational>{*engine, pictures.place};
}

void add_render(Translation& t, const Pictures& pictures, const std::string& source) {
  GraphSpec& spec = t.result.spec;
  RenderSpec& render = spec.render.emplace();
  render.span = pictures.place;
  render.source = {source, pictures.place};
  if (pictures.rate_hz && *pictures.rate_hz > Rational())
    render.rate = Spanned<Rational>{*pictures.rate_hz, pictures.place};
  ConnectionSpec connection;
  connection.span = pictures.place;
  connection.from = render.source;
  connection.to = {fmt::format("{}.source", kRender), pictures.place};
  spec.connections.push_back(std::move(connection));
  for (EntitySpec& object : spec.objects) {
    if (object.name.value != t.names.at(pictures.object)) continue;
    ComponentSpec drawing;
    drawing.name = {parse_port(source).name, pictures.place};
    drawing.rate = rate_of_drawing(t, pictures, spec, object);
    if (!object.sensors && drawing.rate) object.sensors.emplace();
    if (object.sensors && (drawing.rate || has_only_names(*object.sensors)))
      object.sensors->push_back(std::move(drawing));
  }
}

}  // namespace

Pictures remove_pictures(SavedGraph& saved, const EntityMapping& mapping) {
  return PictureRemover(saved, mapping).run();
}

void translate_pictures(Translation& t, const Pictures& pictures) {
  if (pictures.place.line == 0) return;
  const std::string source = source_of(t, pictures);
  std::vector<std::string> left_out = pictures.left_out;
  std::string text;
  if (source.empty()) {
    left_out.insert(left_out.begin(), pictures.shown.begin(), pictures.shown.end());
    if (!pictures.sensor.empty()) left_out.push_back(pictures.sensor);
  } else {
    add_render(t, pictures, source);
    text = fmt::format("`render:` shows `{}` instead of {}", source, pictures.sensor);
  }
  if (!left_out.empty()) {
    text += fmt::format("{}left out, as {} only for pictures: {}", text.empty() ? "" : "; ",
                        left_out.size() == 1 ? "it is" : "they are", join(left_out, ", "));
  }
  t.diagnostics.note(pictures.place, text);
}

}  // namespace eagerx::gen

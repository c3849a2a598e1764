// What EAGERx showed with graph.render, as `render:`.
#include <fmt/format.h>

#include <algorithm>

#include "generator/import/translate.hpp"
#include "generator/spec/port_name.hpp"

namespace eagerx::gen {
namespace {

/// float32 [rows, 16], see eagerx/scene.hpp.
bool is_scene(const PortManifest& port) {
  const SpaceSpec& space = port.space;
  return space.dtype && space.dtype->value == "float32" && space.shape &&
         space.shape->items.size() == 2 && space.shape->items.back().text == "16";
}

/// The object's drawing, if its engine makes it.
const PortManifest* drawing_of(const Translation& t, const Entity& object) {
  const ObjectEngine* implementation = t.implementation(object);
  if (implementation == nullptr) return nullptr;
  const auto port = std::ranges::find_if(object.sensors, is_scene);
  if (port == object.sensors.end()) return nullptr;
  const bool is_made =
      std::ranges::any_of(implementation->connections, [&](const ConnectionSpec& connection) {
        return connection.to.value == "sensors." + port->name.value;
      });
  return is_made ? &*port : nullptr;
}

}  // namespace

void translate_render(Translation& t) {
  if (!t.saved.render) return;
  const SavedRender& saved = *t.saved.render;
  const Entity* object = t.entity(saved.object);
  const PortManifest* drawing = object != nullptr ? drawing_of(t, *object) : nullptr;
  if (drawing == nullptr) return;
  // A node of that name would be in the way (E0315).
  if (std::ranges::any_of(t.names, [](const auto& name) { return name.second == kRender; })) return;
  RenderSpec render;
  render.span = saved.span;
  render.source = {fmt::format("{}.{}", t.names.at(saved.object), drawing->name.value), saved.span};
  render.rate = saved.rate;
  ConnectionSpec connection;
  connection.span = saved.span;
  connection.from = render.source;
  connection.to = {fmt::format("{}.source", kRender), saved.span};
  t.diagnostics.note(saved.span, fmt::format("`render:` shows `{}` instead", render.source.value));
  t.result.spec.connections.push_back(std::move(connection));
  t.result.spec.render = std::move(render);
}

}  // namespace eagerx::gen

// What only draws: EAGERx's nodes for pictures, and the sensors that feed them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "generator/import/counterparts.hpp"
#include "generator/import/translate.hpp"

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
  PictureRemover(SavedGraph& saved, const Counterparts& counterparts, Diagnostics& diagnostics)
      : saved_(saved), counterparts_(counterparts), diagnostics_(diagnostics) {}

  void run() {
    for (const SavedEntity& entity : saved_.entities) {
      if (is_for_display(entity)) drawing_.insert(entity.name.value);
    }
    // Nodes that draw into pictures of others, unless there is a counterpart.
    for (const SavedEntity& entity : saved_.entities) {
      if (entity.kind == SavedEntity::Kind::node && gives_pictures(entity) &&
          !counterparts_.knows(entity.id.value))
        drawing_.insert(entity.name.value);
    }
    if (drawing_.empty()) return;
    find_shown();
    for (const auto& name : drawing_) note_node(*saved_.find(name));
    std::erase_if(saved_.links, [&](const SavedLink& link) { return is_removed(link); });
    for (const std::string& port : unused_) left_out_.push_back(port);
    std::erase_if(saved_.entities,
                  [&](const SavedEntity& entity) { return drawing_.contains(entity.name.value); });
    diagnostics_.note(place_, fmt::format("left out, as {} only for pictures: {}",
                                          left_out_.size() == 1 ? "it is" : "they are",
                                          fmt::join(left_out_, ", ")));
  }

 private:
  static bool is_for_display(const SavedEntity& entity) {
    return std::ranges::find(kDrawing, entity.id.value) != kDrawing.end();
  }

  static bool gives_pictures(const SavedEntity& entity) {
    const auto& outputs = entity.selected.at("outputs");
    return !outputs.empty() && std::ranges::all_of(outputs, [&](const auto& name) {
      const SavedPort* port = entity.port("outputs", name.value);
      return port != nullptr && is_picture(*port);
    });
  }

  /// Against the flow from what shows pictures to the object that they are of.
  void find_shown() {
    for (const SavedEntity& entity : saved_.entities) {
      if (!is_for_display(entity)) continue;
      SavedRender render;
      render.span = entity.name.span;
      render.object = object_behind(entity.name.value);
      const YamlValue* rate = entity.parameter("rate");
      const auto rate_hz = rate != nullptr ? meant_number(*rate) : std::nullopt;
      if (rate_hz && *rate_hz > Rational(0)) render.rate = {*rate_hz, rate->span};
      if (!render.object.empty()) saved_.render = render;
      return;
    }
  }

  /// Empty if there is none.
  [[nodiscard]] std::string object_behind(std::string name) const {
    for (std::size_t step = 0; step <= saved_.entities.size(); ++step) {
      const auto link = std::ranges::find_if(saved_.links, [&](const SavedLink& candidate) {
        return candidate.to.entity == name && is_from_picture(candidate);
      });
      if (link == saved_.links.end()) return {};
      name = link->from.entity;
      if (const SavedObject* object = saved_.owner_of(name)) return object->name.value;
      const SavedEntity* entity = saved_.find(name);
      if (entity != nullptr && entity->kind == SavedEntity::Kind::object) return name;
    }
    return {};
  }

  [[nodiscard]] bool is_from_picture(const SavedLink& link) const {
    const SavedEntity* entity = saved_.find(link.from.entity);
    const SavedPort* port =
        entity != nullptr ? entity->port(link.from.section, link.from.port) : nullptr;
    return port != nullptr && is_picture(*port);
  }

  void note_node(const SavedEntity& node) {
    if (left_out_.empty()) place_ = node.name.span;
    left_out_.push_back(fmt::format("the node `{}`", node.name.value));
  }

  bool is_removed(const SavedLink& link) {
    if (drawing_.contains(link.from.entity)) return true;
    if (!drawing_.contains(link.to.entity)) return false;
    for (SavedEntity& source : saved_.entities) {
      if (source.name.value != link.from.entity) continue;
      const SavedPort* port = source.port(link.from.section, link.from.port);
      if (port == nullptr || !is_picture(*port)) continue;
      unused_.insert(fmt::format("`{}.{}`", link.from.entity, link.from.port));
      std::erase_if(source.selected[link.from.section],
                    [&](const auto& name) { return name.value == link.from.port; });
    }
    return true;
  }

  SavedGraph& saved_;
  const Counterparts& counterparts_;
  Diagnostics& diagnostics_;
  std::set<std::string> drawing_, unused_;
  std::vector<std::string> left_out_;
  Span place_;
};

}  // namespace

void remove_pictures(SavedGraph& saved, const Counterparts& counterparts,
                     Diagnostics& diagnostics) {
  PictureRemover(saved, counterparts, diagnostics).run();
}

}  // namespace eagerx::gen

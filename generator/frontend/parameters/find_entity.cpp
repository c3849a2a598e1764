// Finds an entity by its id, and the implementation of an object on an engine.
#include <fmt/format.h>

#include "generator/frontend/library/other_names.hpp"
#include "generator/frontend/parameters/config.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

std::string with_article(EntityKind kind) {
  const std::string_view name = to_string(kind);
  return fmt::format("{} {}", name.front() == 'e' || name.front() == 'o' ? "an" : "a", name);
}

}  // namespace

const Entity* find_entity(const Library& library, const Spanned<std::string>& id, EntityKind kind,
                          Diagnostics& diagnostics, const std::string& instead) {
  if (id.value.empty()) return nullptr;  // reported when the graph was read
  const Entity* entity = library.find(id.value);
  if (entity != nullptr && entity->kind == kind) return entity;
  if (entity != nullptr) {
    auto& problem = diagnostics.error("E0304", id.span,
                                      fmt::format("`{}` is {}, not {}", id.value,
                                                  with_article(entity->kind), with_article(kind)));
    problem.notes.push_back({"defined here", entity->id.span, ""});
    if (!instead.empty()) {
      problem.help = instead;
    } else if (entity->kind == EntityKind::object && kind == EntityKind::node) {
      problem.help = "objects go under `objects:`";
    } else if (entity->kind == EntityKind::node && kind == EntityKind::object) {
      problem.help = "nodes go under `nodes:`";
    }
    return nullptr;
  }
  auto& problem = diagnostics.error("E0303", id.span,
                                    fmt::format("unknown {} `{}`", to_string(kind), id.value));
  const std::vector<std::string> known = library.ids(kind);
  const std::vector<std::string> family = library.engines_of_family(id.value);
  if (kind == EntityKind::engine && !family.empty()) {
    problem.help =
        fmt::format("`{}` is a family of engines: choose {}", id.value, join(family, " or "));
    return nullptr;
  }
  const std::string near = nearest(id.value, known);
  const std::string other = meant_by_other_name(id.value, known);
  constexpr std::size_t kMostListed = 8;
  if (!near.empty()) {
    problem.help = meaning(near);
  } else if (!other.empty()) {
    problem.help = other;
  } else if (!known.empty() && known.size() <= kMostListed) {
    problem.help = fmt::format("available: {}; add your own folders with `library:` or `--path`",
                               join(known, ", "));
  } else {
    problem.help =
        "`eagerx-gen info` lists all entities; add your own folders with `library:` or "
        "`--path`";
  }
  return nullptr;
}

const ObjectEngine* find_implementation(const Library& library, const Entity& entity,
                                        const Entity& engine, Span span, Diagnostics& diagnostics,
                                        const std::string& instead) {
  if (const ObjectEngine* found = entity.implementation(engine)) return found;
  std::vector<std::string> known;
  for (const auto& id : library.ids(EntityKind::engine)) {
    if (entity.implementation(*library.find(id)) != nullptr) known.push_back(id);
  }
  auto& problem = diagnostics.error(
      "E0308", span,
      fmt::format("`{}` is not implemented for `{}`", entity.id.value, engine.id.value));
  problem.help = !instead.empty() ? instead
                 : known.empty()  ? "it has no implementation for any engine"
                                  : fmt::format("it is made for {}", join(known, ", "));
  return nullptr;
}

}  // namespace eagerx::gen

#include "generator/tools/edit/rename_port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/edit/words.hpp"

namespace eagerx::gen {
namespace {

constexpr std::array kPortLists = {"sensors", "actuators", "inputs",
                                   "outputs", "states",    "targets"};

bool is_port_list(std::string_view key) {
  return ranges::contains(kPortLists, key);
}
std::string_view part(std::string_view text, Bytes place) {
  return text.substr(place.begin, place.end - place.begin);
}

/// The places of `word` in a part of the text where it stands alone.
std::vector<Bytes> words_in(std::string_view text, Bytes within, std::string_view word) {
  std::vector<Bytes> found;
  const std::string_view here = part(text, within);
  for (std::size_t at = here.find(word); at != std::string_view::npos;
       at = here.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter(here[at - 1]);
    if (begins && (end == here.size() || !is_letter(here[end])))
      found.push_back({within.begin + at, within.begin + end});
  }
  return found;
}

/// The place of a key or a word without its quotes.
Bytes unquoted(std::string_view text, Bytes place) {
  const bool is_quoted =
      place.end > place.begin + 1 && (text[place.begin] == '"' || text[place.begin] == '\'');
  return is_quoted ? Bytes{place.begin + 1, place.end - 1} : place;
}

/// Names of `type: id` in the sections of a map.
struct Owner {
  const OutlineEntry* entry;
  std::string name, type;
};
std::vector<Owner> owners_in(const OutlineNode& map) {
  std::vector<Owner> owners;
  for (const char* const section : {"objects", "nodes"}) {
    const OutlineNode* const all = map.find(section);
    if (all == nullptr || all->kind != OutlineNode::Kind::map) continue;
    for (const OutlineEntry& entry : all->entries) {
      const OutlineNode* const type = entry.value.find("type");
      owners.push_back({&entry, entry.key.substr(0, entry.key.find('[')),
                        type != nullptr ? type->text : std::string()});
    }
  }
  return owners;
}

/// Behind `at`, the end of an owner's name: the port of `[0].sensors.theta`, or nothing.
std::optional<Bytes> port_behind(std::string_view text, std::size_t at, std::size_t end) {
  if (at < end && text[at] == '[') at = std::min(text.find(']', at), end - 1) + 1;
  for (int parts = 0; parts < 2; ++parts) {
    if (at >= end || text[at] != '.') return std::nullopt;
    std::size_t last = at + 1;
    while (last < end && is_letter(text[last])) ++last;
    const Bytes place{at + 1, last};
    if (place.begin == place.end) return std::nullopt;
    const bool continues = last < end && text[last] == '.';
    if (!continues || !is_port_list(part(text, place))) return place;
    at = last;
  }
  return std::nullopt;
}

class Finder {
 public:
  explicit Finder(std::string_view text) : text_(text) {}

  /// Calls f(owner, place of the port) for every port of `owners` that is named below `node`.
  template <class F>
  void each_port(const OutlineNode& node, const std::map<std::string_view, const Owner*>& owners,
                 const F& f) const {
    if (node.kind == OutlineNode::Kind::scalar) ports_at(node.place, owners, f);
    for (const OutlineEntry& entry : node.entries) {
      if (!entry.key.empty()) ports_at(entry.key_place, owners, f);
      each_port(entry.value, owners, f);
    }
  }
  /// The same of ports that `map`, an owner, selects or sets.
  template <class F>
  void each_selected(const OutlineNode& map, const F& f) const {
    for (const OutlineEntry& section : map.entries) {
      if (!is_port_list(section.key)) continue;
      for (const OutlineEntry& port : section.value.entries)
        f(unquoted(text_, port.key.empty() ? port.value.place : port.key_place));
    }
  }
  template <class F>
  void whole(const OutlineNode& graph, const F& f) const {
    std::vector<Owner> owners = owners_in(graph);
    std::map<std::string_view, const Owner*> by_name;
    for (const Owner& owner : owners) by_name.emplace(owner.name, &owner);
    each_port(graph, by_name, f);
    for (const Owner& owner : owners)
      each_selected(owner.entry->value, [&](Bytes place) { f(owner, place); });
    const OutlineNode* const variants = graph.find("variants");
    if (variants == nullptr) return;
    for (const OutlineEntry& variant : variants->entries) {
      for (Owner& other : owners_in(variant.value)) {
        const auto known = ranges::find(owners, other.name, &Owner::name);
        if (other.type.empty() && known != owners.end()) other.type = known->type;
        each_selected(other.entry->value, [&](Bytes place) { f(other, place); });
      }
    }
  }

 private:
  template <class F>
  void ports_at(Bytes place, const std::map<std::string_view, const Owner*>& owners,
                const F& f) const {
    const auto is_in_name = [&](std::size_t at) { return is_letter(text_[at]); };
    for (std::size_t at = place.begin; at < place.end;) {
      std::size_t end = at;
      while (end < place.end && is_in_name(end)) ++end;
      const auto owner = owners.find(part(text_, {at, end}));
      const bool is_inner = at > place.begin && text_[at - 1] == '/';
      if (end > at && owner != owners.end() && !is_inner) {
        if (const auto port = port_behind(text_, end, place.end)) f(*owner->second, *port);
      }
      at = std::max(end, at + 1);
    }
  }

  std::string_view text_;
};

void sort_once(std::vector<Bytes>& places) {
  std::ranges::sort(places, std::less{}, &Bytes::begin);
  // Clang 14 does not know std::ranges::unique of libstdc++ 12.
  places.erase(std::unique(places.begin(), places.end(),
                           [](const Bytes& a, const Bytes& b) { return a.begin == b.begin; }),
               places.end());
}

/// Where a manifest names port `port` of its own entity.
class OwnManifest {
 public:
  OwnManifest(std::string_view text, const std::string& port) : text_(text), port_(port) {}

  std::vector<Bytes> all(const OutlineNode& top) {
    for (const OutlineEntry& entry : top.entries) {
      if (is_port_list(entry.key)) {
        declared(entry.value);
      } else if (entry.key == "requires") {
        each_scalar(entry.value, [&](Bytes place) { add_words(place); });
      } else if (entry.key == "vectorized") {
        add_words(entry.value.place);
      } else if (entry.key == "engines" || entry.key == "connections" || entry.key == "nodes") {
        implementation(entry.value);
      } else if (entry.key == "states") {
        keys(entry.value);
      }
    }
    return std::move(found_);
  }

 private:
  template <class F>
  void each_scalar(const OutlineNode& node, const F& f) {
    if (node.kind == OutlineNode::Kind::scalar) f(node.place);
    for (const OutlineEntry& entry : node.entries) each_scalar(entry.value, f);
  }
  void add_words(Bytes place) {
    for (const Bytes& word : words_in(text_, place, port_)) found_.push_back(word);
  }
  void keys(const OutlineNode& map) {
    for (const OutlineEntry& entry : map.entries) {
      if (entry.key == port_) found_.push_back(unquoted(text_, entry.key_place));
    }
  }
  void declared(const OutlineNode& ports) {
    keys(ports);
    for (const OutlineEntry& port : ports.entries) {
      const OutlineNode* const space = port.value.find("space");
      const OutlineNode* const like = space != nullptr ? space->find("like") : nullptr;
      if (like != nullptr && like->text == port_) found_.push_back(unquoted(text_, like->place));
    }
  }
  /// `sensors.theta` in connections, `$(sensors theta rate)`, `$(safe u)`, and states by name.
  void implementation(const OutlineNode& node) {
    each_scalar(node, [&](Bytes place) {
      for (const Bytes& word : words_in(text_, place, port_)) {
        const std::string_view before = part(text_, {place.begin, word.begin});
        const bool is_named = ranges::any_of(kPortLists, [&](std::string_view section) {
          return before.ends_with(fmt::format("{}.", section)) ||
                 before.ends_with(fmt::format("({} ", section));
        });
        if (is_named || before.ends_with("(safe ")) found_.push_back(word);
      }
    });
    for (const OutlineEntry& engine : node.entries) {
      if (const OutlineNode* const states = engine.value.find("states")) keys(*states);
    }
  }

  std::string_view text_;
  const std::string& port_;
  std::vector<Bytes> found_;
};

}  // namespace

std::optional<PortUse> port_in_graph(std::string_view text, std::size_t at) {
  const OutlineNode top = outline_of(text);
  std::optional<PortUse> found;
  Finder(text).whole(top, [&](const Owner& owner, Bytes place) {
    if (place.begin <= at && at <= place.end)
      found = PortUse{owner.name, owner.type, std::string(part(text, place)), place};
  });
  return found;
}

std::optional<PortUse> port_in_manifest(std::string_view text, std::size_t at) {
  const OutlineNode top = outline_of(text);
  std::optional<PortUse> found;
  Finder(text).each_selected(top, [&](Bytes place) {
    if (place.begin <= at && at <= place.end)
      found = PortUse{{}, text_at(top, "id"), std::string(part(text, place)), place};
  });
  return found;
}

std::vector<Bytes> uses_of_port(std::string_view graph, const std::string& id,
                                const std::string& port) {
  std::vector<Bytes> found;
  Finder(graph).whole(outline_of(graph), [&](const Owner& owner, Bytes place) {
    if (owner.type == id && part(graph, place) == port) found.push_back(place);
  });
  sort_once(found);
  return found;
}

std::vector<Bytes> uses_of_port_in_manifest(std::string_view manifest, const std::string& id,
                                            const std::string& port) {
  const OutlineNode top = outline_of(manifest);
  std::vector<Bytes> found;
  if (text_at(top, "id") == id || text_at(top, "object") == id)
    found = OwnManifest(manifest, port).all(top);
  const auto inside = [&](const OutlineNode& scope) {
    Finder(manifest).whole(scope, [&](const Owner& owner, Bytes place) {
      if (owner.type == id && part(manifest, place) == port) found.push_back(place);
    });
  };
  inside(top);  // an implementation
  if (const OutlineNode* const graph = top.find("graph")) inside(*graph);
  if (const OutlineNode* const engines = top.find("engines")) {
    for (const OutlineEntry& engine : engines->entries) inside(engine.value);
  }
  sort_once(found);
  return found;
}

std::vector<Bytes> uses_of_port_in_header(std::string_view header, const std::string& port) {
  constexpr std::array kBefore = {"in.",      "out.",      "inputs.",  "outputs.", "states.",
                                  "Inputs::", "Outputs::", "States::", "targets.", "Targets::"};
  std::vector<Bytes> found;
  for (const Bytes& word : words_in(header, {0, header.size()}, port)) {
    const std::string_view before = header.substr(0, word.begin);
    const bool is_member = ranges::any_of(kBefore, [&](std::string_view way) {
      return before.ends_with(way) &&
             (before.size() == way.size() || !is_letter(before[before.size() - way.size() - 1]));
    });
    if (is_member) found.push_back(word);
  }
  return found;
}

std::string why_no_port(std::string_view manifest, const std::string& from, const std::string& to) {
  if (to.empty() || std::isalpha(static_cast<unsigned char>(to[0])) == 0 ||
      !ranges::all_of(to, is_letter))
    return fmt::format("`{}` cannot be the name of a port", to);
  const OutlineNode top = outline_of(manifest);
  int meanings = 0;
  for (const OutlineEntry& section : top.entries) {
    if (!is_port_list(section.key) && section.key != "config") continue;
    for (const OutlineEntry& each : section.value.entries) {
      if (each.key == to) return fmt::format("`{}` is taken: `{}:` has it", to, section.key);
      if (each.key == from) ++meanings;
    }
  }
  if (meanings == 0) return fmt::format("the manifest has no port `{}`", from);
  return meanings == 1
             ? std::string()
             : fmt::format("the manifest has `{}` for more than one thing: rename it by hand",
                           from);
}

}  // namespace eagerx::gen

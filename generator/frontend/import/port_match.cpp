#include "generator/frontend/import/port_match.hpp"

#include <algorithm>
#include <functional>

#include "generator/frontend/import/entity_mapping.hpp"
#include "generator/frontend/import/translate.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// A port of an engine node that may stand for a sensor or an actuator.
struct Candidate {
  InsidePort place;
  const SavedEntity* node;
  const SavedPort* port;
  bool used;  // connected to something outside of the object
};

bool same_numbers(const std::optional<YamlValue>& a, const std::optional<YamlValue>& b) {
  return a && b ? same_value(*a, *b) : a.has_value() == b.has_value();
}

/// EAGERx gives the port of the engine node the space of what it stands for.
bool same_interface(const Candidate& candidate, const SavedPort& port) {
  const YamlValue* rate = candidate.node->parameter("rate");
  const YamlValue* wanted = port.find("rate");
  if (rate != nullptr && wanted != nullptr && !same_value(*rate, *wanted)) return false;
  if (candidate.port == nullptr) return false;
  const auto a = saved_space(*candidate.port), b = saved_space(port);
  if (!a || !b) return false;
  const bool dtype = !a->dtype || !b->dtype || a->dtype->value == b->dtype->value;
  return dtype && same_numbers(a->low, b->low) && same_numbers(a->high, b->high) &&
         (!a->shape || !b->shape || same_value(*a->shape, *b->shape));
}

class Matcher {
 public:
  Matcher(const SavedGraph& saved, const SavedObject& object, const SavedEntity& backup)
      : saved_(saved), backup_(backup), prefix_(object.name.value + "/") {}

  PortMatch run() {
    match("sensors", "outputs", result_.sensors);
    match("actuators", "inputs", result_.actuators);
    return std::move(result_);
  }

 private:
  using Matched = std::map<std::string, InsidePort>;
  using Test = std::function<bool(const Candidate&, const SavedPort&)>;

  [[nodiscard]] bool is_inside(const std::string& node) const { return node.starts_with(prefix_); }

  [[nodiscard]] std::vector<Candidate> candidates(const char* section) const {
    const bool outputs = std::string_view(section) == "outputs";
    std::vector<Candidate> result;
    for (const auto& entity : saved_.entities) {
      if (!is_inside(entity.name.value)) continue;
      for (const auto& name : entity.selected.at(section)) {
        bool inside = false, outside = false;
        for (const auto& link : saved_.links) {
          const SavedEnd& here = outputs ? link.from : link.to;
          const SavedEnd& there = outputs ? link.to : link.from;
          if (here.entity != entity.name.value || here.port != name.value) continue;
          (is_inside(there.entity) || there.entity == "engine" ? inside : outside) = true;
        }
        const bool tick = !outputs && name.value == "tick";
        if (tick || (!outputs && inside)) continue;
        result.push_back({{entity.name.value.substr(prefix_.size()), name.value},
                          &entity,
                          entity.port(section, name.value),
                          outside});
      }
    }
    // std::ranges' answers with a view, which clang 14 does not compile with GCC 12's library.
    std::stable_partition(result.begin(), result.end(), [](const Candidate& c) { return c.used; });
    return result;
  }

  void match(const char* section, const char* side, Matched& into) {
    const auto found = backup_.ports.find(section);
    if (found == backup_.ports.end()) return;
    std::vector<Candidate> open = candidates(side);
    std::vector<const SavedPort*> ports;
    for (const auto& port : found->second) ports.push_back(&port);
    std::stable_partition(ports.begin(), ports.end(), [&](const SavedPort* port) {
      return backup_.is_selected(section, port->name.value);
    });
    // The work grows with the third power; no object that a person writes has this many.
    constexpr std::size_t kMost = 200;
    if (std::max(open.size(), ports.size()) > kMost) {
      for (const auto& candidate : open) {
        if (candidate.used) result_.open.push_back(candidate.place);
      }
      return;
    }
    const auto pass = [&](const Test& test) { assign(test, ports, open, into); };
    pass([](const Candidate& c, const SavedPort& p) { return c.place.first == p.name.value; });
    pass([](const Candidate& c, const SavedPort& p) { return c.place.second == p.name.value; });
    pass([](const Candidate& c, const SavedPort& p) {
      return c.place.first.starts_with(p.name.value + "_") && same_interface(c, p);
    });
    // From here on names decide nothing, so only what is in use is looked at.
    std::erase_if(open, [](const Candidate& c) { return !c.used; });
    std::vector<const SavedPort*> others;
    std::erase_if(ports, [&](const SavedPort* port) {
      const bool selected = backup_.is_selected(section, port->name.value);
      if (!selected) others.push_back(port);
      return !selected;
    });
    pass(same_interface);
    pass([](const Candidate&, const SavedPort&) { return true; });
    assign(same_interface, others, open, into);
    for (const auto& candidate : open) result_.open.push_back(candidate.place);
  }

  /// Pairs of which each side has only this one.
  static void assign(const Test& test, std::vector<const SavedPort*>& ports,
                     std::vector<Candidate>& open, Matched& into) {
    for (bool found = true; found;) {
      found = false;
      for (auto port = ports.begin(); port != ports.end() && !found; ++port) {
        const auto fits = [&](const Candidate& c) { return test(c, **port); };
        const auto first = ranges::find_if(open, fits);
        if (first == open.end() || std::ranges::count_if(open, fits) != 1 ||
            std::ranges::count_if(ports, [&](const SavedPort* p) { return test(*first, *p); }) != 1)
          continue;
        into[(*port)->name.value] = first->place;
        open.erase(first);
        ports.erase(port);
        found = true;
        break;
      }
    }
  }

  const SavedGraph& saved_;
  const SavedEntity& backup_;
  const std::string prefix_;
  PortMatch result_;
};

}  // namespace

PortMatch match_ports(const SavedGraph& saved, const SavedObject& object,
                      const SavedEntity& backup) {
  return Matcher(saved, object, backup).run();
}

}  // namespace eagerx::gen

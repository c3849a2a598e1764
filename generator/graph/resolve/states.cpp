#include "generator/graph/resolve/states.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <unordered_map>

#include "generator/graph/resolve/bounds.hpp"
#include "generator/graph/resolve/ports.hpp"
#include "generator/graph/resolve/processors.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class RandomReader {
 public:
  RandomReader(const std::string& name, const Space& space, const RandomSpec& spec,
               Diagnostics& diagnostics)
      : name_(name), space_(space), spec_(spec), diagnostics_(diagnostics) {}

  std::optional<Random> read() {
    Random random;
    random.kind = spec_.kind;
    random.span = spec_.span;
    switch (spec_.kind) {
      case RandomSpec::Kind::value:
        random.first = values(*spec_.first, true);
        break;
      case RandomSpec::Kind::choice:
        for (const auto& item : spec_.first->items) random.choices.push_back(values(item, true));
        break;
      case RandomSpec::Kind::normal:
        random.first = values(*spec_.first, true);
        random.second = values(*spec_.second, false);
        require(
            random.second, [](double std) { return std >= 0.0; }, "`std` must not be negative");
        require(random.first, is_finite, "`mean` must be finite");
        require(random.second, is_finite, "`std` must be finite");
        break;
      case RandomSpec::Kind::uniform:
      case RandomSpec::Kind::log_uniform:
        read_range(random);
        break;
    }
    return good_ ? std::optional<Random>(std::move(random)) : std::nullopt;
  }

 private:
  std::vector<double> values(const YamlValue& yaml, bool in_space) {
    auto result = numbers_of(yaml, diagnostics_);
    if (!result || !are_exact_as_doubles(yaml, space_.dtype, "E0327", diagnostics_)) {
      good_ = false;
      return {};
    }
    const std::uint64_t size = space_.size();
    // A list is one of all elements: `[0.1]` for two of them is hardly meant to be both.
    if (yaml.is_scalar()) result->assign(size, result->front());
    if (result->size() != size) return wrong_size(yaml, result->size());
    const bool fraction = !is_floating(space_.dtype) &&
                          ranges::any_of(*result, [](double v) { return v != std::trunc(v); });
    if (fraction)
      return fail("E0327", yaml.span,
                  fmt::format("`{}` is {} and takes whole numbers", name_, space_.describe()));
    for (std::size_t i = 0; in_space && i < size; ++i) {
      const double value = rounded(space_, (*result)[i]);
      const double low = rounded(space_, bound_of(space_.low, i, lowest_of(space_.dtype)));
      const double high = rounded(space_, bound_of(space_.high, i, highest_of(space_.dtype)));
      if (value >= low && value <= high) continue;
      const Span place =
          yaml.is_sequence() && i < yaml.items.size() ? yaml.items[i].span : yaml.span;
      const std::string what =
          size == 1 ? fmt::format("`{}`", name_) : fmt::format("element {} of `{}`", i, name_);
      return fail("E0327", place,
                  space_.high.empty()
                      ? fmt::format("{} must be at least {}", what, shown(low))
                      : fmt::format("{} must be from {} to {}", what, shown(low), shown(high)));
    }
    return *result;
  }

  std::vector<double> wrong_size(const YamlValue& yaml, std::size_t found) {
    const std::uint64_t size = space_.size();
    auto& problem = diagnostics_.error(
        "E0327", yaml.span,
        fmt::format("`{}` is {} and takes {}, found {}", name_, space_.describe(),
                    size == 1 ? "one value" : fmt::format("one value or {}", size),
                    found == 1 ? "a list of one" : fmt::format("{} values", found)));
    if (found == 1)
      problem.help =
          fmt::format("write the number without brackets if all {} are to have it", size);
    good_ = false;
    return {};
  }

  void read_range(Random& random) {
    if (spec_.first) {
      random.first = values(*spec_.first, true);
      random.second = values(*spec_.second, true);
    } else if (space_.dtype == Dtype::boolean) {
      random.first.assign(space_.size(), 0.0);
      random.second.assign(space_.size(), 1.0);
    } else if (space_.low.empty() || space_.high.empty()) {
      fail("E0327", spec_.span, "the space of this state has no bounds to sample from",
           "give a range: `{uniform: {low: -1.0, high: 1.0}}`");
      return;
    } else {
      for (std::size_t i = 0; i < space_.size(); ++i) {
        random.first.push_back(bound_of(space_.low, i, 0.0));
        random.second.push_back(bound_of(space_.high, i, 0.0));
      }
    }
    for (std::size_t i = 0; good_ && i < random.first.size(); ++i) {
      if (!std::isfinite(random.first[i]) || !std::isfinite(random.second[i])) {
        fail("E0327", spec_.span, "a range to sample from must be finite");
      } else if (random.first[i] > random.second[i]) {
        fail("E0327", spec_.span,
             fmt::format("`low` ({}) is above `high` ({})", random.first[i], random.second[i]));
      }
    }
    if (spec_.kind != RandomSpec::Kind::log_uniform) return;
    require(
        random.first, [](double low) { return low > 0.0; }, "a log-uniform range begins above 0");
  }

  static bool is_finite(double number) { return std::isfinite(number); }

  template <class Test>
  void require(const std::vector<double>& numbers, Test&& test, const char* message) {
    if (good_ && !ranges::all_of(numbers, test)) fail("E0327", spec_.span, message);
  }

  /// A bound as it was written: float32(3.14) is shown as 3.14.
  [[nodiscard]] std::string shown(double bound) const {
    return space_.dtype == Dtype::float32 ? fmt::format("{}", static_cast<float>(bound))
                                          : fmt::format("{}", bound);
  }

  std::vector<double> fail(const char* code, Span span, std::string message,
                           std::string help = "") {
    diagnostics_.error(code, span, std::move(message)).help = std::move(help);
    good_ = false;
    return {};
  }

  const std::string& name_;
  const Space& space_;
  const RandomSpec& spec_;
  Diagnostics& diagnostics_;
  bool good_ = true;
};

}  // namespace

std::optional<Random> read_random(const std::string& name, const Space& space,
                                  const RandomSpec& spec, Diagnostics& diagnostics) {
  return RandomReader(name, space, spec, diagnostics).read();
}

namespace {

std::optional<Space> state_space(const PortManifest& port, const References& references,
                                 Diagnostics& diagnostics) {
  const PartialSpace partial = partial_space(port.space, references, diagnostics);
  if (!partial.dtype || !partial.shape) {
    // It is of a parameter that is wrong, or missing, which has been said.
    if (port.space.dtype && port.space.shape && diagnostics.has_errors()) return std::nullopt;
    diagnostics
        .error("E0312", port.name.span,
               fmt::format("the space of the state `{}` is not known", port.name.value))
        .help = "give its dtype and shape in the manifest";
    return std::nullopt;
  }
  auto space = complete(partial);
  const Span place = place_of_bounds(partial, port.name.span);
  return check_bounds(*space, place, diagnostics) ? std::move(space) : std::nullopt;
}

/// The states that the user named, each with its space and how it is sampled.
std::vector<State> read_states(UnresolvedGraph& draft, const Entity& entity,
                               const EntitySpec& spec) {
  Diagnostics& diagnostics = draft.diagnostics;
  std::vector<State> result;
  const References references = references_of(entity, spec.config);
  for (const auto& state_spec : spec.states) {
    const PortManifest* port = entity.state(state_spec.name.value);
    if (port == nullptr) {
      diagnostics
          .error("E0307", state_spec.name.span,
                 fmt::format("`{}` has no state `{}`", entity.id.value, state_spec.name.value))
          .help = suggestion(state_spec.name.value, names_of(entity.states), "it has no states");
      continue;
    }
    auto space = state_space(*port, references, diagnostics);
    if (!space) continue;
    bool bounded = true;
    if (state_spec.space) {
      const PartialSpace own = partial_space(*state_spec.space, {}, diagnostics);
      space = complete(narrow(partial_of(*space), own, state_spec.name.value, diagnostics));
      bounded = check_bounds(*space, place_of_bounds(own, own.span), diagnostics);
    }
    State state;
    state.name = state_spec.name.value;
    state.space = *space;
    state.span = state_spec.name.span;
    state.tunes_running = port->tunes_running;
    if (state_spec.random && bounded)
      state.random = read_random(state.name, *space, *state_spec.random, diagnostics);
    if (state_spec.processor && bounded)
      state.processor = make_processor(draft, *state_spec.processor, *space, port->name.span);
    result.push_back(std::move(state));
  }
  return result;
}

/// The class of a node has a member for each of its states, also for those that the graph leaves
/// alone. Tunable parameters are then the constants that they were.
void add_unnamed_states(GraphNode& node, const std::vector<Setting>& config,
                        Diagnostics& diagnostics) {
  for (const auto& port : node.entity->states) {
    if (port.optional || find_named(node.states, port.name.value) != nullptr) continue;
    const auto space = state_space(port, references_of(*node.entity, config), diagnostics);
    if (!space) continue;
    State state;
    state.name = port.name.value;
    state.space = *space;
    state.settable = false;
    state.span = port.name.span;
    node.states.push_back(std::move(state));
  }
}

/// A state of an object that is one of an engine node moves there. False if it is none.
bool move_to_node(UnresolvedGraph& draft, const Object& object, State& state) {
  const NodeState* found = find_named(object.implementation->node_states, state.name);
  if (found == nullptr) return false;
  const PortName port = parse_port(found->node.value);
  const std::string owner = object.name + "/" + port.owner;
  const std::string name = port.within_owner();
  for (auto& node : draft.nodes) {
    if (node.node.name != owner) continue;
    for (auto& own : node.node.states) {
      if (own.name != name) continue;
      if (own.space.dtype != state.space.dtype || own.space.shape != state.space.shape) {
        draft.diagnostics
            .error("E0306", found->node.span,
                   fmt::format("`{}` is {}, but `{}` of `{}` is {}", found->node.value,
                               own.space.describe(), state.name, object.entity->id.value,
                               state.space.describe()))
            .notes.push_back({"used here", state.span, ""});
      }
      state.name = name;
      own = std::move(state);
      return true;
    }
  }
  draft.diagnostics
      .error("E0308", state.span,
             fmt::format("`{}` has no state `{}` here", object.entity->id.value, state.name))
      .notes.push_back(
          {fmt::format("there is no state `{}` of an engine node in use", found->node.value),
           found->node.span, ""});
  return true;
}

/// Compares the space that an engine state states with its value.
void check_space_of_state(const State& state, const References& references, Span span,
                          Diagnostics& diagnostics) {
  const PortManifest& port = state.engine_state->states.front();
  const PartialSpace declared = partial_space(port.space, references, diagnostics);
  if (fits(declared, state.received())) return;
  const bool dtype = !declared.dtype || *declared.dtype == state.received().dtype;
  auto& problem =
      diagnostics.error(dtype ? "E0306" : "E0305", span,
                        fmt::format("`{}` takes {}, but `{}` is {}", state.engine_state->id.value,
                                    describe(declared), state.name, state.received().describe()));
  problem.notes.push_back({"used here", state.span, ""});
}

void bind_engine_state(UnresolvedGraph& draft, const Object& object, const EntitySpec& spec,
                       State& state) {
  const EntitySpec* found = find_named(object.implementation->states, state.name);
  if (found == nullptr) {
    draft.diagnostics.error("E0308", state.span,
                            fmt::format("`{}` has no state `{}` on `{}`", object.entity->id.value,
                                        state.name, object.implementation->engine.value));
    return;
  }
  state.engine_state =
      find_entity(draft.library, found->type, EntityKind::engine_state, draft.diagnostics);
  if (state.engine_state == nullptr) return;
  const Entity& engine = *draft.engine();
  if (!state.engine_state->works_on(engine))
    report_wrong_engine(*state.engine_state, engine, found->type.span, draft.diagnostics);
  const References references = references_of(*object.entity, spec.config);
  const auto settings = substitute(found->config, references, draft.diagnostics);
  state.config = resolve_config(draft.library, *state.engine_state, settings, found->type.span,
                                draft.diagnostics);
  check_space_of_state(state, references_of(*state.engine_state, settings), found->type.span,
                       draft.diagnostics);
}

/// Finds states that the graph leaves alone. Nothing of it is in the program, so no problem of it
/// is reported.
void find_kept_states(UnresolvedGraph& draft, const EntitySpec& spec, Object& object) {
  Diagnostics unsaid;
  const References references = references_of(*object.entity, spec.config);
  for (const auto& port : object.entity->states) {
    const EntitySpec* found = find_named(object.implementation->states, port.name.value);
    if (found == nullptr || find_named(spec.states, port.name.value) != nullptr) continue;
    const Entity* engine_state = draft.library.find(found->type.value);
    if (engine_state == nullptr || engine_state->kind != EntityKind::engine_state) continue;
    const auto space = state_space(port, references, unsaid);
    const auto settings = substitute(found->config, references, unsaid);
    object.kept.push_back(
        {port.name.value, space && !space->low.empty() && !space->high.empty(), engine_state,
         resolve_config(draft.library, *engine_state, settings, found->type.span, unsaid)});
  }
}

}  // namespace

void resolve_states(UnresolvedGraph& draft) {
  std::unordered_map<std::string_view, const EntitySpec*> specs;
  for (const EntitySpec& each : draft.spec.nodes) specs.try_emplace(each.name.value, &each);
  for (const EntitySpec& each : draft.added) specs.try_emplace(each.name.value, &each);
  for (std::size_t n = 0; n < draft.nodes.size(); ++n) {
    UnresolvedNode& node = draft.nodes[n];
    if (node.node.entity == nullptr || draft.is_added(n)) continue;
    if (node.node.role == NodeRole::engine_node) {
      add_unnamed_states(node.node, {}, draft.diagnostics);
      continue;
    }
    const auto found = specs.find(node.node.name);
    const EntitySpec* const spec = found != specs.end() ? found->second : nullptr;
    const bool engine = node.node.role == NodeRole::engine;
    const bool other_engine = engine && node.node.entity->id.value !=
                                            draft.spec.engine.type.value;  // of the command line
    if (!other_engine) {
      node.node.states = read_states(draft, *node.node.entity, engine ? draft.spec.engine : *spec);
    }
    add_unnamed_states(node.node, engine ? draft.spec.engine.config : spec->config,
                       draft.diagnostics);
  }
  for (std::size_t i = 0; i < draft.graph.objects.size(); ++i) {
    Object& object = draft.graph.objects[i];
    if (object.entity == nullptr || object.implementation == nullptr) continue;
    for (auto& state : read_states(draft, *object.entity, draft.spec.objects[i])) {
      if (move_to_node(draft, object, state)) continue;
      bind_engine_state(draft, object, draft.spec.objects[i], state);
      object.states.push_back(std::move(state));
    }
    find_kept_states(draft, draft.spec.objects[i], object);
  }
}

}  // namespace eagerx::gen

#include "generator/graph/resolve/spaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

#include "generator/graph/resolve/bounds.hpp"
#include "generator/graph/resolve/connect.hpp"
#include "generator/graph/resolve/delays.hpp"
#include "generator/graph/resolve/limits.hpp"
#include "generator/graph/resolve/processors.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class SpaceResolver {
 public:
  explicit SpaceResolver(UnresolvedGraph& draft) : draft_(draft) {
    for (const auto& node : draft.nodes) {
      outputs_.emplace_back(node.outputs.size());
      inputs_.emplace_back(node.inputs.size());
    }
  }

  void run() {
    guess_actions();
    while (sweep()) {
    }
    // Spaces in a loop that are still unknown come from the declarations of its inputs.
    use_declared_ = true;
    while (sweep()) {
    }
    if (!diagnostics().has_errors()) report_unknown();
    if (!diagnostics().has_errors()) fill_graph();
  }

 private:
  /// A port's space once it is known; `settled` also after an error, so that no problem is reported
  /// twice.
  template <class PortType>
  struct Slot {
    std::optional<PortType> port;
    bool settled = false;
  };

  struct SensorView {
    Space space;
    std::optional<Processor> processor;
  };

  Diagnostics& diagnostics() { return draft_.diagnostics; }

  static void prepend(const Processor& first, Processor& second) {
    std::vector<Processor> before = first.before;
    before.push_back(first);
    before.back().before.clear();
    std::ranges::move(second.before, std::back_inserter(before));
    second.before = std::move(before);
  }

  /// An action without a space has that of the first port it is connected to.
  void guess_actions() {
    auto& actions = draft_.nodes[Graph::kEnvironment].outputs;
    for (std::size_t a = 0; a < actions.size(); ++a) {
      PartialSpace& declared = actions[a].declared;
      if (declared.like) {
        take_like(actions[a]);
        continue;
      }
      if (declared.dtype && declared.shape) continue;
      const UnresolvedInput* input = first_sink(a);
      if (input != nullptr && input->outside) {
        declared = overlay(*input->outside, declared);
      } else if (input != nullptr && !input->settings.processor) {
        declared = overlay(input->declared, declared);
      }
    }
  }

  void take_like(UnresolvedOutput& action) {
    PartialSpace& declared = action.declared;
    const std::string port = *declared.like;
    declared.like.reset();
    if (const auto base = declared_space(draft_, port)) {
      const Span like = declared.like_span;
      declared = overlay(*base, declared);
      if (!declared.dtype || !declared.shape) report_no_space(action.name, port, like);
      return;
    }
    if (draft_.erroneous.contains(parse_port(port).owner)) return;
    diagnostics()
        .error("E0309", declared.like_span, fmt::format("`{}` is not an input of this graph", port))
        .help = suggestion(port, written_inputs(), "write the port as in `to:` of a connection");
  }

  /// As a user writes them: a composite's ports instead of those inside; of the owner that `port`
  /// names where it has some.
  [[nodiscard]] std::vector<std::string> written_inputs() const {
    std::vector<std::string> names;
    for (const CompositeSpec& composite : draft_.spec.composites)
      for (const auto& [name, ports] : composite.inputs)
        names.push_back(composite.name + "." + name);
    for (const std::string& name : input_names(draft_))
      if (name.find('/') == std::string::npos && !name.starts_with(std::string(kTask) + ".") &&
          !name.starts_with(std::string(kRender) + "."))
        names.push_back(name);
    return names;
  }

  /// The port of a composite that leads to `port`, as a user writes it; empty: none does.
  [[nodiscard]] std::string port_of_composite(const std::string& port) const {
    for (const CompositeSpec& composite : draft_.spec.composites)
      for (const auto& [name, ports] : composite.inputs)
        if (ranges::contains(ports, port)) return composite.name + "." + name;
    return {};
  }
  /// Actuators of objects, also of those in composites, whose spaces are complete.
  [[nodiscard]] std::vector<std::string> known_actuators() const {
    std::vector<std::string> names;
    for (const std::string& name : input_names(draft_)) {
      const bool is_of_object = draft_.find_object(parse_port(name).owner) != nullptr;
      const auto space = is_of_object ? declared_space(draft_, name) : std::nullopt;
      if (space && space->dtype && space->shape) names.push_back(name);
    }
    return names;
  }

  /// Inputs of most nodes take any space, and so does a composite's port that leads to one.
  void report_no_space(const std::string& action, const std::string& port, Span like) {
    const std::string written = port_of_composite(port);
    const std::vector<std::string> actuators = known_actuators();
    auto& problem = diagnostics().error(
        "E0312", like,
        written.empty()
            ? fmt::format("`{}` takes any space, so `{}` gets none from it", port, action)
            : fmt::format("`{}` leads to `{}`, which takes any space, so `{}` gets none from it",
                          written, port, action));
    problem.help = fmt::format(
        "write it: `{}: {{space: {{dtype: float32, shape: [1], low: …, high: …}}}}`{}", action,
        actuators.empty() ? ""
                          : fmt::format(", or take that of an actuator: `like: {}`",
                                        join(actuators, "`, `like: ")));
  }

  const UnresolvedInput* first_sink(std::size_t action) const {
    const auto place = [](const UnresolvedInput& input) {
      return std::tuple(input.edge->span.line, input.edge->span.column);
    };
    const UnresolvedInput* first = nullptr;
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      if (draft_.is_added(n)) continue;  // it takes whatever comes
      for (const auto& input : draft_.nodes[n].inputs) {
        if (!input.edge || input.edge->node != Graph::kEnvironment || input.edge->output != action)
          continue;
        if (first == nullptr || place(input) < place(*first)) first = &input;
      }
    }
    return first;
  }

  /// Resolves what can be resolved; true if there was something new.
  bool sweep() {
    bool news = false;
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      UnresolvedNode& node = draft_.nodes[n];
      for (std::size_t i = 0; i < node.inputs.size(); ++i) news = resolve_input(n, i) || news;
      for (std::size_t o = 0; o < node.outputs.size(); ++o) news = resolve_output(n, o) || news;
    }
    for (const auto& object : draft_.objects) {
      for (const auto& [name, sensor] : object.sensors) news = resolve_sensor(sensor) || news;
    }
    return news;
  }

  /// Resolves the messages of a sensor's readers, once those of its output are known.
  bool resolve_sensor(const UnresolvedSensor& draft) {
    Slot<SensorView>& slot = sensors_[draft.written];
    const auto& source = outputs_[draft.output.node][draft.output.port].port;
    if (slot.settled || !source) return false;
    slot.settled = true;
    SensorView view{source->space, std::nullopt};
    if (!set_bounds(view.space, draft.taken)) return true;
    if (draft.processor) {
      view.processor =
          make_processor(draft_, *draft.processor, view.space, draft.processor->type.span);
      if (!view.processor) return true;
      view.space = view.processor->output;
      if (!publishes(draft.written, draft.space, *view.processor, draft.of_connection)) return true;
      if (!check_limits(*view.processor, diagnostics())) return true;
      if (!set_bounds(view.space, draft.space)) return true;
    }
    slot.port = std::move(view);
    return true;
  }

  bool set_bounds(Space& space, const PartialSpace& written) {
    if (!written.low.empty()) space.low = written.low;
    if (!written.high.empty()) space.high = written.high;
    return check_bounds(space, place_of_bounds(written, written.span), diagnostics());
  }

  bool resolve_output(std::size_t n, std::size_t o) {
    Slot<Output>& slot = outputs_[n][o];
    if (slot.settled) return false;
    UnresolvedOutput& draft = draft_.nodes[n].outputs[o];
    const auto declared = with_like(n, draft, slot);
    const auto raw = declared ? complete(*declared) : std::nullopt;
    if (!raw) return false;
    slot.settled = true;
    Output output{draft.name, draft.sensors, *raw, *raw, std::nullopt, draft.span, draft.converted};
    if (!check_bounds(*raw, place_of_bounds(*declared, draft.declared.span), diagnostics()))
      return true;
    if (draft.processor) {
      output.processor = make_processor(draft_, *draft.processor, *raw, draft.span);
      if (!output.processor) return true;
      output.space = output.processor->output;
      const std::string& written = draft.of_connection ? draft.sensors.front() : draft.name;
      if (!publishes(written, draft.published, *output.processor, draft.of_connection)) return true;
      if (!set_bounds(output.space, draft.published)) return true;
    }
    slot.port = std::move(output);
    return true;
  }

  /// The processor of an output or a sensor must give messages of the stated space. A connection's
  /// is wrong itself; elsewhere it stands next to the space.
  bool publishes(const std::string& written, const PartialSpace& said, const Processor& processor,
                 bool of_connection) {
    if (fits(said, processor.output)) return true;
    if (of_connection) {
      diagnostics()
          .error("E0306", processor.span,
                 fmt::format("`{}` gives {}, but `{}` is {}", processor.entity->id.value,
                             processor.output.describe(), written, describe(said)))
          .notes.push_back({fmt::format("the space of `{}`", written), said.span, ""});
    } else {
      diagnostics()
          .error("E0306", said.span,
                 fmt::format("`{}` is {} here, but its processor gives {}", written, describe(said),
                             processor.output.describe()))
          .notes.push_back({"the processor", processor.span, ""});
    }
    return false;
  }

  /// The declared space with what it takes from an input of the same node; nullopt while that is
  /// not known.
  std::optional<PartialSpace> with_like(std::size_t n, const UnresolvedOutput& draft,
                                        Slot<Output>& slot) {
    if (!draft.declared.like || n == Graph::kEnvironment) return draft.declared;
    UnresolvedNode& node = draft_.nodes[n];
    const UnresolvedInput* input = node.input(*draft.declared.like);
    if (input == nullptr) {
      slot.settled = true;
      const std::string name = node.node.name + "." + draft.name;
      if (!draft_.is_doubtful(node)) {
        diagnostics()
            .error("E0309", draft.span,
                   fmt::format("`{}` has the space of the input `{}`, which is not there", name,
                               *draft.declared.like))
            .help = "select that input too";
      }
      return std::nullopt;
    }
    const auto& resolved = inputs_[n][static_cast<std::size_t>(input - node.inputs.data())];
    if (resolved.port) return overlay(partial_of(resolved.port->space), draft.declared);
    if (use_declared_ && !resolved.settled) return overlay(input->declared, draft.declared);
    return std::nullopt;
  }

  bool resolve_input(std::size_t n, std::size_t i) {
    Slot<Input>& slot = inputs_[n][i];
    const UnresolvedInput& draft = draft_.nodes[n].inputs[i];
    if (slot.settled || !draft.edge) return false;
    const auto& source = outputs_[draft.edge->node][draft.edge->output].port;
    if (!source) return false;
    if (!draft.sensor.empty() && !sensors_[draft.sensor].settled) return false;
    slot.settled = true;
    if (!draft.sensor.empty() && !sensors_[draft.sensor].port) return true;
    const bool original = draft.sensor.empty() &&
                          draft_.nodes[draft.edge->node].outputs[draft.edge->output].of_sensor;
    const SensorView arriving = !draft.sensor.empty() ? *sensors_[draft.sensor].port
                                : original            ? SensorView{source->raw, {}}
                                                      : SensorView{source->space, {}};
    Input input;
    input.original = original;
    input.name = draft.name;
    input.written = draft.written;
    input.source_node = draft.edge->node;
    input.source_output = draft.edge->output;
    input.window = window_of(draft.settings).value_or(1);
    input.skip = skips(draft.settings);
    input.feedthrough = draft.feedthrough;
    input.actuator = draft.actuator;
    input.span = draft.span;
    resolve_delay(draft_, draft, input);
    input.space = arriving.space;
    if (draft.outside && !fits(*draft.outside, arriving.space)) {
      report_misfit(n, draft, *draft.outside, input);
      return true;
    }
    if (draft.actuator && (draft.outside || !draft.settings.processor)) {
      const PartialSpace& taken = draft.outside ? *draft.outside : draft.declared;
      input.actuator_space = complete(overlay(partial_of(arriving.space), taken));
    }
    input.sensor = draft.sensor;
    input.processor = arriving.processor;
    if (input.processor) input.of_sensor = input.processor->stages().size();
    if (draft.settings.processor) {
      input.processor =
          make_processor(draft_, *draft.settings.processor, arriving.space, draft.edge->span);
      if (!input.processor) return true;
      input.space = input.processor->output;
      if (arriving.processor) prepend(*arriving.processor, *input.processor);
    }
    if (!agrees(n, draft, input)) return true;
    // The receiver's own bounds, where it has some, say more about what it takes.
    if (!draft.declared.low.empty()) input.space.low = draft.declared.low;
    if (!draft.declared.high.empty()) input.space.high = draft.declared.high;
    if (!check_bounds(input.space, place_of_bounds(draft.declared, draft.span), diagnostics()))
      return true;
    slot.port = std::move(input);
    return true;
  }

  bool agrees(std::size_t n, const UnresolvedInput& draft, const Input& input) {
    if (fits(draft.declared, input.space)) return true;
    report_misfit(n, draft, draft.declared, input);
    return false;
  }

  void report_misfit(std::size_t n, const UnresolvedInput& draft, const PartialSpace& takes,
                     const Input& input) {
    if (draft_.is_doubtful(draft_.nodes[n]) || draft_.is_doubtful(draft_.nodes[draft.edge->node]))
      return;
    const bool dtype = !takes.dtype || *takes.dtype == input.space.dtype;
    auto& problem = diagnostics().error(dtype ? "E0306" : "E0305", draft.span,
                                        fmt::format("`{}` takes {}, but gets {}", draft.written,
                                                    describe(takes), input.space.describe()));
    problem.label = dtype ? "the shapes differ" : "the dtypes differ";
    if (input.processor) {
      problem.notes.push_back(
          {fmt::format("`{}` gives {}", input.processor->entity->id.value, input.space.describe()),
           input.processor->span, ""});
      return;
    }
    problem.notes.push_back({"it comes from here", draft.edge->span, input.space.describe()});
    const auto processors = fitting_processors(draft_.library, takes, input.space);
    problem.help = processors.empty()
                       ? fmt::format("no processor converts it to {}: connect a port that fits",
                                     describe(takes))
                       : fmt::format("add `{}` to the connection", join(processors, "` or `"));
    constexpr std::string_view kKey = "processor: ";
    for (const std::string& each : processors)
      problem.help.fixes.push_back(add_to_connection("processor", each.substr(kKey.size())));
  }

  /// Everything is connected and no space was refused, so what is missing was never written.
  void report_unknown() {
    const std::size_t errors_before = diagnostics().error_count();
    for (const bool roots : {true, false}) {
      for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
        for (std::size_t o = 0; o < draft_.nodes[n].outputs.size(); ++o) {
          const UnresolvedOutput& output = draft_.nodes[n].outputs[o];
          const bool root = !output.declared.like || n == Graph::kEnvironment;
          if (outputs_[n][o].port || root != roots) continue;
          report_unknown(n, output);
          if (!root) return;  // one of a loop is enough
        }
      }
      if (diagnostics().error_count() != errors_before) return;  // the others follow from these
    }
  }

  void report_unknown(std::size_t n, const UnresolvedOutput& output) {
    const UnresolvedNode& node = draft_.nodes[n];
    const bool action = n == Graph::kEnvironment;
    auto& problem =
        diagnostics().error("E0312", output.span,
                            fmt::format("the space of `{}.{}` is not known",
                                        action ? "actions" : node.node.name, output.name));
    if (action) {
      problem.help = fmt::format(
          "write it: `actions: {{{}: {{space: {{like: object.actuator}}}}}}`, or with dtype, "
          "shape, low and high",
          output.name);
    } else if (output.declared.like) {
      problem.help = fmt::format(
          "it has the space of its input `{0}`, which depends on this output: write `inputs: "
          "{{{0}: "
          "{{space: {{dtype: …, shape: …}}}}}}`",
          *output.declared.like);
    } else {
      problem.help = fmt::format("write it: `outputs: {{{}: {{space: {{dtype: …, shape: …}}}}}}`",
                                 output.name);
    }
  }

  void fill_graph() {
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      UnresolvedNode& draft = draft_.nodes[n];
      for (auto& slot : inputs_[n]) draft.node.inputs.push_back(std::move(*slot.port));
      for (auto& slot : outputs_[n]) draft.node.outputs.push_back(std::move(*slot.port));
      draft_.graph.nodes.push_back(std::move(draft.node));
    }
  }

  UnresolvedGraph& draft_;
  std::vector<std::vector<Slot<Output>>> outputs_;
  std::vector<std::vector<Slot<Input>>> inputs_;
  std::map<std::string, Slot<SensorView>> sensors_;
  bool use_declared_ = false;
};

}  // namespace

void resolve_spaces(UnresolvedGraph& draft) {
  SpaceResolver(draft).run();
}

}  // namespace eagerx::gen

// Spaces flow from outputs to inputs until every port knows its own; then both ends are compared.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "generator/resolve/draft.hpp"

namespace eagerx::gen {
namespace {

std::optional<Space> complete(const PartialSpace& partial) {
  if (!partial.dtype || !partial.shape) return std::nullopt;
  return Space{*partial.dtype, *partial.shape, partial.low, partial.high};
}

PartialSpace partial_of(const Space& space) {
  PartialSpace partial;
  partial.dtype = space.dtype;
  partial.shape = space.shape;
  partial.low = space.low;
  partial.high = space.high;
  return partial;
}

std::string describe(const PartialSpace& partial) {
  std::string result = partial.dtype ? std::string(to_string(*partial.dtype)) : "any dtype";
  return result + (partial.shape ? fmt::format(" [{}]", fmt::join(*partial.shape, ", ")) : ", any shape");
}

class SpaceResolver {
 public:
  explicit SpaceResolver(Draft& draft) : draft_(draft) {
    for (const auto& node : draft.nodes) {
      outputs_.emplace_back(node.outputs.size());
      inputs_.emplace_back(node.inputs.size());
    }
  }

  void run() {
    guess_actions();
    while (!failed_ && sweep()) {
    }
    if (!failed_) report_unknown();
    if (!draft_.diagnostics.has_errors()) fill_graph();
  }

 private:
  Diagnostics& diagnostics() { return draft_.diagnostics; }

  /// An action without a space has that of the first port it is connected to.
  void guess_actions() {
    auto& actions = draft_.nodes[Graph::kEnvironment].outputs;
    for (std::size_t a = 0; a < actions.size(); ++a) {
      PartialSpace& declared = actions[a].declared;
      if (declared.like) {
        if (const DraftInput* input = find_like(*declared.like)) {
          PartialSpace base = input->declared;
          declared.like.reset();
          declared = overlay(base, declared);
        } else {
          diagnostics().error("E0309", declared.span, fmt::format("`like: {}` names no input", *declared.like)).help =
              "write the port as in `to:` of a connection";
          failed_ = true;
        }
        continue;
      }
      if (declared.dtype && declared.shape) continue;
      if (const DraftInput* input = first_target(a); input != nullptr && !input->settings.processor) {
        declared = overlay(input->declared, declared);
      }
    }
  }

  const DraftInput* find_like(const std::string& port) {
    // The connection that ends in this port has already found the input: take it from there.
    for (const auto& connection : draft_.spec.connections) {
      if (connection.to.value != port) continue;
      for (const auto& node : draft_.nodes) {
        for (const auto& input : node.inputs) {
          const Span& a = input.span;
          const Span& b = connection.to.span;
          if (input.edge && a.file == b.file && a.line == b.line && a.column == b.column) return &input;
        }
      }
    }
    return nullptr;
  }

  const DraftInput* first_target(std::size_t action) const {
    const DraftInput* first = nullptr;
    for (const auto& node : draft_.nodes) {
      for (const auto& input : node.inputs) {
        if (!input.edge || input.edge->node != Graph::kEnvironment || input.edge->output != action) continue;
        const bool earlier = first == nullptr || input.edge->span.line < first->edge->span.line;
        if (earlier) first = &input;
      }
    }
    return first;
  }

  /// Resolves what can be resolved; true if there was something new.
  bool sweep() {
    bool news = false;
    for (std::size_t n = 0; n < draft_.nodes.size() && !failed_; ++n) {
      DraftNode& node = draft_.nodes[n];
      for (std::size_t i = 0; i < node.inputs.size(); ++i) news = resolve_input(n, i) || news;
      for (std::size_t o = 0; o < node.outputs.size(); ++o) news = resolve_output(n, o) || news;
    }
    return news;
  }

  bool resolve_output(std::size_t n, std::size_t o) {
    std::optional<Output>& done = outputs_[n][o];
    if (done) return false;
    DraftNode& node = draft_.nodes[n];
    DraftOutput& draft = node.outputs[o];
    PartialSpace declared = draft.declared;
    if (declared.like && n != Graph::kEnvironment) {
      const DraftInput* input = node.input(*declared.like);
      if (input == nullptr) return fail("E0309", declared.span, fmt::format("`like: {}` names no input", *declared.like));
      const auto& resolved = inputs_[n][static_cast<std::size_t>(input - node.inputs.data())];
      if (!resolved) return false;
      declared = overlay(partial_of(resolved->space), declared);
    }
    const auto raw = complete(declared);
    if (!raw) return false;
    Output output{draft.name, *raw, *raw, std::nullopt, draft.span};
    if (!check_bounds(*raw, draft.declared.span)) return false;
    if (draft.processor) {
      output.processor = make_processor(*draft.processor, *raw);
      if (!output.processor) return false;
      output.space = output.processor->output;
    }
    done = std::move(output);
    return true;
  }

  bool resolve_input(std::size_t n, std::size_t i) {
    std::optional<Input>& done = inputs_[n][i];
    DraftInput& draft = draft_.nodes[n].inputs[i];
    if (done || !draft.edge) return false;
    const auto& source = outputs_[draft.edge->node][draft.edge->output];
    if (!source) return false;
    Input input;
    input.name = draft.name;
    input.source_node = draft.edge->node;
    input.source_output = draft.edge->output;
    input.window = draft.settings.window.value_or(1);
    input.delay_s = draft.settings.delay_s.value_or(Rational{});
    input.skip = draft.settings.skip.value_or(false);
    input.span = draft.span;
    input.space = source->space;
    if (draft.settings.processor) {
      input.processor = make_processor(*draft.settings.processor, source->space);
      if (!input.processor) return false;
      input.space = input.processor->output;
    }
    if (!agrees(draft, input.space)) return false;
    // The receiver's own bounds, where it has some, say more about what it takes.
    if (!draft.declared.low.empty()) input.space.low = draft.declared.low;
    if (!draft.declared.high.empty()) input.space.high = draft.declared.high;
    if (!check_bounds(input.space, draft.span)) return false;
    done = std::move(input);
    return true;
  }

  bool agrees(const DraftInput& draft, const Space& arriving) {
    const PartialSpace& declared = draft.declared;
    const bool dtype = !declared.dtype || *declared.dtype == arriving.dtype;
    const bool shape = !declared.shape || *declared.shape == arriving.shape;
    if (dtype && shape) return true;
    auto& problem = diagnostics().error(dtype ? "E0306" : "E0305", draft.span,
                                        fmt::format("`{}` takes {}, but gets {}", draft.name, describe(declared), arriving.describe()));
    problem.label = dtype ? "the shapes differ" : "the dtypes differ";
    problem.notes.push_back({"this is where it comes from", draft.edge->span, arriving.describe()});
    problem.help = "put a `processor` on the connection, or connect something that fits";
    failed_ = true;
    return false;
  }

  /// Bounds must be one number or one for each element, and fit the dtype.
  bool check_bounds(const Space& space, Span span) {
    for (const auto* bounds : {&space.low, &space.high}) {
      if (bounds->size() > 1 && bounds->size() != space.size()) {
        return fail("E0326", span, fmt::format("{} bounds for {} elements", bounds->size(), space.size()));
      }
      for (const double bound : *bounds) {
        const bool infinite = is_floating(space.dtype) && (bound == std::numeric_limits<double>::infinity() || bound == -std::numeric_limits<double>::infinity());
        const bool whole = is_floating(space.dtype) || bound == static_cast<double>(static_cast<std::int64_t>(bound));
        if (infinite || (bound >= lowest_of(space.dtype) && bound <= highest_of(space.dtype) && whole)) continue;
        return fail("E0326", span, fmt::format("`{}` is no bound of a {}", bound, to_string(space.dtype)));
      }
    }
    return true;
  }

  std::optional<Processor> make_processor(const ProcessorSpec& spec, const Space& arriving) {
    const Entity* entity = find_entity(draft_.library, spec.type, EntityKind::processor, diagnostics());
    if (entity == nullptr) {
      failed_ = true;
      return std::nullopt;
    }
    Processor processor;
    processor.entity = entity;
    processor.span = spec.type.span;
    processor.config = resolve_config(*entity, spec.config, spec.type.span, diagnostics());
    const References references = references_of(*entity, spec.config);
    const PartialSpace takes = partial_space(entity->inputs.front().space, references, diagnostics());
    processor.input = arriving;
    if ((takes.dtype && *takes.dtype != arriving.dtype) || (takes.shape && *takes.shape != arriving.shape)) {
      fail("E0306", spec.type.span, fmt::format("`{}` takes {}, but gets {}", entity->id.value, describe(takes), arriving.describe()));
      return std::nullopt;
    }
    PartialSpace gives = partial_space(entity->outputs.front().space, references, diagnostics());
    if (gives.like) gives = overlay(partial_of(arriving), gives);
    const auto output = complete(gives);
    if (!output) {
      fail("E0312", spec.type.span, fmt::format("the manifest of `{}` does not say what it gives", entity->id.value));
      return std::nullopt;
    }
    processor.output = *output;
    failed_ = failed_ || diagnostics().has_errors();
    return failed_ ? std::nullopt : std::optional<Processor>(std::move(processor));
  }

  bool fail(const char* code, Span span, std::string message) {
    diagnostics().error(code, span, std::move(message));
    failed_ = true;
    return false;
  }

  void report_unknown() {
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      const DraftNode& node = draft_.nodes[n];
      for (std::size_t o = 0; o < node.outputs.size(); ++o) {
        if (outputs_[n][o]) continue;
        const bool action = n == Graph::kEnvironment;
        auto& problem = diagnostics().error("E0312", node.outputs[o].span,
                                            fmt::format("the space of `{}.{}` is not known", action ? "actions" : node.node.name, node.outputs[o].name));
        problem.help = action ? fmt::format("write it: `actions: {{{}: {{space: {{like: object.actuator}}}}}}`, or with dtype, shape, low and high", node.outputs[o].name)
                              : "it depends on an input whose space is not known";
      }
    }
  }

  void fill_graph() {
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      DraftNode& draft = draft_.nodes[n];
      for (auto& input : inputs_[n]) draft.node.inputs.push_back(std::move(*input));
      for (auto& output : outputs_[n]) draft.node.outputs.push_back(std::move(*output));
      draft_.graph.nodes.push_back(std::move(draft.node));
    }
  }

  Draft& draft_;
  std::vector<std::vector<std::optional<Output>>> outputs_;
  std::vector<std::vector<std::optional<Input>>> inputs_;
  bool failed_ = false;
};

}  // namespace

void resolve_spaces(Draft& draft) { SpaceResolver(draft).run(); }

}  // namespace eagerx::gen

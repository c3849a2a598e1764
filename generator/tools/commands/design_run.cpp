#include "generator/tools/commands/design_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <runtime/host/base/nearest.hpp>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/commands/design_write.hpp"
#include "generator/tools/page/units.hpp"

namespace eagerx::gen {
namespace {

std::string port_name(const Plan& plan, const PortElement& at) {
  const std::string& port = plan.channels[at.channel].port;
  return space_of(plan, at.channel).size() == 1 ? port : fmt::format("{}[{}]", port, at.element);
}

/// "controller.balance" is "controller/balance".
std::string with_slashes(std::string name) {
  std::ranges::replace(name, '.', '/');
  return name;
}

}  // namespace

bool DesignRun::begin(std::initializer_list<const char*> types) {
  if (!make_linear_graph(run_, options_)) return false;
  std::vector<std::string> names, wanted(types.begin(), types.end());
  for (std::size_t i = 0; i < run_.graph->nodes.size(); ++i) {
    const GraphNode& each = run_.graph->nodes[i];
    if (each.role != NodeRole::node || each.entity == nullptr) continue;
    if (ranges::contains(wanted, each.entity->id.value)) names.push_back(each.name);
    if (each.name == with_slashes(options_.of)) node_ = i;
  }
  if (node_ != 0 && ranges::contains(wanted, node().entity->id.value)) return true;
  auto& error = run_.diagnostics.error(
      "E0522", run_.graph->span,
      node_ == 0 ? fmt::format("there is no node `{}`", options_.of)
                 : fmt::format("`{}` is a {}, not a {}", options_.of, node().entity->id.value,
                               join(wanted, " or ")));
  const std::string nearest = host::suggestion(options_.of, names);
  error.help = !nearest.empty() ? nearest
               : names.empty()  ? fmt::format("add a {} to the graph", join(wanted, " or "))
                                : "there is `" + join(names, "`, `") + "`";
  return false;
}

bool DesignRun::open_at(std::optional<std::size_t> channel) {
  if (!options_.open.empty()) {
    const auto port = opened_port(options_.open, plan(), run_.diagnostics);
    if (port) opened_.push_back(*port);
    return port.has_value();
  }
  if (!channel || plan().channels[*channel].node == Graph::kEnvironment) return true;
  for (std::uint64_t i = 0; i < space_of(plan(), *channel).size(); ++i)
    opened_.push_back({*channel, i});
  return true;
}

std::vector<std::string> DesignRun::words() const {
  std::vector<std::string> words = first_words(options_, plan());
  for (const std::string& state : options_.at) words.insert(words.end(), {"--at", state});
  return words;
}

std::optional<std::string> DesignRun::print(const std::vector<std::string>& words) {
  std::string failure;
  auto text = printed_by(image_, words, failure, code_);
  if (!text) complain_text(failure);
  return text;
}

std::optional<Margins> DesignRun::margins(const PortElement& at) {
  std::vector<std::string> all = words();
  all.insert(all.end(),
             {"--open", fmt::format("{}", at.channel), "--element", fmt::format("{}", at.element)});
  const auto system = system_of(run_, image_, all, code_);
  if (!system) return std::nullopt;
  if (system->opened > 0) return margins_of(*system);
  run_.diagnostics.error(
      "E0520", run_.graph->span,
      fmt::format("`{}` has no numbers with derivatives", port_name(plan(), at)));
  return std::nullopt;
}

bool DesignRun::build(bool for_plant) {
  for (const std::string& state : options_.at) check_state(state, *run_.graph, run_.diagnostics);
  if (run_.diagnostics.has_errors()) return false;
  if (!for_plant && opened_.empty()) return true;
  const auto image = build_linear_program(run_, options_, code_);
  if (!image) return false;
  image_ = *image;
  for (const PortElement& at : opened_) {
    const auto found = margins(at);
    if (!found) return false;
    before_.push_back(*found);
  }
  return true;
}

std::optional<std::string> DesignRun::plant(std::optional<std::size_t> cut,
                                            const std::vector<std::size_t>& seen) {
  std::vector<std::string> all = words();
  all.insert(all.end(), {"--node", node().name});
  if (cut) all.insert(all.end(), {"--cut", fmt::format("{}", *cut)});
  for (const std::size_t channel : seen)
    all.insert(all.end(), {"--seen", fmt::format("{}", channel)});
  return print(all);
}

namespace {
bool is_filter(const std::string& type) {
  return type == "KalmanFilter" || type == "Observer";
}
}  // namespace

bool DesignRun::verify(DesignReport& report) {
  if (opened_.empty()) return true;
  set_parameters(run_.graph->nodes[node_], report.parameters);
  const auto image = build_linear_program(run_, options_, code_);
  if (!image) return false;
  image_ = *image;
  for (std::size_t i = 0; i < opened_.size(); ++i) {
    const auto after = margins(opened_[i]);
    if (!after) return false;
    report.loops.push_back({port_name(plan(), opened_[i]), before_[i], *after});
    if (after->is_stable) continue;
    // A filter keeps nothing upright: who begins with it has no regulator yet.
    if (is_filter(report.type) && !before_[i].is_stable) {
      run_.diagnostics.note(run_.graph->span,
                            fmt::format("the loop at `{}` is unstable, as before: design its "
                                        "regulator next",
                                        report.loops.back().port));
      continue;
    }
    run_.diagnostics
        .error("E0522", run_.graph->span,
               fmt::format("with these parameters the loop at `{}` is unstable: spectral "
                           "radius {:.6g}",
                           report.loops.back().port, after->spectral_radius))
        .help = help_for_unstable();
  }
  return true;
}

std::string DesignRun::help_for_unstable() const {
  const Input* const outer = input("reference");
  const GraphNode* const source =
      outer != nullptr ? &run_.graph->nodes[outer->source_node] : nullptr;
  if (node().entity->id.value != "StateFeedback" || source == nullptr ||
      source->role != NodeRole::node)
    return "the graph stays as it is; look at other parts of it with `eagerx-gen linearize`";
  return fmt::format(
      "the graph stays as it is; the gains are those without the outer loop through `{}`: set the "
      "gains of `{}` to 0, design `{}`, and then `{}`",
      outer->written, source->name, node().name, source->name);
}

int DesignRun::end(const DesignReport& report) {
  if (options_.json)
    say_text(dump_json(design_json(report)) + "\n");
  else
    say_text(design_text(report));
  if (options_.write && !run_.diagnostics.has_errors())
    write_parameters(run_, options_, node().name, report.parameters);
  return std::max(code_, finish(run_, options_));
}

int DesignRun::refuse(const std::string& problem, const std::string& help) {
  if (!problem.empty()) run_.diagnostics.error("E0522", run_.graph->span, problem).help = help;
  return std::max(code_, finish(run_, options_));
}

const Input* DesignRun::input(std::string_view name) const {
  const auto found = ranges::find(node().inputs, name, &Input::name);
  return found != node().inputs.end() ? &*found : nullptr;
}

std::string DesignRun::unit(std::size_t channel) const {
  const Channel& sent = plan().channels[channel];
  const GraphNode& node = run_.graph->nodes[sent.node];
  return unit_of(*run_.graph, node, node.outputs[sent.output]);
}

std::size_t DesignRun::channel(const Input& input) const {
  return channel_at(plan(), input.source_node, input.source_output);
}
std::size_t DesignRun::sent() const {
  return channel_at(plan(), node_, 0);
}

bool DesignRun::is_input(const std::string& name, const Input& input) const {
  return name == input.written || with_slashes(name) == node().name + "/" + input.name;
}
bool DesignRun::is_sent(const std::string& name) const {
  const Channel& channel = plan().channels[sent()];
  return name == channel.port || name == channel.name || ranges::contains(channel.aliases, name) ||
         with_slashes(name) == node().name + "/" + node().outputs.front().name;
}

DesignReport DesignRun::report(const char* method) const {
  DesignReport report;
  report.method = method;
  report.node = node().name;
  report.type = node().entity->id.value;
  report.period_s = 1.0 / node().rate_hz.to_double();
  report.numbers = Json::object();
  return report;
}

}  // namespace eagerx::gen

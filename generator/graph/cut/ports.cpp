#include "generator/graph/cut/ports.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/graph/resolve/chosen_nodes.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// "arm/leg[2].torque" → "arm_leg_2_torque": a field of a struct.
std::string field_of(std::string_view port) {
  std::string field;
  for (const char c : port) {
    if (c == ']') continue;
    field += c == '/' || c == '.' || c == '[' ? '_' : c;
  }
  return field;
}

/// Without its section: "arm/position.inputs.setpoint" → "arm/position.setpoint".
std::string plain(const std::string& port) {
  const PortName name = parse_port(port);
  return name.owner + "." + name.name;
}

/// Names at the cut of ports that belong to a composite.
class ComposedNames {
 public:
  explicit ComposedNames(const CutRequest& request) {
    std::vector<const std::string*> composites;
    for (const auto& [composite, ports] : request.composites.composites()) {
      const bool chosen = ranges::any_of(request.names, [&name = composite](const auto& each) {
        return is_called(name, each) == Called::itself;
      });
      if (chosen) composites.push_back(&composite);
    }
    const bool alone = composites.size() == 1 && request.names.size() == 1;
    for (const std::string* composite : composites) {
      const std::string prefix = alone ? "" : *composite + ".";
      const CompositePorts& ports = *request.composites.find(*composite);
      for (const auto& [port, sinks] : ports.sinks)
        for (const PortBinding& sink : sinks) in_[plain(sink.port)] = prefix + port;
      for (const auto& [port, source] : ports.sources) out_[plain(source)].push_back(prefix + port);
    }
  }

  /// Of an input inside; empty if it is none of a composite's.
  [[nodiscard]] std::string of_input(const std::string& written) const {
    const auto found = in_.find(written);
    return found == in_.end() ? std::string() : found->second;
  }
  /// Of an output inside, as often as it is a port.
  [[nodiscard]] std::vector<std::string> of_output(const std::string& written) const {
    const auto found = out_.find(written);
    return found == out_.end() ? std::vector<std::string>() : found->second;
  }

 private:
  std::map<std::string, std::string> in_;
  std::map<std::string, std::vector<std::string>> out_;
};

class CrossingsFinder {
 public:
  CrossingsFinder(const Graph& whole, const std::vector<bool>& inside, const CutRequest& request)
      : whole_(whole), inside_(inside), names_(request) {}

  Crossings run() {
    for (std::size_t n = 0; n < whole_.nodes.size(); ++n)
      for (std::size_t i = 0; i < whole_.nodes[n].inputs.size(); ++i) look_at(n, i);
    return std::move(result_);
  }

 private:
  void look_at(std::size_t n, std::size_t i) {
    const Input& input = whole_.nodes[n].inputs[i];
    if (inside_[n] == inside_[input.source_node]) return;
    if (inside_[n])
      comes_in(n, i);
    else if (!only_looks(n))
      goes_out(input);
  }

  /// Nodes that only draw or compute rewards drive nothing.
  [[nodiscard]] bool only_looks(std::size_t n) const {
    return whole_.nodes[n].drawn || (whole_.task && whole_.task->node == n) ||
           (whole_.render && whole_.render->node == n);
  }

  /// Messages that are put together from elements have no sender that a user named.
  [[nodiscard]] bool is_gathered(std::size_t n) const {
    return whole_.nodes[n].role == NodeRole::node && whole_.nodes[n].name.starts_with("mux/");
  }
  /// "actions.voltage" → "voltage"
  static std::string without_environment(const std::string& port) {
    const PortName name = parse_port(port);
    const bool environment = name.owner == "actions" || name.owner == "observations";
    return environment ? name.within_owner() : port;
  }

  [[nodiscard]] CutPort port_of(const Sender& from) const {
    const GraphNode& node = whole_.nodes[from.first];
    CutPort port;
    port.channel = node.name + "/" + node.outputs[from.second].name;
    port.rate_hz = node.rate_hz;
    return port;
  }

  void comes_in(std::size_t n, std::size_t i) {
    const Input& input = whole_.nodes[n].inputs[i];
    const Sender from{input.source_node, input.source_output};
    Crossing crossing{from, port_of(from), input.span};
    // Where several sensors are made of one output, their processors are at its readers.
    crossing.port.sender =
        input.of_sensor == 0 ? name_of_source(whole_, input) : crossing.port.channel;
    std::string name = names_.of_input(input.written);
    if (name.empty()) {
      name = crossing.port.sender;
      name = is_gathered(input.source_node) ? input.written : without_environment(name);
    }
    const std::size_t at = add(result_.in, named_in_, std::move(crossing), name);
    result_.of_input[{n, i}] = at;
  }

  void goes_out(const Input& input) {
    const Sender from{input.source_node, input.source_output};
    const std::string written =
        whole_.nodes[from.first].name + "." + whole_.nodes[from.first].outputs[from.second].name;
    std::vector<std::string> names = names_.of_output(written);
    if (names.empty()) names.push_back(written);
    if (is_gathered(from.first)) names = {without_environment(input.written)};
    for (const std::string& name : names) {
      Crossing crossing{from, port_of(from), input.span};
      crossing.port.sender = written;
      Crossing& known = result_.out[add(result_.out, named_out_, std::move(crossing), name)];
      drive(known, input);
    }
  }

  /// An actuator that gets it as it is says what is within its bounds.
  static void drive(Crossing& crossing, const Input& input) {
    if (!input.actuator || input.processor || crossing.driven) return;
    crossing.driven = true;
    crossing.port.actuator = input.written;
    crossing.space = input.space;
    crossing.span = input.span;
  }

  /// Crossings of one direction; each name with each sender once.
  struct Named {
    std::map<std::pair<std::string, Sender>, std::size_t> places;
    std::set<std::string> fields;
  };

  /// The place of the crossing with this name and sender, which may be there already.
  static std::size_t add(std::vector<Crossing>& list, Named& named, Crossing crossing,
                         const std::string& name) {
    const auto [place, is_new] = named.places.try_emplace({name, crossing.from}, list.size());
    if (!is_new) return place->second;
    crossing.port.name = field_of(name);
    for (int i = 2; !named.fields.insert(crossing.port.name).second; ++i)
      crossing.port.name = fmt::format("{}_{}", field_of(name), i);
    list.push_back(std::move(crossing));
    return list.size() - 1;
  }

  const Graph& whole_;
  const std::vector<bool>& inside_;
  ComposedNames names_;
  Crossings result_;
  Named named_in_, named_out_;
};

}  // namespace

Crossings crossings_of(const Graph& whole, const std::vector<bool>& inside,
                       const CutRequest& request) {
  return CrossingsFinder(whole, inside, request).run();
}

}  // namespace eagerx::gen

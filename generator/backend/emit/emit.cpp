#include "generator/backend/emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <runtime/host/base/hash.hpp>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/policy_answers.hpp"
#include "generator/backend/emit/policy_view.hpp"
#include "generator/backend/emit/wrap.hpp"
#include "generator/graph/plan/vectorized.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

// Of tables of a policy: what is more makes compilers slow, as text.
constexpr std::size_t kLargePolicy = 100'000;

constexpr const char* kDualNumber = "eagerx::Number";  // of target linearize

constexpr const char* kEqualsHash = " = 0x";  // what is between the name of a hash and its digits

class Emitter {
 public:
  Emitter(const Plan& plan, const std::optional<Network>& network,
          const std::vector<NodePolicy>& node_policies, const EmitOptions& options,
          Diagnostics& diagnostics)
      : plan_(plan),
        options_(options),
        diagnostics_(diagnostics),
        names_(plan, options.part, Numbers::plain, true) {
    why_not_vectorized_ = why_not_vectorized(plan);
    is_vectorized_ = why_not_vectorized_.empty() && options.part == Part::whole &&
                     ranges::any_of(options.targets, &Target::vectorized);
    // Where the agent is, and in the hub, which has everything of the graph's own sources.
    const bool decides = !options.part.is_placed() || names_.runs(Graph::kEnvironment);
    if (decides) network_ = network;
    for (const NodePolicy& policy : node_policies) {
      if (!options.part.is_placed() || names_.runs(policy.node)) node_policies_.push_back(policy);
    }
  }

  std::optional<std::vector<GeneratedFile>> run() {
    const std::string folder = options_.header_folder + plan_.graph->name + "/";
    const auto& task = plan_.graph->task;
    add(folder + "messages.hpp", "cpp/messages.hpp.mustache", messages_view(plan_, names_));
    const fs::path here = fs::path(options_.output) / folder;
    View io = io_view(plan_, names_, {options_.builtin_root, here.string()});
    add(folder + "io.hpp", "cpp/io.hpp.mustache", std::move(io));
    if (task && names_.runs(task->node))
      add(folder + "task.hpp", "cpp/task.hpp.mustache", task_view(plan_));
    add(folder + "limits.hpp", "cpp/limits.hpp.mustache", limits_view(plan_, names_));
    if (is_vectorized_) add_vectorized(folder, here);
    if (ranges::any_of(options_.targets, &Target::derivatives)) add_derivatives(folder, here);
    const std::size_t at = files_.size();
    add_program(folder, names_, false);
    if (is_vectorized_ && !failed_) {
      // The vectorized program reads this program's members, and cannot read arrays of nodes.
      program_alone_ = std::move(files_[at].text);
      files_.resize(at);
      add_program(folder, ProgramNames(plan_, options_.part), true);
    }
    add(folder + "graph.hpp", "cpp/graph.hpp.mustache", graph_view());
    const std::size_t first_policy = files_.size();
    if (network_) add_policy(folder, "policy", *network_, nullptr);
    for (const NodePolicy& policy : node_policies_) {
      add_policy(folder, policy_namespace(plan_.graph->nodes[policy.node].name), *policy.network,
                 &policy);
    }
    if (!failed_) add_hashes(first_policy);
    if (!failed_) finish_stored();
    if (plan_.telemetry && !failed_) add_telemetry(folder);
    if (options_.targets.empty()) {
      add(options_.header_folder + plan_.graph->name + ".hpp", "library/library.hpp.mustache",
          gen::library_view(plan_, network_.has_value(), network_ && network_->has_memory()));
      if (options_.cmake) add("CMakeLists.txt", "library/CMakeLists.txt.mustache", cmake_view());
    } else {
      add("CMakeLists.txt", "cpp/CMakeLists.txt.mustache", cmake_view());
    }
    for (const Target* target : options_.targets) {
      if (target->language.empty()) add_target(*target);
    }
    for (const auto& item : options_.extra) add_extra(item);
    if (failed_) return std::nullopt;
    return std::move(files_);
  }

 private:
  /// `view` with what every template may name.
  View with_common(View view) const {
    const std::size_t dot = options_.version.find('.');
    view.set("name", plan_.graph->name);
    // A graph may be called `time` or `read`, as functions of the C library are.
    std::string upper = plan_.graph->name;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    view.set("upper_name", upper);
    const auto set_default = [&](const char* key, const std::string& value) {
      if (view.get(key) == nullptr) view.set(key, value);
    };
    set_default("namespace", "graphs::" + plan_.graph->name);
    set_default("headers", plan_.graph->name + "/");
    view.set("header", plan_.graph->name + "/graph.hpp");
    view.set("file",
             view.get("file") != nullptr ? *view.get("file") : View(plan_.graph->file_name));
    view.set("version", options_.version);
    view.set("major", options_.version.substr(0, dot));
    view.set("minor",
             options_.version.substr(dot + 1, options_.version.find('.', dot + 1) - dot - 1));
    return view;
  }

  void add(const std::string& path, const std::string& template_file, View view) {
    add_rendered(path, (fs::path(options_.templates) / template_file).string(), std::move(view));
  }

  /// The program once more, over SIMD vectors.
  void add_vectorized(const std::string& folder, const fs::path& here) {
    Plan plan = plan_;
    plan.schedule = vectorized_schedule(plan_);
    const ProgramNames names(plan, Part::whole, Numbers::simd);
    const auto add_one = [&](const std::string& file, const std::string& template_file, View view) {
      view.set("namespace", "graphs::" + plan_.graph->name + "::vectorized");
      view.set("headers", plan_.graph->name + "/vectorized/");
      add(folder + "vectorized/" + file, template_file, std::move(view));
    };
    View messages = messages_view(plan, names);
    const bool has_engine = plan.graph->has_engine();
    messages.set("registers",
                 text_or_false(has_engine ? plan.graph->engine().entity->simd_registers : ""));
    add_one("messages.hpp", "cpp/vectorized_messages.hpp.mustache", std::move(messages));
    add_one("io.hpp", "cpp/io.hpp.mustache",
            io_view(plan, names, {options_.builtin_root, (here / "vectorized").string()}));
    View program = program_view(plan, names);
    program.set("indented", indented());
    add_one("program.hpp", "cpp/vectorized_program.hpp.mustache", std::move(program));
    if (!failed_) files_.back().text = take_marks(files_.back().text).text;
    add_one("sampler.hpp", "cpp/vectorized_sampler.hpp.mustache", sampler_view(plan_, names_));
    if (acts_vectorized()) {
      View view = vectorized_policy_view(*network_, "policy");
      view["agent"] = vectorized_agent_view(plan_, *network_);
      add_one("policy.hpp", "cpp/vectorized_policy.hpp.mustache", std::move(view));
    }
    for (const NodePolicy& policy : node_policies_) {
      const std::string name = policy_namespace(plan_.graph->nodes[policy.node].name);
      View view = vectorized_policy_view(*policy.network, name);
      view["node"] = policy_node_view(plan_, policy, Numbers::simd);
      add_one(name + ".hpp", "cpp/vectorized_policy.hpp.mustache", std::move(view));
    }
  }

  /// The program once more, over numbers with derivatives: without guards, pictures and policy.
  void add_derivatives(const std::string& folder, const fs::path& here) {
    const ProgramNames names(plan_, Part::whole, Numbers::dual);
    const auto add_one = [&](const std::string& file, View view) {
      view.set("namespace", "graphs::" + plan_.graph->name + "::derivatives");
      view.set("headers", plan_.graph->name + "/derivatives/");
      add(folder + "derivatives/" + file, "cpp/" + file + ".mustache", std::move(view));
    };
    add_one("messages.hpp", messages_view(plan_, names));
    add_one("io.hpp",
            io_view(plan_, names, {options_.builtin_root, (here / "derivatives").string()}));
    View program = program_view(plan_, names);
    program.set("has_memory", false);
    program.set("indented", indented());
    program.set("with_vectorized", false);
    add_one("program.hpp", std::move(program));
    if (!failed_) files_.back().text = take_marks(files_.back().text).text;
  }

  /// The agent's memory is in each environment's own program.
  bool acts_vectorized() const { return is_vectorized_ && network_ && !network_->has_memory(); }

  static View vectorized_policy_view(const Network& network, const std::string& name) {
    PolicyTables tables(PolicyTables::Kind::none);
    View view = policy_view(network, tables, "F32");
    view.set("policy", name);
    view.set("by_lane", needs_lane_by_lane(network));
    view.set("node", View(false));
    view.set("agent", View(false));
    return view;
  }

  /// program.hpp, and what of it belongs to which node.
  void add_program(const std::string& folder, const ProgramNames& names, bool with_vectorized) {
    View view = program_view(plan_, names);
    view.set("has_memory", network_ && network_->has_memory());
    view.set("indented", indented());
    view.set("with_vectorized", with_vectorized);
    add(folder + "program.hpp", "cpp/program.hpp.mustache", std::move(view));
    if (failed_) return;
    MarkedText program = take_marks(files_.back().text);
    if (options_.cmake)
      files_.push_back({folder + "program.map", to_text(program_map(plan_, names, program))});
    ranges::find(files_, folder + "program.hpp", &GeneratedFile::path)->text =
        std::move(program.text);
  }

  /// Into messages.hpp, which has zeros in their places: what all headers so far were made from.
  /// Equal for all targets, and for a standalone tree.
  void add_hashes(std::size_t first_policy) {
    std::vector<GeneratedFile> headers, policies;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      GeneratedFile file = files_[i];
      file.path.erase(0, options_.header_folder.size());
      if (is_vectorized_ && file.path.ends_with("/program.hpp")) file.text = program_alone_;
      if (i >= first_policy) policies.push_back(file);
      if (file.path.find("/vectorized/") == std::string::npos &&
          file.path.find("/derivatives/") == std::string::npos)
        headers.push_back(std::move(file));
    }
    hash_ = options_.graph_hash != 0 ? options_.graph_hash : hash_of(headers);
    put_hash("kGraphHash", hash_);
    put_hash("kPolicyHash", policies.empty() ? 0 : hash_of(policies));
  }

  /// How to read what a board sends, for programs not written in C++.
  void add_telemetry(const std::string& folder) {
    View view = telemetry_view(plan_);
    view.set("hash", fmt::format("0x{:016x}", hash_));
    add(folder + "telemetry.json", "cpp/telemetry.json.mustache", std::move(view));
  }

  void put_hash(const std::string& constant, std::uint64_t hash) {
    std::string& text = files_.front().text;
    const std::string begin = constant + kEqualsHash;
    const std::string digits = fmt::format("{:016x}", hash);
    if (const auto at = text.find(begin); at != std::string::npos)
      text.replace(at + begin.size(), digits.size(), digits);
  }

  void add_rendered(const std::string& path, const std::string& template_path, View view) {
    auto text = render_file(template_path, path, with_common(std::move(view)), diagnostics_);
    failed_ = failed_ || !text;
    if (!text) return;
    const bool cpp = path.ends_with(".hpp") || path.ends_with(".cpp") || path.ends_with(".h") ||
                     path.ends_with(".ino");
    files_.push_back({path, cpp ? wrapped(*text) : std::move(*text)});
  }

  View graph_view() const {
    View view = gen::graph_view(plan_, names_, network_, node_policies_);
    return view;
  }

  /// The layers of the agent's policy, or of a node's with the class that runs them. Large tables
  /// are a file next to the header.
  void add_policy(const std::string& folder, const std::string& name, const Network& network,
                  const NodePolicy* node) {
    const bool is_large = flash_bytes(network) >= kLargePolicy;
    PolicyTables tables(is_large ? PolicyTables::Kind::stored : PolicyTables::Kind::text,
                        fmt::format("graphs::{}::{}", plan_.graph->name, name));
    const std::string header = fmt::format("{}{}.hpp", folder, name);
    add_header(header, name, network, node, tables);
    if (is_large && !failed_)
      stored_.push_back({header, name, &network, node, tables.take_bytes()});
  }

  void add_header(const std::string& path, const std::string& name, const Network& network,
                  const NodePolicy* node, PolicyTables& tables) {
    View view = policy_view(network, tables);
    view.set("policy", name);
    const bool has_derivatives =
        node != nullptr && ranges::any_of(options_.targets, &Target::derivatives);
    view["derivatives"] = View(false);
    view["node"] = View(false);
    if (has_derivatives) {
      PolicyTables none(PolicyTables::Kind::none);
      view["derivatives"] = policy_view(network, none, kDualNumber);
    }
    if (node != nullptr) {
      view["node"] =
          policy_node_view(plan_, *node, has_derivatives ? Numbers::dual : Numbers::plain);
      view["node"].set("real", has_derivatives ? kDualNumber : "float");
    }
    add(path, "cpp/policy.hpp.mustache", std::move(view));
  }

  /// The files of large tables; or, in trees that compilers of any kind read, headers with these
  /// tables as text instead. The hashes are those of the former in both cases.
  void finish_stored() {
    for (StoredPolicy& each : stored_) {
      if (!options_.tables_as_text) {
        files_.push_back({each.header + ".weights", std::move(each.bytes)});
        continue;
      }
      each.bytes.clear();
      PolicyTables tables(PolicyTables::Kind::blocks);
      add_header(each.header, each.name, *each.network, each.node, tables);
      if (failed_) return;
      const std::string text = tables.put_blocks(files_.back().text);
      files_.pop_back();
      ranges::find(files_, each.header, &GeneratedFile::path)->text = text;
    }
  }

  View cmake_view() const {
    View view(View::type::object);
    View targets(View::type::list);
    for (const Target* target : options_.targets) {
      View item(View::type::object);
      item.set("id", target->id.value);
      item.set("toolchain", target->toolchain.empty() ? View(false) : View(target->toolchain));
      targets.push_back(item);
    }
    view["targets"] = std::move(targets);
    view.set("first", options_.targets.empty() ? "" : options_.targets.front()->id.value);
    view.set("standalone", !options_.header_folder.empty());
    view.set("many_nodes", plan_.graph->nodes.size() > kMostNodesForFastCollection);
    const auto packages = packages_of(*plan_.graph, options_.part);
    view.set("packages", View(!packages.empty()));
    View libraries(View::type::list);
    for (const auto& package : packages) {
      View item(View::type::object);
      item.set("library", package);
      libraries.push_back(item);
    }
    view["libraries"] = std::move(libraries);
    return view;
  }

  void add_extra(const ExtraTemplate& item) {
    View view = options_.targets.empty()
                    ? loop_view(plan_, network_.has_value(), network_ && network_->has_memory())
                    : View(View::type::object);
    add_rendered(item.output, item.path, std::move(view));
    if (!failed_) files_.back().yours = item.yours;
  }

  void add_target(const Target& target) {
    for (const auto& [file, output] :
         options_.part.is_placed() ? target.partner : target.templates) {
      View view(View::type::object);
      view.set("target", target.id.value);
      view.set("is_split", options_.part != Part::whole);
      view.set("vectorized", is_vectorized_);
      view.set("acts_vectorized", acts_vectorized());
      view.set("why_not_vectorized", why_not_vectorized_);
      view["stages"] = stages_view(plan_, names_);
      add_rendered(target.id.value + "/" + output, file, std::move(view));
    }
  }

  /// A policy whose tables are not in its header.
  struct StoredPolicy {
    std::string header, name;
    const Network* network;
    const NodePolicy* node;  // of a node
    std::string bytes;
  };

  const Plan& plan_;
  std::optional<Network> network_;
  std::vector<NodePolicy> node_policies_;
  const EmitOptions& options_;
  Diagnostics& diagnostics_;
  ProgramNames names_;
  bool is_vectorized_ = false;
  std::string why_not_vectorized_;
  std::string program_alone_;  // program.hpp without what `vectorized/` needs of it
  std::vector<GeneratedFile> files_;
  std::vector<StoredPolicy> stored_;
  std::uint64_t hash_ = 0;  // of the graph
  bool failed_ = false;
};

}  // namespace

std::uint64_t hash_of(const std::vector<GeneratedFile>& files) {
  std::uint64_t hash = host::fnv1a({});
  for (const auto& file : files) {
    if (!file.path.ends_with(".hpp")) continue;
    hash = host::fnv1a(file.path, hash);
    for (std::string_view rest = file.text; !rest.empty();) {
      const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
      if (!line.starts_with("#include \"")) hash = host::fnv1a(line, hash);
      rest.remove_prefix(line.size());
    }
  }
  return hash;
}

std::optional<std::uint64_t> hash_in(const std::vector<GeneratedFile>& files) {
  constexpr int kHexadecimal = 16;
  const std::string begin = std::string("kGraphHash") + kEqualsHash;
  for (const GeneratedFile& file : files) {
    if (!file.path.ends_with("/messages.hpp")) continue;
    const std::size_t at = file.text.find(begin);
    if (at == std::string::npos) continue;
    return std::strtoull(file.text.c_str() + at + begin.size(), nullptr, kHexadecimal);
  }
  return std::nullopt;
}

std::optional<std::vector<GeneratedFile>> emit(const Plan& plan,
                                               const std::optional<Network>& network,
                                               const std::vector<NodePolicy>& node_policies,
                                               const EmitOptions& options,
                                               Diagnostics& diagnostics) {
  return Emitter(plan, network, node_policies, options, diagnostics).run();
}

}  // namespace eagerx::gen

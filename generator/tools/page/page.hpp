// All information about a graph as one HTML page that needs no network, server or other file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/analysis/info/info.hpp"
#include "generator/analysis/size/size.hpp"
#include "generator/graph/plan/plan.hpp"
#include "generator/policy/agent/policies.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// A measured image, and how the user called it.
struct PageImage {
  std::string name;
  SizeReport size;
  std::optional<Json> time = std::nullopt;  // the bounds of its slots; nullopt: it has none
};

/// The contents of the page. It points to its sources.
struct PageContents {
  const GraphSpec* spec = nullptr;
  const Policies* policies = nullptr;
  const PlanInfo* info = nullptr;  // and with it plan and graph
  const SourceMap* sources = nullptr;
  const Diagnostics* diagnostics = nullptr;
  std::vector<PageImage> images = {};
  Json logs = Json::list();                          // of read_logs()
  std::optional<std::string> module = std::nullopt;  // of WebAssembly, which simulates the graph
  std::optional<Json> training = std::nullopt;       // of read_training(), and what was run of it
  std::optional<Json> loops = std::nullopt;          // opened at ports: margins and curves
  bool is_live = false;                              // who shows it also tells it what a run sends
};

/// The data of the page: `info` is the output of `eagerx-gen info --json`.
Json page_json(const PageContents& contents);

/// The page: `page.html` of `folder` with its style, its modules joined to one script, and the
/// data. Bytes are the same on every machine. Text in `data` stays data: it can neither close nor
/// begin an element. With a module, the page may run it; a live page may connect to its server.
/// Problems: E0301 a file of the template cannot be read.
std::optional<std::string> page_text(const std::string& folder, const PageContents& contents,
                                     Diagnostics& diagnostics);

/// The parts of a page other than its data, and its permissions.
struct PageForm {
  std::vector<std::string> entries;  // the modules that it begins with, in their order
  bool runs_module = false;          // of WebAssembly
  bool connects = false;             // to who shows it
};

/// The page of any data, as page_text() makes it.
std::optional<std::string> page_of(const std::string& folder, const PageForm& form,
                                   const Json& data, Diagnostics& diagnostics);

/// The bytes of a module of WebAssembly. Problems: E0301 it cannot be read, is none, or is too
/// large for a page.
std::optional<std::string> load_module(const std::string& path, Diagnostics& diagnostics);

/// Traces, thinned to the least and the greatest value of each part of the time, so that no plot
/// has more than `points` of these; 0: as many that all plots stay below 3 MB. Each must be of this
/// graph: its name, and every channel one of the graph's with the same type, size and rate.
/// Problems: E0361 it is not, E0362 a file cannot be read.
Json read_logs(const std::vector<std::string>& paths, const Plan& plan, std::size_t points,
               Diagnostics& diagnostics);

// The parts of page_json().
Json drawings_json(const Graph& graph, const std::vector<CompositeSpec>& composites);
/// Nodes with inputs and outputs, objects, buffers, the schedule.
void add_nodes(const PageContents& contents, Json& page);
Json policies_json(const PageContents& contents);

/// As a content policy names a text that may be there.
std::string sha256_base64(std::string_view text);

}  // namespace eagerx::gen

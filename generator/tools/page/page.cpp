#include "generator/tools/page/page.hpp"

#include <algorithm>

#include "generator/support/json/base64.hpp"

namespace eagerx::gen {
namespace {

std::string agent_text(const Agent& agent) {
  if (agent.kind == AgentSpec::Kind::zero) return "zero";
  if (agent.kind == AgentSpec::Kind::random) return "random";
  return agent.file;
}

/// The graph's file as it was written; of a file of EAGERx no line is ours.
Json source_json(const PageContents& contents) {
  Json lines = Json::list();
  const FileId file = contents.spec->file;
  if (file != FileId::none) {
    const std::string& text = contents.sources->text(file);
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return Json{{"name", contents.info->plan->graph->file_name}, {"lines", std::move(lines)}};
}

const char* name_of(Severity severity) {
  if (severity == Severity::error) return "error";
  return severity == Severity::warning ? "warning" : "note";
}

Json diagnostics_json(const PageContents& contents) {
  Json list = Json::list();
  for (const Diagnostic& problem : contents.diagnostics->all()) {
    Json notes = Json::list();
    for (const auto& note : problem.notes) notes.push_back(note.message);
    // Places in other files, such as manifests, have no line here.
    const Span place = contents.sources->place_in(contents.spec->file, problem.span);
    list.push_back(Json{{"severity", name_of(problem.severity)},
                        {"code", problem.code},
                        {"message", problem.message},
                        {"help", problem.help.text},
                        {"notes", std::move(notes)},
                        {"line", place.line},
                        {"column", place.column},
                        {"length", place.length}});
  }
  return list;
}

/// The kind of picture of `render:`: "scene", "image" or "".
const char* shown_by(const Graph& graph) {
  if (!graph.render) return "";
  const Input& source = graph.nodes[graph.render->node].inputs.front();
  return source.space.dtype == Dtype::float32 ? "scene" : "image";
}

Json images_json(const std::vector<PageImage>& images) {
  Json list = Json::list();
  for (const PageImage& image : images) {
    Json item{{"name", image.name}, {"size", size_json(image.size)}};
    if (image.time) item["time"] = *image.time;
    list.push_back(std::move(item));
  }
  return list;
}

/// Keys that steer the simulation.
Json keys_json(const RenderSpec& render) {
  Json list = Json::list();
  for (const RenderKey& key : render.keys) {
    Json add = Json::list();
    for (const double number : key.add) add.push_back(number);
    list.push_back(
        Json{{"key", key.key.value}, {"parameter", key.parameter.value}, {"add", std::move(add)}});
  }
  return list;
}

}  // namespace

Json page_json(const PageContents& contents) {
  const Plan& plan = *contents.info->plan;
  Json page{{"info", info_json(*contents.info)},
            {"agent", agent_text(plan.graph->agent)},
            {"real", plan.graph->double_precision ? "double" : "float"},
            {"drawings", drawings_json(*plan.graph, contents.spec->composites)}};
  add_nodes(contents, page);
  page["policies"] = policies_json(contents);
  page["source"] = source_json(contents);
  page["diagnostics"] = diagnostics_json(contents);
  page["images"] = images_json(contents.images);
  page["logs"] = contents.logs;
  page["shows"] = shown_by(*plan.graph);
  if (contents.training) page["training"] = *contents.training;
  if (contents.loops) page["loops"] = *contents.loops;
  if (contents.is_live) page["live"] = true;
  if (contents.module) page["module"] = base64(*contents.module);
  if (contents.module && contents.spec->render) page["keys"] = keys_json(*contents.spec->render);
  return page;
}

}  // namespace eagerx::gen

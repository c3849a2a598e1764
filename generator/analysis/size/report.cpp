#include <fmt/format.h>

#include "generator/analysis/size/function_name.hpp"
#include "generator/analysis/size/size.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

void add_rows(std::string& text, const std::map<std::string, Usage>& parts) {
  for (const auto& [name, usage] : parts)
    text += fmt::format("{:<28} {:>8} {:>8}\n", name, usage.flash, usage.ram);
}

Json usages(const std::map<std::string, Usage>& parts) {
  Json json = Json::object();
  for (const auto& [name, usage] : parts)
    json[name] = Json{{"flash", usage.flash}, {"ram", usage.ram}};
  return json;
}

Json calls_json(const std::vector<StackCall>& calls) {
  Json json = Json::list();
  for (const StackCall& call : calls)
    json.push_back(Json{{"function", call.function},
                        {call.of_node ? "node" : "part", call.part},
                        {"bytes", call.bytes}});
  return json;
}

}  // namespace

std::string stack_text(const StackBound& stack) {
  std::string text;
  for (const StackCall& call : stack.calls)
    text += fmt::format("  {:>6}  {:<20} {}\n", call.bytes, call.part, call.function);
  return text;
}

std::string size_text(const SizeReport& report) {
  std::string text = fmt::format("{:<28} {:>8} {:>8}\n", "bytes", "flash", "RAM");
  add_rows(text, report.nodes);
  add_rows(text, report.others);
  text += fmt::format("{:<28} {:>8} {:>8}\n\n", "all", report.flash, report.ram);
  text +=
      fmt::format("stack: {} bytes at most, through {}", report.stack.bytes,
                  counted(report.stack.path.empty() ? 0 : report.stack.path.size() - 1, "call"));
  std::vector<std::string> unbounded;
  for (const auto& name : report.stack.unbounded) unbounded.push_back(function_name(name));
  if (!unbounded.empty())
    text += fmt::format("; not counted are calls of {} through pointers, or of themselves",
                        join(unbounded, ", "));
  text += "; interrupts come on top\n" + stack_text(report.stack);
  if (const auto& count = report.instructions)
    text += fmt::format("instructions of a slot: {:.0f} on average, {} to {}, in {}\n", count->mean,
                        count->least, count->most, counted(count->slots, "slot"));
  return text;
}

Json size_json(const SizeReport& report) {
  Json json;
  json["flash"] = report.flash;
  json["ram"] = report.ram;
  json["nodes"] = usages(report.nodes);
  json["others"] = usages(report.others);
  json["stack"] = Json{{"bytes", report.stack.bytes},
                       {"path", report.stack.path},
                       {"calls", calls_json(report.stack.calls)},
                       {"unbounded", report.stack.unbounded}};
  if (const auto& count = report.instructions)
    json["instructions"] = Json{{"slots", count->slots},
                                {"least", count->least},
                                {"most", count->most},
                                {"mean", count->mean}};
  return json;
}

}  // namespace eagerx::gen

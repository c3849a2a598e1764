#include "generator/frontend/compose/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/read/number.hpp"

namespace eagerx::gen {
namespace {

constexpr std::array<const char*, 4> kInputsOfMux = {"a", "b", "c", "d"};

YamlValue made_map(Span span) {
  YamlValue map;
  map.kind = YamlKind::map;
  map.span = span;
  return map;
}

/// `{type: Mux, rate: …, config: {size: …}, inputs: [a, b]}`
YamlValue mux(std::size_t inputs, std::size_t size, const YamlValue& rate, Span span) {
  YamlValue config = made_map(span);
  set_entry(config, "size", span, made_number(static_cast<std::int64_t>(size), span));
  std::vector<YamlValue> names;
  for (std::size_t i = 0; i < inputs; ++i) names.push_back(made_scalar(kInputsOfMux[i], span));
  YamlValue node = made_map(span);
  set_entry(node, "type", span, made_scalar("Mux", span));
  set_entry(node, "rate", span, rate);
  set_entry(node, "config", span, std::move(config));
  set_entry(node, "inputs", span, made_list(std::move(names), span));
  return node;
}

/// A part of the message: who sends it, with which settings, and how many elements it has.
struct PartialMessage {
  Spanned<std::string> from;
  YamlValue connection;
  std::size_t size = 1;
};

bool has_each_once(const Spanned<std::string>& to, const std::vector<GatheredElement>& elements,
                   Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto element = elements[i].element;
    if (element == static_cast<std::int64_t>(i)) continue;
    const bool twice = i > 0 && element == elements[i - 1].element;
    auto& problem = diagnostics.error(
        "E0391", elements[i].connection.span,
        twice ? fmt::format("element {} of `{}` is connected twice", element, to.value)
              : fmt::format("element {} of `{}` is not connected", i, to.value));
    if (twice) problem.notes.push_back({"first here", elements[i - 1].connection.span, ""});
    problem.help = "an input takes all elements of its message, each from one source";
    return false;
  }
  return true;
}

}  // namespace

std::optional<Gathered> gather(const Spanned<std::string>& to,
                               std::vector<GatheredElement> elements, const YamlValue& rate,
                               Diagnostics& diagnostics) {
  std::ranges::stable_sort(elements, {}, &GatheredElement::element);
  if (!has_each_once(to, elements, diagnostics)) return std::nullopt;
  Gathered result;
  std::vector<PartialMessage> parts;
  parts.reserve(elements.size());
  for (auto& each : elements) parts.push_back({each.from, std::move(each.connection), 1});
  std::string base = "mux/" + to.value;
  std::ranges::replace(base, '.', '/');
  // Nodes of up to four inputs, until one sends everything.
  while (parts.size() > 1) {
    std::vector<PartialMessage> next;
    for (std::size_t begin = 0; begin < parts.size(); begin += kInputsOfMux.size()) {
      const std::size_t count = std::min(kInputsOfMux.size(), parts.size() - begin);
      if (count == 1 && parts.size() > 1) {
        next.push_back(std::move(parts[begin]));
        continue;
      }
      const std::string name = result.nodes.empty() && parts.size() <= kInputsOfMux.size()
                                   ? base
                                   : fmt::format("{}/part[{}]", base, result.nodes.size());
      std::size_t size = 0;
      for (std::size_t i = 0; i < count; ++i) {
        PartialMessage& part = parts[begin + i];
        size += part.size;
        result.connections.push_back(joined(part.connection, part.from,
                                            {fmt::format("{}.{}", name, kInputsOfMux[i]), to.span},
                                            {}));
      }
      result.nodes.push_back({name, to.span, mux(count, size, rate, to.span)});
      next.push_back({{name + ".y", to.span}, made_map(to.span), size});
    }
    parts = std::move(next);
  }
  result.from = parts.front().from;
  result.connection = std::move(parts.front().connection);
  return result;
}

YamlValue with_element(YamlValue connection, std::int64_t element, Span span) {
  YamlValue config = made_map(span);
  set_entry(config, "index", span, made_number(static_cast<std::int64_t>(element), span));
  YamlValue processor = made_map(span);
  set_entry(processor, "type", span, made_scalar("GetIndex", span));
  set_entry(processor, "config", span, std::move(config));
  const YamlValue* own = connection.find("processor");
  if (own == nullptr) {
    set_entry(connection, "processor", span, std::move(processor));
    return connection;
  }
  std::vector<YamlValue> both = {std::move(processor)};
  if (own->is_sequence())
    both.insert(both.end(), own->items.begin(), own->items.end());
  else
    both.push_back(*own);
  set_entry(connection, "processor", span, made_list(std::move(both), span));
  return connection;
}

}  // namespace eagerx::gen

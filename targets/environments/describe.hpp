// What eagerx_describe() says of a graph.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/json.hpp>
#include <string>
#include <targets/environments/critic.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/pack_kernel.hpp>
#include <targets/environments/stages.hpp>
#include <targets/environments/task.hpp>
#include <targets/environments/tuning.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::environments {

/// The instruction set that this library was compiled for.
constexpr const char* instruction_set() {
#if defined(__AVX512F__)
  return "avx512";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__x86_64__)
  return "x86-64";
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "other";
#endif
}

/// As graphs and numpy write it: "float32", "bool".
template <class T>
std::string dtype_of() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  constexpr std::size_t kBitsPerByte = 8;
  const std::string bits = std::to_string(sizeof(T) * kBitsPerByte);
  if constexpr (std::is_floating_point_v<T>) return "float" + bits;
  return (std::is_signed_v<T> ? "int" : "uint") + bits;
}

template <class Message>
struct ShapeOf {
  static void add(host::Json& /*json*/) {}
};
template <class T, std::size_t... Shape>
struct ShapeOf<Array<T, Shape...>> {
  static void add(host::Json& json) { (json.whole(Shape), ...); }
};

/// One object for each field of a row, in the order of the columns.
class Fields {
 public:
  explicit Fields(const Columns& columns) : columns_(columns) {}

  /// `windows` above 1: so many messages, which is the first number of the shape.
  template <class Message, class Space>
  void add(const char* name, const Space& space, std::uint32_t windows) {
    host::Json json;
    begin<Message>(json, name, windows);
    bounds(json.key("low"), space.low, windows);
    bounds(json.key("high"), space.high, windows);
    end(json);
  }
  /// Without bounds.
  template <class Message>
  void add(const char* name) {
    host::Json json;
    begin<Message>(json, name, 1);
    for (const char* key : {"low", "high"}) {
      json.key(key).begin_list();
      for (std::size_t i = 0; i < size_of<Message>; ++i) json.null();
      json.end_list();
    }
    end(json);
  }

  std::string list() const {
    std::string result;
    for (const std::size_t field : columns_.order())
      result += (result.empty() ? "" : ", ") + texts_[field];
    return "[" + result + "]";
  }

 private:
  template <class Message>
  void begin(host::Json& json, const char* name, std::uint32_t windows) const {
    json.begin_object().key("name").text(name).key("shape").begin_list();
    if (windows > 1) json.whole(windows);
    ShapeOf<Message>::add(json);
    json.end_list().key("dtype").text(dtype_of<ScalarOf<Message>>());
    json.key("window").whole(windows);
  }
  void end(host::Json& json) {
    json.key("first").whole(columns_.first(texts_.size())).end_object();
    texts_.push_back(json.str());
  }

  template <class Message>
  static void bounds(host::Json& json, const Message& bound, std::uint32_t windows) {
    json.begin_list();
    for (std::uint32_t w = 0; w < windows; ++w) {
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        if constexpr (std::is_same_v<ScalarOf<Message>, float>) {
          json.number(element(bound, i));
        } else {
          json.number(static_cast<double>(element(bound, i)));
        }
      }
    }
    json.end_list();
  }

  const Columns& columns_;
  std::vector<std::string> texts_;
};

template <class Graph>
std::string describe_actions() {
  Fields fields(Layout<Graph>::get().actions);
  typename Graph::Action action = Graph::zero();
  Graph::for_each_action(action, [&](const char* name, const auto& message, const auto& space) {
    fields.add<std::remove_cvref_t<decltype(message)>>(name, space, 1);
  });
  return fields.list();
}

template <class Graph>
std::string describe_observations() {
  Fields fields(Layout<Graph>::get().observations);
  Layout<Graph>::for_each_observed([&](const char* name, auto observed, const auto& space) {
    using Observed = typename decltype(observed)::type;
    fields.add<typename Observed::value_type>(name, space, messages_of<Observed>());
  });
  return fields.list();
}

template <class Graph>
std::string describe_states() {
  Fields fields(Layout<Graph>::get().states);
  Graph::for_each_state([&](const char* name, const char*, auto, const auto& space) {
    fields.add<std::remove_cvref_t<decltype(space.low)>>(name, space, 1);
  });
  return fields.list();
}

template <class Graph>
std::string describe_critic() {
  if constexpr (has_critic<Graph>) {
    Fields fields(CriticLayout<Graph>::get().columns);
    CriticLayout<Graph>::for_each_field(
        [&](const char* name, auto type) { fields.add<typename decltype(type)::type>(name); });
    return fields.list();
  } else {
    return "[]";
  }
}

template <class Graph>
std::string describe_task() {
  if constexpr (has_task<Graph>) {
    host::Json json;
    json.begin_object().key("terms").begin_list();
    for (const char* name : Graph::kTermNames) json.text(name);
    json.end_list().key("success").boolean(requires { Graph::kSuccessNames; });
    json.key("episode_steps").whole(Graph::kEpisodeSteps);
    return json.str() + ", \"critic\": " + describe_critic<Graph>() +
           ", \"stages\": " + describe_stages<Graph>() + "}";
  } else {
    return "null";
  }
}

/// Pictures of `render:`.
template <class Graph>
std::string describe_render() {
  if constexpr (requires { Graph::kRenders; }) {
    using Rate = typename Graph::RenderRate;
    host::Json json;
    json.begin_object().key("rate_hz").number(static_cast<double>(Rate::num) / Rate::den);
    return json.end_object().str();
  } else {
    return "null";
  }
}

/// `generator`: the version that wrote the graph's code. `kernel`: of the widest packs that this
/// processor runs, or `why_not`.
template <class Graph>
std::string describe(const char* generator, const PackKernel<Graph>& kernel, const char* why_not) {
  const std::string observations = describe_observations<Graph>();
  const std::string actions = describe_actions<Graph>();
  host::Json json;
  json.begin_object().key("version").whole(EAGERX_ENVIRONMENTS_VERSION);
  json.key("generator").text(generator).key("graph").text(Graph::kName);
  json.key("engine").text(Graph::kEngine);
  json.key("rate_hz").number(static_cast<double>(Graph::Rate::num) / Graph::Rate::den);
  const std::string contract = json.str() + observations + actions;
  const bool in_packs = kernel.lanes != 0;
  json.key("hash").text(host::hex_text(host::fnv1a(contract)));
  json.key("isa").text(in_packs ? kernel.isa : instruction_set());
  json.key("lanes").whole(in_packs ? kernel.lanes : 1);
  if (!in_packs) json.key("why_no_lanes").text(why_not);
  return json.str() + ", \"observations\": " + observations + ", \"actions\": " + actions +
         ", \"states\": " + describe_states<Graph>() +
         ", \"tunable\": " + describe_tunable<Graph>() + ", \"agent\": \"" + Graph::kDefaultAgent +
         "\"" + ", \"task\": " + describe_task<Graph>() +
         ", \"render\": " + describe_render<Graph>() + "}";
}

}  // namespace eagerx::environments

// The answer of eagerx_describe() about a graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <string>
#include <targets/common/dtype.hpp>
#include <targets/environments/base/description.hpp>
#include <targets/environments/base/fields.hpp>
#include <targets/environments/critic.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_kernel.hpp>
#include <targets/environments/stages.hpp>
#include <targets/environments/task.hpp>
#include <type_traits>

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

template <class Message>
struct TypeOf {
  static MessageType get() { return {{}, target::dtype_of<ScalarOf<Message>>()}; }
};
template <class T, std::size_t... Shape>
struct TypeOf<Array<T, Shape...>> {
  static MessageType get() { return {{Shape...}, target::dtype_of<T>()}; }
};

template <class Message, class Space>
void add_field(Fields& fields, const char* name, const Space& space, std::uint32_t windows) {
  fields.add(name, TypeOf<Message>::get(), windows, elements_of<double>(space.low),
             elements_of<double>(space.high));
}

template <class Graph>
std::string describe_actions() {
  Fields fields(Layout<Graph>::get().actions);
  typename Graph::Action action = Graph::zero();
  Graph::for_each_action(action, [&](const char* name, const auto& message, const auto& space) {
    add_field<std::remove_cvref_t<decltype(message)>>(fields, name, space, 1);
  });
  return fields.list();
}

template <class Graph>
std::string describe_observations() {
  Fields fields(Layout<Graph>::get().observations);
  Layout<Graph>::for_each_observed([&](const char* name, auto observed, const auto& space) {
    using Observed = typename decltype(observed)::type;
    add_field<typename Observed::value_type>(fields, name, space, messages_of<Observed>());
  });
  return fields.list();
}

template <class Graph>
std::string describe_states() {
  Fields fields(Layout<Graph>::get().states.columns);
  Graph::for_each_state([&](const char* name, const char*, auto, const auto& space) {
    add_field<std::remove_cvref_t<decltype(space.low)>>(fields, name, space, 1);
  });
  return fields.list();
}

template <class Graph>
std::string describe_critic() {
  if constexpr (has_critic<Graph>) {
    Fields fields(CriticLayout<Graph>::get().columns);
    CriticLayout<Graph>::for_each_field([&](const char* name, auto type) {
      fields.add(name, TypeOf<typename decltype(type)::type>::get());
    });
    return fields.list();
  } else {
    return "[]";
  }
}

template <class Graph>
std::string describe_task() {
  if constexpr (has_task<Graph>) {
    constexpr bool kSaysSuccess = requires {
      Graph::kSuccessNames;
    };
    return describe_task({Graph::kTermNames, kSaysSuccess, Graph::kEpisodeSteps,
                          describe_critic<Graph>(), describe_stages<Graph>()});
  } else {
    return "null";
  }
}

/// Pictures of `render:`.
template <class Graph>
std::string describe_render() {
  if constexpr (requires { Graph::kRenders; }) {
    return describe_render(static_cast<double>(Graph::RenderRate::num) / Graph::RenderRate::den);
  } else {
    return "null";
  }
}

/// `generator`: the version that wrote the graph's code. `kernel`: of the widest SIMD groups that
/// this processor runs, or `why_not`.
template <class Graph>
std::string describe(const char* generator, const SimdKernel<Graph>& kernel, const char* why_not) {
  const bool is_vectorized = kernel.lanes != 0;
  return describe({generator, Graph::kName, Graph::kEngine, Graph::kDefaultAgent,
                   static_cast<double>(Graph::Rate::num) / Graph::Rate::den,
                   is_vectorized ? kernel.isa : instruction_set(), is_vectorized ? kernel.lanes : 1,
                   is_vectorized ? nullptr : why_not, Graph::kGraphHash,
                   describe_observations<Graph>(), describe_actions<Graph>(),
                   describe_states<Graph>(), Layout<Graph>::get().states.describe_tunable(),
                   describe_task<Graph>(), describe_render<Graph>()});
}

}  // namespace eagerx::environments

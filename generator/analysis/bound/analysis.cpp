#include "generator/analysis/bound/analysis.hpp"

#include <fmt/format.h>

#include <vector>

#include "generator/analysis/bound/walk.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr std::size_t kArguments = 4;        // registers: AAPCS 6.4
constexpr std::int64_t kStackArguments = 8;  // words that are looked at

}  // namespace

/// Of functions that call others which never return, in turns until nothing is new.
void Analysis::find_never_returning() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [entry, name] : image_.functions()) {
      if (never_returns_.contains(entry)) continue;
      if (may_return(image_, entry, never_returns_)) continue;
      never_returns_.insert(entry);
      changed = true;
    }
  }
}

const Flow& Analysis::flow(Address entry) {
  const auto found = flows_.find(entry);
  if (found != flows_.end()) return found->second;
  return flows_.emplace(entry, flow_of(image_, entry, never_returns_)).first->second;
}

const Analysed& Analysis::of(Address entry) {
  return *analyse(entry, entry_state(entry, nullptr));
}

const Analysed* Analysis::analyse(Address entry, const State& state) {
  constexpr std::size_t kMostContexts = 64;
  std::string key = key_of(state);
  if (const auto found = known_.find({entry, key}); found != known_.end())
    return found->second.get();
  if (!key.empty() && ++contexts_[entry] > kMostContexts)
    return analyse(entry, entry_state(entry, nullptr));
  auto result = std::make_unique<Analysed>();
  active_.insert(entry);
  Walk(*this, flow(entry), *result).function(state);
  active_.erase(entry);
  return known_.emplace(std::pair(entry, std::move(key)), std::move(result)).first->second.get();
}

State entry_state(Address entry, const State* caller) {
  State state;
  for (std::size_t r = 0; r < kRegisters; ++r)
    state.registers[r] = {base_of(Origin::entry, entry, {false, static_cast<std::int64_t>(r)}), 0,
                          0};
  state.registers[kSp] = {kStack, 0, 0};
  if (caller == nullptr) return state;
  std::map<Base, Value> first;  // of each base: what stands for it in the callee
  for (std::size_t r = 0; r < kArguments; ++r) {
    const Value value = caller->resolve(caller->registers[r]);
    if (value.base == 0) {
      state.registers[r] = value;
      continue;
    }
    const auto [same, is_new] = first.emplace(value.base, value);
    if (is_new) continue;
    // As far from the argument before it as it is in the caller.
    if (!same->second.is_exact()) continue;
    for (std::size_t before = 0; before < r; ++before) {
      if (caller->resolve(caller->registers[before]) != same->second) continue;
      const std::int64_t offset = same->second.low;
      state.registers[r] = {state.registers[before].base, value.low - offset, value.high - offset};
      break;
    }
  }
  const Value& sp = caller->registers[kSp];
  if (sp.base != kStack || !sp.is_exact()) return state;
  for (std::int64_t i = 0; i < kStackArguments; ++i) {
    const auto found = caller->stack.find(sp.low + i * kWordBytes);
    if (found != caller->stack.end() && caller->resolve(found->second).base == 0)
      state.stack[i * kWordBytes] = caller->resolve(found->second);
  }
  return state;
}

std::string key_of(const State& entry) {
  std::string key;
  const auto base_of_register = [&](std::size_t r) { return entry.registers[r].base & 0xff; };
  for (std::size_t r = 0; r < kArguments; ++r) {
    const Value& value = entry.registers[r];
    const bool is_own =
        value.base != 0 && base_of_register(r) == r && value == Value{value.base, 0, 0};
    if (!is_own)
      key += fmt::format("r{}={}:{}:{} ", r, value.base == 0 ? 99 : base_of_register(r), value.low,
                         value.high);
  }
  for (const auto& [offset, value] : entry.stack)
    key += fmt::format("s{}={}:{} ", offset, value.low, value.high);
  return key;
}

}  // namespace eagerx::gen::bound

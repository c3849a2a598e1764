// A map of a few entries that is copied often.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace eagerx::gen::bound {

/// Entries in the order of their keys, in one block of memory. References to values are valid
/// until an entry comes or goes.
template <class Key, class Mapped>
class FlatMap {
 public:
  using Entry = std::pair<Key, Mapped>;

  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }
  [[nodiscard]] auto begin() { return entries_.begin(); }
  [[nodiscard]] auto end() { return entries_.end(); }
  [[nodiscard]] auto find(const Key& key) const {
    const auto at = std::ranges::lower_bound(entries_, key, {}, &Entry::first);
    return at != entries_.end() && at->first == key ? at : entries_.end();
  }
  [[nodiscard]] bool contains(const Key& key) const { return find(key) != end(); }
  Mapped& operator[](const Key& key) {
    auto at = std::ranges::lower_bound(entries_, key, {}, &Entry::first);
    if (at == entries_.end() || at->first != key) at = entries_.insert(at, Entry{key, Mapped{}});
    return at->second;
  }
  void erase(const Key& key) {
    erase_if([&](const Entry& entry) { return entry.first == key; });
  }
  template <class Is>
  void erase_if(Is&& is) {
    std::erase_if(entries_, is);
  }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  void clear() { entries_.clear(); }
  bool operator==(const FlatMap&) const = default;

 private:
  std::vector<Entry> entries_;
};

}  // namespace eagerx::gen::bound

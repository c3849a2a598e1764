// A map of a few entries that is copied often.
#pragma once

#include <algorithm>
#include <cstddef>
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
    const auto at = entries_.begin() + static_cast<std::ptrdiff_t>(first_from(key));
    return at != entries_.end() && at->first == key ? at : entries_.end();
  }
  [[nodiscard]] bool contains(const Key& key) const { return find(key) != end(); }
  Mapped& operator[](const Key& key) {
    auto at = entries_.begin() + static_cast<std::ptrdiff_t>(first_from(key));
    if (at == entries_.end() || at->first != key) at = entries_.insert(at, Entry{key, Mapped{}});
    return at->second;
  }
  void erase(const Key& key) {
    const std::size_t at = first_from(key);
    if (at < entries_.size() && entries_[at].first == key)
      entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
  }
  template <class Is>
  void erase_if(Is&& is) {
    std::erase_if(entries_, is);
  }
  /// Keeps the entries whose keys `other` has, too: those for which `join(mine, its)`, which may
  /// change the value, says so.
  template <class Join>
  void intersect(const FlatMap& other, Join&& join) {
    auto its = other.entries_.begin();
    const auto end = other.entries_.end();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      while (its != end && its->first < entries_[i].first) ++its;
      if (its == end) break;
      if (its->first != entries_[i].first || !join(entries_[i], its->second)) continue;
      if (kept < i) entries_[kept] = entries_[i];
      ++kept;
    }
    entries_.resize(kept);
  }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  void clear() { entries_.clear(); }
  bool operator==(const FlatMap&) const = default;

 private:
  /// The index of the first entry that is not below a key.
  [[nodiscard]] std::size_t first_from(const Key& key) const {
    std::size_t begin = 0;
    for (std::size_t count = entries_.size(); count > 0;) {
      const std::size_t half = count / 2;
      const bool is_below = entries_[begin + half].first < key;
      begin = is_below ? begin + half + 1 : begin;
      count = is_below ? count - half - 1 : half;
    }
    return begin;
  }

  std::vector<Entry> entries_;
};

}  // namespace eagerx::gen::bound

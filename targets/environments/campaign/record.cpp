#include "targets/environments/campaign/record.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/base/json_reader.hpp>
#include <type_traits>

#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

/// Takes numbers from the front of some bytes; all are 0 once there are too few.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void take(T* values, std::size_t count) {
    is_complete_ = is_complete_ && bytes_.size() >= count * sizeof(T);
    if (!is_complete_ || count == 0) return;
    std::memcpy(values, bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
  }
  template <class T>
  T take() {
    T value{};
    take(&value, 1);
    return value;
  }
  std::string_view take_bytes(std::size_t count) {
    is_complete_ = is_complete_ && bytes_.size() >= count;
    if (!is_complete_) return {};
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  bool is_complete() const { return is_complete_; }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool is_complete_ = true;
};

/// Nothing if this is no object of counts.
std::optional<Counts> counts_of(std::string_view text) {
  constexpr double kEnd = 9007199254740992.0;  // 2^53: exact up to here
  const auto object = host::read_json(text);
  if (!object || !object->is(host::JsonValue::Kind::object)) return std::nullopt;
  Counts counts;
  for (std::size_t i = 0; i < object->items.size(); ++i) {
    const host::JsonValue& count = object->items[i];
    if (!count.is(host::JsonValue::Kind::number) || !(count.number >= 0.0 && count.number < kEnd) ||
        count.number != std::floor(count.number))
      return std::nullopt;
    counts[object->names[i]] = static_cast<std::uint64_t>(count.number);
  }
  return counts;
}

std::string text_of(const Counts& counts) {
  host::Json json;
  json.begin_object();
  for (const auto& [name, count] : counts) json.key(name).whole(count);
  return json.end_object().str();
}

}  // namespace

Counts read_counts(const char* json) {
  std::optional<Counts> counts = counts_of(json);
  if (!counts)
    throw client::Problem(client::kInputOutput,
                          "the library says in an unknown way what it counted",
                          "build it again with this version of eagerx-gen");
  return *counts;
}

std::string record_of(std::uint32_t chunk, const Results& results) {
  std::string body;
  append(body, &chunk, 1);
  append(body, results.returns.data(), results.size());
  append(body, results.steps.data(), results.size());
  append(body, results.flags.data(), results.size());
  append(body, results.states.data(), results.states.size());
  body += text_of(results.counts);
  std::string record;
  const auto size = static_cast<std::uint32_t>(body.size());
  const std::uint64_t sum = host::fnv1a(body);
  append(record, &size, 1);
  append(record, &sum, 1);
  return record + body;
}

std::size_t find_record(std::string_view bytes, std::size_t from, const Plan& plan,
                        std::size_t& work) {
  constexpr std::size_t kHead = sizeof(std::uint32_t) + sizeof(std::uint64_t);
  for (std::size_t at = from; at + kHead + sizeof(std::uint32_t) <= bytes.size(); ++at) {
    Reader reader(bytes.substr(at));
    const auto size = reader.take<std::uint32_t>();
    const auto sum = reader.take<std::uint64_t>();
    if (size > reader.left() || size < sizeof(std::uint32_t)) continue;
    const std::string_view body = reader.take_bytes(size);
    std::uint32_t chunk = 0;
    std::memcpy(&chunk, body.data(), sizeof chunk);
    if (chunk >= plan.chunks() || !body.ends_with('}')) continue;
    if (size > work) break;
    work -= size;
    if (host::fnv1a(body) == sum) return at;
  }
  return std::string_view::npos;
}

std::optional<Record> take_record(std::string_view& bytes, const Plan& plan) {
  Reader reader(bytes);
  const auto size = reader.take<std::uint32_t>();
  const auto sum = reader.take<std::uint64_t>();
  const std::string_view body = reader.take_bytes(size);
  if (!reader.is_complete() || host::fnv1a(body) != sum) return std::nullopt;
  Reader in(body);
  const auto chunk = in.take<std::uint32_t>();
  // Cheaper than a reader of JSON.
  if (chunk >= plan.chunks() || !body.ends_with('}')) return std::nullopt;
  Record record{chunk, Results(plan.size_of(chunk), plan.width())};
  Results& part = record.results;
  in.take(part.returns.data(), part.size());
  in.take(part.steps.data(), part.size());
  in.take(part.flags.data(), part.size());
  in.take(part.states.data(), part.states.size());
  const std::optional<Counts> counts = counts_of(in.take_bytes(in.left()));
  if (!in.is_complete() || !counts) return std::nullopt;
  part.counts = *counts;
  bytes.remove_prefix(bytes.size() - reader.left());
  return record;
}

}  // namespace eagerx::campaign

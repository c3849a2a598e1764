// A hub that continues while its parts calculate: it requests a message when the message is sent,
// and waits for it when it is read. It does not wait for messages that a delay holds back, and
// independent parts calculate at the same time. The messages of each tick and the order of the
// trace do not change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/link/star.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/window.hpp>
#include <new>
#include <type_traits>

namespace eagerx::link {

/// A message of the trace that waits for its turn; its bytes follow.
struct alignas(16) Record {
  void (*tell)(void* hooks, Record& record);
  std::uint64_t seq;
  std::uint32_t channel;
  std::uint32_t bytes;  // with this header
  bool is_there;        // else it is still to come
};

/// A channel with an expected message.
template <class Message>
struct Awaited {
  std::uint32_t channel;
};

/// Messages in the order of the trace, from the first missing one on: a ring of bytes that never
/// splits a message. All zero at the start.
template <class Hooks, std::size_t Bytes>
class LaterMessages {
 public:
  bool empty() const { return first_ == end_; }

  /// Whether add() can be called for all of these.
  template <class... Message>
  bool has_room() {
    constexpr std::size_t kBytes = (kBytesOf<Message> + ...);
    if (empty()) first_ = end_ = 0;
    if (end_ < first_) return first_ - end_ > kBytes;
    if (Bytes - end_ >= kBytes) return true;
    if (first_ <= kBytes) return false;
    wrap_ = end_;
    end_ = 0;
    return true;
  }
  template <class Message>
  Record* add(std::uint32_t channel, Seq seq) {
    static_assert(std::is_trivially_copyable_v<Message> && alignof(Message) <= alignof(Record));
    auto* const record =
        ::new (bytes_ + end_) Record{&tell<Message>, seq, channel, kBytesOf<Message>, false};
    end_ += kBytesOf<Message>;
    return record;
  }
  /// Stores the message of a record.
  template <class Message>
  static void fill(Record& record, const Message& message) {
    std::memcpy(&record + 1, &message, sizeof message);
    record.is_there = true;
  }
  /// The next record of those that has_room() checked together.
  static Record* after(Record* record) {
    return reinterpret_cast<Record*>(reinterpret_cast<unsigned char*>(record) + record->bytes);
  }
  /// Passes messages to the hooks, up to the first missing one.
  void flush(Hooks& hooks) {
    while (!empty()) {
      auto* const record = reinterpret_cast<Record*>(bytes_ + first_);
      if (!record->is_there) return;
      record->tell(&hooks, *record);
      const bool wraps = end_ < first_ && first_ + record->bytes == wrap_;
      first_ = wraps ? 0 : first_ + record->bytes;
    }
  }
  void clear() { first_ = end_ = 0; }

 private:
  template <class Message>
  static constexpr std::uint32_t kBytesOf = sizeof(Record) +
                                            (sizeof(Message) + alignof(Record) - 1) /
                                                alignof(Record) * alignof(Record);

  template <class Message>
  static void tell(void* hooks, Record& record) {
    Message message;
    std::memcpy(&message, &record + 1, sizeof message);
    static_cast<Hooks*>(hooks)->on_message(record.channel, record.seq, message);
  }

  alignas(Record) unsigned char bytes_[Bytes];
  std::size_t first_, end_;
  std::size_t wrap_;  // where the messages end that are followed by that at the beginning
};

/// `Owner` is the hub's program, with a member `hooks` and a link() that is a Star of `Parts`
/// links. `Most`: maximum number of ticks of a part's nodes in flight; `Bytes`: size of the pending
/// trace. If either is full, the hub waits. All zero at the start.
template <class Owner, class Hooks, std::size_t Parts, std::size_t Most, std::size_t Bytes>
class Pipeline {
 public:
  /// Reads the messages that a node sends at tick `n`; false if the connection has ended. `record`:
  /// that of its first message, null if the trace waits for nothing.
  using Take = bool (Owner::*)(Seq n, Record* record);

  /// Requests from part `K` the messages that `take` reads. False if the connection has ended.
  template <std::size_t K, class... Message>
  bool request(Owner& owner, PartIndex<K> part, Take take, Seq n, Awaited<Message>... awaited) {
    auto& link = owner.link();
    if (held_ || !link.is_pipelined()) return (owner.*take)(n, nullptr);
    Queue& queue = queues_[K];
    while ((link.is_full(part) || queue.count == Most) && queue.count > 0) {
      if (!take_next(owner, queue)) return false;
    }
    Record* const record = reserve(n, awaited...);
    if (record == nullptr) return drain(owner) && (owner.*take)(n, nullptr);
    link.submit(part);
    queue.waiting[(queue.first + queue.count++) % Most] = {take, n, record};
    return link.ok();
  }

  /// At tick `n` of a node of `from`: forwards its message of `lag` ticks earlier to `to`, the
  /// first message immediately, and waits for it if necessary. The node's messages are in `ring`;
  /// `taken` have arrived. False if the connection has ended.
  template <class From, class To, class Message, std::size_t Capacity>
  bool hand_on(Owner& owner, From from, const Seq& taken, Seq n, Seq lag, To to,
               const Message (&ring)[Capacity]) {
    if (!comes_late(n, lag)) return true;
    const Seq sent = sent_before(n, lag);
    need(owner, from, taken, sent + 1);
    if (!owner.link().ok()) return false;
    owner.link().put(to, ring[ring_position<Capacity>(sent)]);
    return true;
  }

  /// Returns `count` once that many messages of a node of part `K` have arrived; `taken` have
  /// arrived so far.
  template <std::size_t K>
  Seq need(Owner& owner, PartIndex<K> /*part*/, const Seq& taken, Seq count) {
    Queue& queue = queues_[K];
    while (taken < count && queue.count > 0) {
      if (!take_next(owner, queue)) break;
    }
    return count;
  }

  /// Waits for all messages in flight. False if the connection has ended.
  bool drain(Owner& owner) {
    for (Queue& queue : queues_) {
      while (queue.count > 0) {
        if (!take_next(owner, queue)) return false;
      }
    }
    return true;
  }

  /// Waits for all messages, and from then on for each message when it is requested, because parts
  /// also send messages without a request. False if the connection has ended.
  bool hold(Owner& owner) {
    held_ = true;
    return drain(owner);
  }
  void resume() { held_ = false; }

  /// A message of the trace.
  template <class Message>
  void tell(Owner& owner, std::uint32_t channel, Seq seq, Message& message) {
    if (!later_.empty()) {
      if (later_.template has_room<Message>()) {
        later_.fill(*later_.template add<Message>(channel, seq), message);
        return;
      }
      if (!drain(owner)) return;
    }
    owner.hooks.on_message(channel, seq, message);
  }
  /// The same for a message that arrived over a link.
  template <class Message>
  void came(Owner& owner, Record*& record, std::uint32_t channel, Seq seq, Message& message) {
    if (record == nullptr) return tell(owner, channel, seq, message);
    Record* const next = later_.after(record);
    later_.fill(*record, message);
    record = next;
    later_.flush(owner.hooks);
  }

 private:
  struct Waiting {
    Take take;
    Seq n;
    Record* record;
  };
  /// The expected messages of one part, in its sending order.
  struct Queue {
    Waiting waiting[Most];
    std::size_t first, count;
  };

  bool take_next(Owner& owner, Queue& queue) {
    const Waiting next = queue.waiting[queue.first];
    queue.first = (queue.first + 1) % Most;
    --queue.count;
    if (owner.link().ok() && (owner.*next.take)(next.n, next.record)) return true;
    // A trace ends at a missing message.
    for (Queue& each : queues_) each.count = 0;
    later_.clear();
    return false;
  }

  template <class First, class... Message>
  Record* reserve(Seq n, Awaited<First> first, Awaited<Message>... awaited) {
    if (!later_.template has_room<First, Message...>()) return nullptr;
    Record* const record = later_.template add<First>(first.channel, n);
    (later_.template add<Message>(awaited.channel, n), ...);
    return record;
  }

  Queue queues_[Parts];
  LaterMessages<Hooks, Bytes> later_;
  bool held_;
};

}  // namespace eagerx::link

// The numbers that a program remembers: its state.
#pragma once

#include <algorithm>
#include <cstddef>
#include <eagerx/number.hpp>
#include <eagerx/rate.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace eagerx::linearize {

/// One of them. In a ring of messages, the one `age` messages before the newest.
struct Word {
  std::string name;
  std::ptrdiff_t offset = 0;  // in the program; in a ring, of the first message
  std::ptrdiff_t clock = -1;  // in the program: how many messages were sent; -1: in no ring
  std::size_t age = 0, capacity = 1;
  std::ptrdiff_t stride = 0;  // of a message
  std::string owner;          // the node or object whose memory it is; empty: messages
};

template <class Program>
Number& at(Program& program, const Word& word) {
  auto* const base = reinterpret_cast<unsigned char*>(&program);
  std::ptrdiff_t offset = word.offset;
  if (word.clock >= 0) {
    const Seq sent = *reinterpret_cast<const Seq*>(base + word.clock);
    // Before `capacity` messages were sent, these places have their initial contents.
    const Seq place = (sent + word.capacity * word.age - 1 - word.age) % word.capacity;
    offset += static_cast<std::ptrdiff_t>(place) * word.stride;
  }
  return *reinterpret_cast<Number*>(base + offset);
}

/// Makes words of the places where the numbers of a program began to exist.
class WordList {
 public:
  WordList(const void* program, std::size_t bytes, const std::vector<const void*>& places)
      : base_(static_cast<const unsigned char*>(program)) {
    for (const void* each : places) {
      const std::ptrdiff_t offset = static_cast<const unsigned char*>(each) - base_;
      if (offset >= 0 && offset < static_cast<std::ptrdiff_t>(bytes)) offsets_.push_back(offset);
    }
    std::sort(offsets_.begin(), offsets_.end());
    offsets_.erase(std::unique(offsets_.begin(), offsets_.end()), offsets_.end());
  }

  std::vector<Word> words;

  template <class Message, std::size_t Capacity>
  void ring(const char* name, Message (&messages)[Capacity], const Seq& clock) {
    const auto inside = offsets_in(messages[0]);
    for (std::size_t age = 0; age < Capacity; ++age) {
      for (std::size_t i = 0; i < inside.size(); ++i) {
        const std::string element =
            std::is_same_v<Message, Number> ? "" : "[" + std::to_string(i) + "]";
        words.push_back({name + element + before(age), inside[i], offset_of(clock), age, Capacity,
                         static_cast<std::ptrdiff_t>(sizeof(Message))});
      }
    }
  }
  template <class Part>
  void part(const char* name, Part& part) {
    std::vector<std::pair<std::ptrdiff_t, std::string>> known;
    if constexpr (requires { part.state, part.input, part.parameters; }) {
      add_known(part.state, "state", known);
      add_known(part.input, "input", known);
      add_known(part.parameters, "parameters", known);
    }
    std::size_t i = 0;
    for (const std::ptrdiff_t offset : offsets_in(part)) {
      const auto found = std::find_if(known.begin(), known.end(),
                                      [&](const auto& each) { return each.first == offset; });
      const std::string element =
          found != known.end() ? found->second : "number[" + std::to_string(i++) + "]";
      Word word{std::string(name) + "." + element, offset};
      word.owner = name;
      words.push_back(std::move(word));
    }
  }

 private:
  static std::string before(std::size_t age) {
    return age == 0 ? "" : " " + std::to_string(age) + " before";
  }
  template <class Part>
  std::ptrdiff_t offset_of(const Part& part) const {
    return reinterpret_cast<const unsigned char*>(&part) - base_;
  }
  template <class Part>
  std::vector<std::ptrdiff_t> offsets_in(const Part& part) const {
    const std::ptrdiff_t begin = offset_of(part);
    const auto first = std::lower_bound(offsets_.begin(), offsets_.end(), begin);
    return {first, std::lower_bound(first, offsets_.end(),
                                    begin + static_cast<std::ptrdiff_t>(sizeof(Part)))};
  }
  template <class Member>
  void add_known(const Member& member, const std::string& name,
                 std::vector<std::pair<std::ptrdiff_t, std::string>>& known) const {
    std::size_t i = 0;
    for (const std::ptrdiff_t offset : offsets_in(member))
      known.emplace_back(offset, name + "[" + std::to_string(i++) + "]");
  }

  const unsigned char* base_;
  std::vector<std::ptrdiff_t> offsets_;
};

}  // namespace eagerx::linearize

// Records of a line with a key that somebody changes on their way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <runtime/host/key/session.hpp>
#include <vector>

namespace eagerx::fuzz {

using Line = std::vector<std::uint8_t>;

/// One right record, then the next one with a change, then what the data are, from the hub of a
/// `Session` to its part. open_all(part, line, text) is how many records of `text` it has opened.
/// `most`: bytes of a record.
template <class Session, class OpenAll>
void send_records(const std::uint8_t* data, std::size_t size, std::size_t most,
                  OpenAll&& open_all) {
  Session session;
  const Line text(data, data + std::min(size, most));
  const auto sealed = [&] {
    Line line(key::Records::kMostSealed);
    line.resize(session.hub.seal(text.data(), text.size(), line.data()));
    return line;
  };
  Line line = sealed(), next = sealed();
  const std::uint8_t changes = data[size - 1] | 1U;  // never 0
  next[(data[0] | std::size_t{data[size / 2]} << 8U) % next.size()] ^= changes;
  line.insert(line.end(), next.begin(), next.end());
  line.insert(line.end(), data, data + size);
  if (open_all(session.part, line, text) != 1) std::abort();
  Session other;
  open_all(other.part, Line(data, data + size), Line());
}

}  // namespace eagerx::fuzz

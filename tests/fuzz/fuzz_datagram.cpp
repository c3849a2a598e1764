// Any bytes as datagrams of a program, one a line: what is shown of them has a bound.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "generator/tools/monitor/datagram.hpp"
#include "generator/tools/monitor/lines.hpp"
#include "generator/tools/monitor/screen_lines.hpp"
#include "generator/tools/monitor/step_order.hpp"

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eagerx::gen;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  StepOrder order;
  Model model(nullptr);
  std::int64_t now_ns = 0;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto datagram = read_datagram(line);
    if (!datagram) continue;
    now_ns += 1'000'000;
    model.now(now_ns);
    if (order.place(*datagram, now_ns) == StepOrder::Place::first) model.begin({});
    const auto time_ns = static_cast<std::int64_t>(datagram->time_s * 1e9);
    for (const DatagramMessage& message : datagram->messages) {
      if (message.values.size() > kMostStreamElements || message.values.empty()) std::abort();
      model.message({.channel = message.channel,
                     .values = message.values,
                     .elements = message.elements,
                     .episode = datagram->episode,
                     .time_ns = time_ns,
                     .real_ns = now_ns});
    }
    model.step({datagram->episode, datagram->step, time_ns, now_ns});
  }
  if (model.channels().size() > kMostStreamChannels) std::abort();
  if (lines_text(model).empty()) std::abort();
  ScreenView view;
  constexpr std::array<Key, 5> kKeys = {Key::down, Key::enter, Key::end, Key::escape, Key::up};
  for (const Key key : kKeys) {
    if (screen_lines(model, view, {}, "udp:1", "").size() != ScreenSize().rows) std::abort();
    press({key}, model, view);
  }
  return 0;
}

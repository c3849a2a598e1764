#include "generator/tools/monitor/step_order.hpp"

namespace eagerx::gen {

StepOrder::Place StepOrder::place(const Datagram& datagram, std::int64_t now_ns) {
  constexpr std::int64_t kSilenceNs = 1'000'000'000;  // after which another program may speak
  lost_ = 0;
  const bool silent = now_ns - came_ns_ > kSilenceNs;
  if (running_ && datagram.graph_hash != hash_ && !silent && datagram.step != 0)
    return Place::foreign;
  const bool is_earlier = datagram.time_s < time_s_ || datagram.episode < episode_ ||
                          (datagram.episode == episode_ && datagram.step < step_);
  // A run begins with step 0; one that is seen from the middle on comes after a silence.
  const bool begins = !running_ || datagram.graph_hash != hash_ ||
                      (is_earlier && (silent || (datagram.step == 0 && datagram.episode == 0)));
  if (!begins && is_earlier) return Place::late;
  came_ns_ = now_ns;
  return begins ? begin(datagram) : follow(datagram);
}

StepOrder::Place StepOrder::begin(const Datagram& datagram) {
  running_ = true;
  hash_ = datagram.graph_hash;
  stride_ = 0;
  time_s_ = datagram.time_s;
  episode_ = datagram.episode;
  step_ = datagram.step;
  return Place::first;
}

StepOrder::Place StepOrder::follow(const Datagram& datagram) {
  const bool is_same = datagram.episode == episode_ && datagram.step == step_;
  if (datagram.episode == episode_ && !is_same) {
    const std::uint64_t gap = datagram.step - step_;
    if (stride_ == 0 || gap < stride_) stride_ = gap;
    lost_ = (gap - 1) / stride_;
  }
  time_s_ = datagram.time_s;
  episode_ = datagram.episode;
  step_ = datagram.step;
  return is_same ? Place::same : Place::next;
}

}  // namespace eagerx::gen

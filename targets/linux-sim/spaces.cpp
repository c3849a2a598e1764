#include <runtime/host/base/number.hpp>
#include <string>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/spaces.hpp>

namespace eagerx::linux_sim {

void SpaceCounts::note(std::uint32_t channel, Seq seq, std::size_t element, double value) {
  if (total_++ == 0) {
    channel_ = channel;
    seq_ = seq;
    element_ = element;
    value_ = value;
  }
  ++counts_[channel];
}

void SpaceCounts::list(CountListener& listener) const {
  for (std::size_t i = 0; i < facts_->channel_count; ++i) {
    const std::string name = std::string("out of its space: ") + facts_->channels[i].name;
    listener.count(name.c_str(), counts_[i]);
  }
}

std::string SpaceCounts::first() const {
  const auto shown = [](double x) { return host::number_text(static_cast<float>(x)); };
  const Channel& what = facts_->channels[channel_];
  const Bounds& bounds = facts_->bounds[what.first + (what.bounds == 1 ? 0 : element_)];
  return "`" + std::string(what.name) + "` left its space, from " + shown(bounds.low) + " to " +
         shown(bounds.high) + ": element " + std::to_string(element_) + " of message " +
         std::to_string(seq_) + " is " + shown(value_);
}

}  // namespace eagerx::linux_sim

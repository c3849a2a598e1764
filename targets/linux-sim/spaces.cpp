#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/spaces.hpp>

namespace eagerx::linux_sim {

std::string space_problem(const char* channel, const Bounds& bounds, std::size_t element, Seq seq,
                          double value) {
  const auto shown = [](double x) { return number_text(static_cast<float>(x)); };
  return "`" + std::string(channel) + "` left its space, from " + shown(bounds.low) + " to " +
         shown(bounds.high) + ": element " + std::to_string(element) + " of message " +
         std::to_string(seq) + " is " + shown(value);
}

}  // namespace eagerx::linux_sim

#include <algorithm>
#include <array>
#include <charconv>
#include <targets/linux-sim/describe.hpp>

namespace eagerx::linux_sim {
namespace {

template <class T>
std::string shortest(T value) {
  constexpr std::size_t kLongestNumber = 32;
  std::array<char, kLongestNumber> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

std::string number_text(float value) {
  return shortest(value);
}
std::string number_text(double value) {
  return shortest(value);
}
std::string number_text(std::int64_t value) {
  return shortest(value);
}

void Description::heading(std::string_view text) {
  text_.append(text).append("\n");
}

void Description::field(std::string_view name, std::string_view kind, std::size_t bytes,
                        std::initializer_list<std::size_t> shape) {
  constexpr std::size_t kColumn = 24;
  constexpr std::size_t kBitsPerByte = 8;
  std::string line = "  " + std::string(name);
  line.resize(std::max(line.size() + 1, kColumn), ' ');
  line.append(kind);
  if (kind != "bool") line += std::to_string(bytes * kBitsPerByte);
  line += ", shape [";
  for (const std::size_t size : shape) {
    if (line.back() != '[') line += ", ";
    line += std::to_string(size);
  }
  text_ += line + "]";
}

void Description::window(std::uint32_t size) {
  if (size > 1) text_ += ", the last " + std::to_string(size);
}

void Description::Side::add(const std::string& bound) {
  if (all.empty()) first = bound;
  equal = equal && bound == first;
  if (!all.empty()) all += ", ";
  all += bound;
}

void Description::bound_text(const std::string& low, const std::string& high) {
  low_.add(low);
  high_.add(high);
}

void Description::bounds_end() {
  text_ += ", from " + low_.text() + " to " + high_.text();
  low_ = {};
  high_ = {};
}

}  // namespace eagerx::linux_sim

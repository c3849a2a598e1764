#include "generator/tools/monitor/written_number.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace eagerx::gen {

double written_number(trace_log::Dtype dtype, std::uint64_t bits) {
  double number = trace_log::number_of(dtype, bits);
  if (dtype != trace_log::Dtype::float32 || !std::isfinite(number)) return number;
  const std::string text = trace_log::text_of(dtype, bits);
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace eagerx::gen

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <eagerx/float_environment.hpp>
#include <string>
#include <targets/environments/base/checks.hpp>
#include <targets/environments/base/problem.hpp>

namespace eagerx::environments {
namespace {

constexpr std::uint32_t kMostThreads = 1024;

std::string is_not(const char* name, std::uint64_t given, std::uint64_t least, std::uint64_t most) {
  return std::string(name) + " is " + std::to_string(given) + ", not " + std::to_string(least) +
         " to " + std::to_string(most);
}

}  // namespace

void RightFloats::set_right() {
  if (calculates_as_everywhere()) return;
  std::fegetenv(&callers_);
  std::fesetenv(FE_DFL_ENV);
  changed_ = true;
  if (!calculates_as_everywhere()) {
    std::fesetenv(&callers_);
    refuse("this processor flushes denormal numbers to zero, or does not round to nearest");
  }
}

void check_options(const eagerx_options* options) {
  if (options == nullptr) refuse("options is null");
  check_size("eagerx_options", options->size, sizeof(eagerx_options));
  if (options->environments == 0 || options->environments > EAGERX_ENVIRONMENTS_MOST)
    refuse(is_not("environments", options->environments, 1, EAGERX_ENVIRONMENTS_MOST));
  if (options->autoreset > EAGERX_DISABLED)
    refuse(is_not("autoreset", options->autoreset, 0, EAGERX_DISABLED));
  if (options->pictures > 1)
    refuse("pictures is " + std::to_string(options->pictures) + ", not 0 or 1");
  if (options->threads > kMostThreads) refuse(is_not("threads", options->threads, 0, kMostThreads));
}

void refuse_size(const char* name, std::size_t given, std::size_t wanted) {
  refuse(std::string(name) + " is of another version: its size is " + std::to_string(given) +
         ", not " + std::to_string(wanted));
}
void check_side(const char* name, std::uint32_t pixels, std::uint32_t most) {
  if (pixels < 1 || pixels > most) refuse(is_not(name, pixels, 1, most));
}
void check_number(std::uint32_t environment, std::uint32_t size) {
  if (environment < size) return;
  refuse("there is no environment " + std::to_string(environment) + ", but 0 to " +
         std::to_string(size - 1));
}
void check_rows(const char* name, const void* rows, std::size_t numbers) {
  if (rows == nullptr && numbers != 0) refuse(std::string(name) + " is null");
}

}  // namespace eagerx::environments

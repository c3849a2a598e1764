#include <cfenv>
#include <eagerx/float_environment.hpp>
#include <targets/linux-sim/float_environment.hpp>

namespace eagerx::linux_sim {

const char* const kFloatsWentWrong =
    "error: code in this program changed the floating-point mode, during the run: it "
    "flushes denormal numbers to zero, or does not round to nearest\n"
    "help: there is no hash, because other machines have other bits. Look for `-ffast-math`, "
    "`fesetround` or `_MM_SET_FLUSH_ZERO_MODE` in libraries and entities";

bool put_floats_right(bool& was_wrong) {
  was_wrong = !calculates_as_everywhere();
  if (!was_wrong) return true;
  std::fesetenv(FE_DFL_ENV);
  return calculates_as_everywhere();
}

}  // namespace eagerx::linux_sim

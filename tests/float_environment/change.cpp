// Changes the floating-point mode, as a library may do at run time: EAGERX_TEST_FLOATS=flush or
// =round.
#include <cfenv>
#include <cstdlib>
#include <string_view>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

extern "C" void eagerx_run_begins();
extern "C" void eagerx_run_begins() {
  const char* const what = std::getenv("EAGERX_TEST_FLOATS");
  if (what == nullptr) return;
  if (std::string_view(what) == "round") std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
  if (std::string_view(what) == "flush") _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
}

/* What entities/half/half.hpp does. */
#include "part.h"

void half_reset(void) {}

void half_step(uint64_t n, const struct half_in* in, struct half_out* out) {
  (void)n;
  out->half[0] = 0.5f * in->signal[in->signal_size - 1][0];
}

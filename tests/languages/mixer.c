/* The three nodes of part `mixer` in C: what entities/mixer/mixer.hpp does, number by number. */
#include <string.h>

#include "part.h"

struct mixer {
  float mean[2];
  uint64_t seen;
};
static struct mixer of_late, of_mix, of_slow;

static void mix_sums(struct mixer* self, float weight, float a, float b, uint64_t seen) {
  self->mean[0] = weight * self->mean[0] + a;
  self->mean[1] = weight * self->mean[1] + b;
  self->seen += seen;
}

static float sum(const float* values, uint32_t count) {
  float result = 0.0f;
  for (uint32_t i = 0; i < count; ++i) result = result + values[i];
  return result;
}

/* `in->a` is an array of messages, so its elements lie one behind the other. */
#define MIXER(NODE, WEIGHT)                                                                       \
  void NODE##_reset(void) { memset(&of_##NODE, 0, sizeof of_##NODE); }                            \
  void NODE##_step(uint64_t n, const struct NODE##_in* in, struct NODE##_out* out) {              \
    const uint32_t numbers = in->a_size * (uint32_t)(sizeof *in->a / sizeof(float));              \
    mix_sums(&of_##NODE, WEIGHT, sum((const float*)in->a, numbers), sum(in->b, in->b_size),       \
             in->a_size + in->b_size);                                                            \
    memcpy(out->mean, of_##NODE.mean, sizeof out->mean);                                          \
    out->seen = (int64_t)of_##NODE.seen;                                                          \
    out->high[0] = of_##NODE.mean[0] > 0.0f;                                                      \
    out->high[1] = of_##NODE.mean[1] > 0.0f;                                                      \
    out->high[2] = n % 2 == 1;                                                                    \
  }

MIXER(late, 0.5f)
MIXER(mix, 0.5f)
MIXER(slow, 0.25f)

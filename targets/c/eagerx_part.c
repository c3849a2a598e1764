/* Schedule of a part: targets/PROTOCOL.md. */
#include "eagerx_part.h"

#include <stdio.h>
#include <string.h>

#include "eagerx_link.h"

enum { kStep = 1, kReset = 2, kFinish = 3, kSafeStep = 4 };
enum { kEpisode = 17, kReport = 9, kMostRates = 64 };
enum { kExitWrong = 1 };

/* A program has one part. */
static struct {
  const struct eagerx_part* part;
  uint64_t time, ticks[kMostRates];
} g;

static int64_t floor_div(int64_t x, int64_t y) {
  return x >= 0 ? x / y : -((-x + y - 1) / y);
}

uint32_t eagerx_take(struct eagerx_input* input, uint64_t n) {
  const int64_t tick = (int64_t)n;
  const uint64_t before = input->received;
  const int64_t sent = floor_div(input->a * tick - input->x, input->b) + 1;
  if (!input->skip) {
    input->received = sent < 1 ? 1 : (uint64_t)sent;
  } else if (n > 0) {
    const int64_t ahead = tick + input->off;
    const int64_t more = floor_div(input->a * ahead - input->x, input->b) -
                         floor_div(input->a * (ahead - 1) - input->x, input->b);
    const int64_t arriving = more < sent ? more : sent;
    input->received += arriving > 0 ? (uint64_t)arriving : 0;
  }
  uint64_t size = input->received - before;
  if (input->size > 0) size = input->received < input->size ? input->received : input->size;
  const struct eagerx_message* const message = input->message;
  for (uint64_t i = 0; i < size; ++i) {
    const uint64_t seq = input->received - size + i;
    memcpy((uint8_t*)input->window + i * message->bytes,
           message->ring + seq % message->keep * message->bytes, message->bytes);
  }
  return (uint32_t)size;
}

void eagerx_put(const struct eagerx_message* message, uint64_t n, const void* bytes) {
  uint8_t* const place = message->ring + n % message->keep * message->bytes;
  memcpy(place, bytes, message->bytes);
  eagerx_link_put(place, message->bytes);
}

static void receive(const struct eagerx_message* message, uint64_t n) {
  uint8_t* const place = message->ring + n % message->keep * message->bytes;
  eagerx_link_get(place, message->bytes);
  for (uint32_t i = 0; message->is_bool && i < message->bytes; ++i) place[i] = place[i] != 0;
}

static int is_due(uint32_t rate) {
  return g.time % g.part->periods[rate] == 0;
}

static void take_turns(const struct eagerx_turn* turns, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (!is_due(turns[i].rate)) continue;
    const uint64_t n = g.ticks[turns[i].rate] - 1;
    if (turns[i].run != 0) turns[i].run(n);
    for (uint32_t k = 0; turns[i].run == 0 && k < turns[i].count; ++k)
      receive(&g.part->messages[turns[i].messages[k]], n);
  }
}

static void begin_slot(void) {
  for (uint32_t rate = 0; rate < g.part->rates; ++rate) g.ticks[rate] += is_due(rate) ? 1 : 0;
  take_turns(g.part->before, g.part->before_count);
}

static void reset(void) {
  uint8_t episode[kEpisode]; /* unused, because only parts in C++ have sampled states */
  eagerx_link_get(episode, sizeof episode);
  g.time = 0;
  memset(g.ticks, 0, sizeof g.ticks);
  g.part->reset();
  begin_slot();
}

static void step(void) {
  uint8_t late;
  eagerx_link_get(&late, 1);
  for (uint32_t i = 0; i < g.part->action_count; ++i)
    receive(&g.part->messages[g.part->actions[i]], g.ticks[g.part->step_rate] - 1);
  do {
    take_turns(g.part->after, g.part->after_count);
    uint64_t next = UINT64_MAX;
    for (uint32_t rate = 0; rate < g.part->rates; ++rate) {
      const uint64_t tick = (g.time / g.part->periods[rate] + 1) * g.part->periods[rate];
      next = tick < next ? tick : next;
    }
    g.time = next;
    begin_slot();
  } while (!is_due(g.part->step_rate));
}

static void run_session(void) {
  int has_begun = 0;
  for (;;) {
    uint8_t command;
    eagerx_link_get(&command, 1);
    if (command == kReset) {
      reset();
      has_begun = 1;
    } else if (has_begun && (command == kStep || (command == kSafeStep && g.part->safe_steps))) {
      step();
    } else if (command == kFinish) {
      uint8_t report[kReport] = {0};
      for (int i = 0; i < 4; ++i) report[4 + i] = (uint8_t)(eagerx_link_damaged() >> 8 * i);
      eagerx_link_put(report, sizeof report);
    } else {
      eagerx_link_stop(EAGERX_WRONG, "no hub of this graph sends this command");
    }
  }
}

int eagerx_run(const struct eagerx_part* part) {
  g.part = part;
  if (part->rates > kMostRates || !eagerx_link_begin(part))
    return fprintf(stderr, "error: out of memory\n"), kExitWrong;
  const enum eagerx_ending how = (enum eagerx_ending)setjmp(eagerx_link_end);
  if (how == EAGERX_GOES_ON || how == EAGERX_SESSION_OVER) {
    eagerx_link_wait();
    run_session();
  }
  if (how == EAGERX_WRONG) fprintf(stderr, "error: %s\n", eagerx_link_why());
  eagerx_link_free();
  return how == EAGERX_WRONG ? kExitWrong : 0;
}

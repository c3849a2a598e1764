/* Part of a graph in C: its tables, as specified in targets/PROTOCOL.md. */
#ifndef EAGERX_PART_H
#define EAGERX_PART_H

#include <stdint.h>

/* Newest messages of one output. Message `seq` is at index `seq % keep`. */
struct eagerx_message {
  uint8_t* ring;
  uint32_t bytes, keep;
  int is_bool; /* bytes other than 0 and 1 become 1 */
};

/* Input of a node, and the number of messages that it has received: runtime/SEMANTICS.md,
 * section 3. */
struct eagerx_input {
  const struct eagerx_message* message;
  void* window; /* messages in the window, oldest first */
  uint32_t size;
  int skip;
  int64_t a, b, x, off;
  uint64_t received;
};

/* Action of a node at a tick: it runs here, or (if run is 0) its messages come from the hub. */
struct eagerx_turn {
  uint32_t rate;
  void (*run)(uint64_t n);
  const uint32_t* messages;
  uint32_t count;
};

struct eagerx_part {
  const char *name, *of_graph;
  uint64_t hash;
  uint16_t runtime;
  uint32_t most_to_part, most_to_hub;
  uint32_t depth; /* requests that the hub sends without waiting, and answers that the part keeps */
  const uint64_t* periods;
  uint32_t rates, step_rate;
  int safe_steps;
  struct eagerx_message* messages;
  const uint32_t* actions;
  uint32_t action_count;
  const struct eagerx_turn* before;
  uint32_t before_count;
  const struct eagerx_turn* after;
  uint32_t after_count;
  void (*reset)(void);
};

/* Fills the window of an input at tick n. Must be called once at every tick. Returns the number of
 * messages in the window. */
uint32_t eagerx_take(struct eagerx_input* input, uint64_t n);
/* Sends message n of an output to the hub, and stores it. */
void eagerx_put(const struct eagerx_message* message, uint64_t n, const void* bytes);
/* Program of a part: `--listen ADDRESS` or `--link TTY`, and `--key FILE`. Serves one hub, and
 * returns the exit code. */
int eagerx_serve(int argc, char** argv, const struct eagerx_part* part);
/* Same as eagerx_serve(), over a connection that is already open: eagerx_line.h. */
int eagerx_run(const struct eagerx_part* part);

#endif

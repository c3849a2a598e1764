/* A program in C99 that uses the library of a graph: check OBSERVATION ACTION STATES TERMS MANY,
   the numbers of a row of each, and environments enough to be worth several threads. Wrong calls
   are refused; an environment's rows are the same alone, in batches, on threads and in all three
   modes of autoreset; nothing allocates between creation and end. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "eagerx_environments.h"

/* tests/support/no_alloc.cpp */
void eagerx_run_begins(void);
void eagerx_run_ends(void);

enum { MOST = 64, EPISODES = 3, LONGEST = 20 };

static size_t observed, acted, states_size, terms_size;
static int failures = 0;

static void expect(int good, const char* what) {
  printf("%s %s\n", good ? "ok  " : "FAIL", what);
  failures += !good;
}

static void expect_error(int failed, const char* text, const char* what) {
  const char* said = eagerx_error();
  const int good = failed && strstr(said, text) != NULL;
  printf("%s %s: %s\n", good ? "ok  " : "FAIL", what, said);
  failures += !good;
}

static eagerx_options plain(uint32_t environments) {
  eagerx_options options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.environments = environments;
  options.seed = 7;
  options.longest = LONGEST;
  options.threads = 1;
  return options;
}

/* Buffers of a batch. */
typedef struct {
  eagerx_rows rows;
  float* action;
  uint8_t* mask;
  uint32_t* steps; /* of each environment, without resets */
  uint32_t* done;  /* episodes */
  uint8_t* ended;
  uint64_t* digest; /* of all rows of each environment */
} buffers;

static void* room(size_t count, size_t bytes) {
  void* result = calloc(count ? count : 1, bytes);
  if (result == NULL) exit(3);
  return result;
}

static buffers make(uint32_t n) {
  buffers b;
  memset(&b, 0, sizeof b);
  b.rows.size = sizeof b.rows;
  b.rows.observation = room(n * observed, sizeof(float));
  b.rows.final_observation = room(n * observed, sizeof(float));
  b.rows.reward = room(n, sizeof(float));
  b.rows.terminated = room(n, 1);
  b.rows.truncated = room(n, 1);
  b.rows.success = room(n, 1);
  b.rows.terms = room(n * terms_size, sizeof(float));
  b.action = room(n * acted, sizeof(float));
  b.mask = room(n, 1);
  b.steps = room(n, sizeof(uint32_t));
  b.done = room(n, sizeof(uint32_t));
  b.ended = room(n, 1);
  b.digest = room(n, sizeof(uint64_t));
  return b;
}

static void drop(buffers* b) {
  free(b->rows.observation);
  free(b->rows.final_observation);
  free(b->rows.reward);
  free(b->rows.terminated);
  free(b->rows.truncated);
  free(b->rows.success);
  free(b->rows.terms);
  free(b->action);
  free(b->mask);
  free(b->steps);
  free(b->done);
  free(b->ended);
  free(b->digest);
}

static void fold(uint64_t* digest, const void* bytes, size_t count) {
  const unsigned char* p = bytes;
  for (size_t i = 0; i < count; ++i) *digest = (*digest ^ p[i]) * 0x100000001b3u;
}

/* The same for an environment's step wherever it is in a batch; sometimes beyond the bounds. */
static float action_of(uint32_t number, uint32_t step, size_t i) {
  const uint32_t mixed = (number * 2654435761u) ^ (step * 40503u) ^ (uint32_t)(i * 9176u);
  return (float)(mixed % 2003u) / 400.0f - 2.5f;
}

/* EPISODES episodes of environments first to first + n - 1, whose digests go to `digest`. False: a
 * call failed. */
static int episodes(uint32_t first, uint32_t n, uint32_t autoreset, uint32_t threads,
                    uint64_t* digest) {
  const size_t row = observed * sizeof(float);
  uint32_t* numbers = room(n, sizeof(uint32_t));
  for (uint32_t k = 0; k < n; ++k) numbers[k] = first + k;
  eagerx_options options = plain(n);
  options.numbers = numbers;
  options.autoreset = autoreset;
  options.threads = threads;
  eagerx_environments* batch = eagerx_create(&options);
  free(numbers);
  if (batch == NULL) return 0;
  buffers b = make(n);
  int good = 1;
  eagerx_run_begins();
  good = good && eagerx_reset(batch, NULL, NULL, b.rows.observation) == 0;
  for (uint32_t k = 0; k < n; ++k) fold(&b.digest[k], b.rows.observation + k * observed, row);
  for (uint32_t left = n; good && left > 0;) {
    for (uint32_t k = 0; k < n; ++k) {
      for (size_t i = 0; i < acted; ++i)
        b.action[k * acted + i] = action_of(first + k, b.steps[k], i);
    }
    good = eagerx_step(batch, b.action, &b.rows) == 0;
    int any = 0;
    for (uint32_t k = 0; k < n; ++k) {
      const int end = b.rows.terminated[k] || b.rows.truncated[k];
      b.mask[k] = 0;
      if (b.ended[k]) { /* next step: this was the reset */
        good = good && !end && b.rows.reward[k] == 0.0f;
        b.ended[k] = 0;
        if (b.done[k] < EPISODES) fold(&b.digest[k], b.rows.observation + k * observed, row);
        continue;
      }
      ++b.steps[k];
      if (end && autoreset == EAGERX_NEXT_STEP) b.ended[k] = 1;
      if (end && autoreset == EAGERX_DISABLED) any = b.mask[k] = 1;
      if (b.done[k] == EPISODES) continue;
      const float* observation =
          end && autoreset == EAGERX_SAME_STEP ? b.rows.final_observation : b.rows.observation;
      fold(&b.digest[k], observation + k * observed, row);
      fold(&b.digest[k], b.rows.reward + k, sizeof(float));
      fold(&b.digest[k], b.rows.terminated + k, 1);
      fold(&b.digest[k], b.rows.truncated + k, 1);
      fold(&b.digest[k], b.rows.success + k, 1);
      fold(&b.digest[k], b.rows.terms + k * terms_size, terms_size * sizeof(float));
      if (!end) continue;
      left -= ++b.done[k] == EPISODES;
      if (autoreset == EAGERX_SAME_STEP && b.done[k] < EPISODES)
        fold(&b.digest[k], b.rows.observation + k * observed, row);
    }
    if (any) {
      good = good && eagerx_reset(batch, b.mask, NULL, b.rows.observation) == 0;
      for (uint32_t k = 0; k < n; ++k) {
        if (b.mask[k] && b.done[k] < EPISODES)
          fold(&b.digest[k], b.rows.observation + k * observed, row);
      }
    }
  }
  eagerx_run_ends();
  memcpy(digest, b.digest, n * sizeof(uint64_t));
  eagerx_destroy(batch);
  drop(&b);
  return good;
}

static void check_equality(void) {
  static const char* const modes[] = {"next step", "same step", "disabled"};
  uint64_t alone[MOST], together[MOST];
  int good = 1, differ = 1;
  for (uint32_t k = 0; k < MOST; ++k) good = good && episodes(k, 1, EAGERX_NEXT_STEP, 1, alone + k);
  for (uint32_t k = 1; k < MOST; ++k) differ = differ && alone[k] != alone[k - 1];
  expect(good && differ, "environments alone, each with samples of its own");
  for (uint32_t mode = EAGERX_NEXT_STEP; mode <= EAGERX_DISABLED; ++mode) {
    char text[100];
    int same = episodes(0, MOST, mode, 1, together) && memcmp(alone, together, sizeof alone) == 0;
    sprintf(text, "%d at once, autoreset %s", (int)MOST, modes[mode]);
    expect(same, text);
    same = episodes(0, MOST, mode, 3, together) && memcmp(alone, together, sizeof alone) == 0;
    sprintf(text, "%d at once on three threads, autoreset %s", (int)MOST, modes[mode]);
    expect(same, text);
    same =
        episodes(5, 17, mode, 2, together) && memcmp(alone + 5, together, 17 * sizeof *alone) == 0;
    sprintf(text, "numbers 5 to 21 on two threads, autoreset %s", modes[mode]);
    expect(same, text);
  }
}

static void check_threads(uint32_t many) {
  uint64_t* alone = room(many, sizeof(uint64_t));
  uint64_t* together = room(many, sizeof(uint64_t));
  const int good = episodes(0, many, EAGERX_SAME_STEP, 1, alone) &&
                   episodes(0, many, EAGERX_SAME_STEP, 3, together) &&
                   memcmp(alone, together, many * sizeof *alone) == 0;
  char text[100];
  sprintf(text, "%u on three threads, as on one", (unsigned)many);
  expect(good, text);
  free(alone);
  free(together);
}

static void check_options(void) {
  eagerx_options options = plain(0);
  expect_error(eagerx_create(NULL) == NULL, "options is null", "no options");
  expect_error(eagerx_create(&options) == NULL, "environments is 0, not 1 to 1000000",
               "no environments");
  options.environments = 10000000;
  expect_error(eagerx_create(&options) == NULL, "environments is 10000000",
               "ten million environments");
  options = plain(4);
  options.size = 12;
  expect_error(eagerx_create(&options) == NULL, "eagerx_options is of another version",
               "options of another size");
  options = plain(4);
  options.autoreset = 3;
  expect_error(eagerx_create(&options) == NULL, "autoreset is 3", "autoreset 3");
  options = plain(4);
  options.threads = 1025;
  expect_error(eagerx_create(&options) == NULL, "threads is 1025", "too many threads");
  options = plain(4);
  options.pictures = 2;
  expect_error(eagerx_create(&options) == NULL, "pictures is 2, not 0 or 1", "pictures 2");
}

/* Graphs without `render:` say so; others draw. */
static void check_pictures(void) {
  eagerx_options options = plain(2);
  uint8_t pixels[8 * 8 * 3] = {0};
  options.pictures = 1;
  eagerx_environments* batch = eagerx_create(&options);
  if (strstr(eagerx_describe(), "\"render\": null") != NULL) {
    expect_error(batch == NULL, "has no `render:`", "pictures of a graph without any");
    return;
  }
  const int good = batch != NULL && eagerx_picture(batch, 1, 8, 8, pixels) == 0;
  expect(good && pixels[0] == 255 && pixels[8 * 8 * 3 - 1] == 255,
         "a white picture before the first reset");
  eagerx_destroy(batch);
}

static void check_calls(void) {
  eagerx_options options = plain(4);
  eagerx_environments* batch = eagerx_create(&options);
  buffers b = make(4);
  float* states = room(4 * states_size, sizeof(float));
  expect_error(eagerx_step(NULL, b.action, &b.rows) != 0, "environments is null", "step of null");
  expect_error(eagerx_reset(NULL, NULL, NULL, NULL) != 0, "environments is null", "reset of null");
  expect_error(eagerx_counts(NULL) == NULL, "environments is null", "counts of null");
  eagerx_destroy(NULL);
  expect_error(eagerx_step(batch, b.action, &b.rows) != 0, "environment 0 has not begun",
               "step before a reset");
  b.mask[0] = b.mask[1] = 1;
  eagerx_reset(batch, b.mask, NULL, NULL);
  expect_error(eagerx_step(batch, b.action, &b.rows) != 0, "environment 2 has not begun",
               "step of some before a reset");
  expect_error(eagerx_get_states(batch, states) != 0, "environment 2 has not begun",
               "states before a reset");
  expect_error(eagerx_act(batch, b.rows.observation, b.action) != 0, "environment 2 has not begun",
               "agent before a reset");
  expect_error(eagerx_critic(batch, NULL, NULL) != 0, "environment 2 has not begun",
               "what the critic sees before a reset");
  eagerx_reset(batch, NULL, NULL, NULL);
  expect_error(eagerx_step(batch, NULL, &b.rows) != 0, "action is null", "no action");
  expect_error(eagerx_act(batch, b.rows.observation, NULL) != 0, "action is null",
               "agent without a row for its action");
  expect_error(eagerx_act(batch, NULL, b.action) != 0, "observation is null",
               "agent without an observation");
  b.rows.size = 8;
  expect_error(eagerx_step(batch, b.action, &b.rows) != 0, "eagerx_rows is of another version",
               "rows of another size");
  expect_error(eagerx_set_states(batch, NULL, NULL) != 0, "states is null", "set no states");
  expect_error(eagerx_get_states(batch, NULL) != 0, "states is null", "get no states");
  expect_error(eagerx_get_exact_states(batch, NULL) != 0, "states is null", "get no exact states");
  expect_error(eagerx_trace(batch, 4, "") != 0, "there is no environment 4, but 0 to 3",
               "trace of environment 4");
  expect_error(eagerx_trace(batch, 0, "/no/such/file") != 0, "cannot write `/no/such/file`",
               "trace to nowhere");
  eagerx_environments* other = eagerx_create(&options);
  remove("check.trace");
  expect(eagerx_trace(batch, 0, "check.trace") == 0, "a trace");
  expect_error(eagerx_trace(batch, 1, "check.trace") != 0, "another environment's trace goes into",
               "two traces of a batch into one file");
  expect_error(eagerx_trace(other, 0, "./check.trace") != 0,
               "another environment's trace goes into", "two traces of two batches into one file");
  expect(eagerx_trace(batch, 0, NULL) == 0 && eagerx_trace(other, 0, "check.trace") == 0,
         "the file is free again");
  eagerx_destroy(other);
  expect(remove("check.trace") != 0, "a trace without an episode leaves no file");
  expect_error(eagerx_hash(batch, 4) == 0, "there is no environment 4, but 0 to 3",
               "hash of environment 4");
  for (size_t i = 0; i < 4 * states_size; ++i) states[i] = 1e30f;
  expect_error(eagerx_set_states(batch, NULL, states) != 0, "out of its space",
               "states out of their space");
  expect(eagerx_step(batch, b.action, NULL) == 0, "a step without rows");
  memset(b.mask, 0, 4);
  expect(eagerx_reset(batch, b.mask, NULL, NULL) == 0, "a reset of no environment");
  expect(eagerx_hash(batch, 0) == 0, "no hash without a trace");
  uint8_t pixels[3];
  expect_error(eagerx_picture(batch, 0, 1, 1, pixels) != 0, "draw nothing",
               "a picture of environments that do not draw");
  expect_error(eagerx_picture(batch, 0, 1, 0, pixels) != 0, "height is 0, not 1 to 4096",
               "a picture without height");
  expect_error(eagerx_picture(batch, 0, 1, 1, NULL) != 0, "pixels is null", "a picture to nowhere");
  eagerx_destroy(batch);
  drop(&b);
  free(states);
}

/* What is not a number does not reach an actuator, is counted, and leaves observations finite. */
static void check_not_finite(void) {
  eagerx_options options = plain(4);
  eagerx_environments* batch = eagerx_create(&options);
  buffers b = make(4);
  int finite = eagerx_reset(batch, NULL, NULL, NULL) == 0;
  for (size_t i = 0; i < 4 * acted; ++i) b.action[i] = i % 2 ? (float)INFINITY : (float)NAN;
  for (int step = 0; step < 5; ++step) {
    finite = finite && eagerx_step(batch, b.action, &b.rows) == 0;
    for (size_t i = 0; i < 2 * observed; ++i)
      finite = finite && (step < 2 || !isinf(b.rows.observation[i]));
  }
  expect(finite, "actions that are not numbers");
  const char* counts = eagerx_counts(batch);
  expect(counts != NULL && strstr(counts, "\"safe: action not finite: ") != NULL, counts);
  eagerx_destroy(batch);
  drop(&b);
}

/* States that are set are those of the next episode, and only of it; the others are sampled. */
static void check_states(void) {
  eagerx_options options = plain(4);
  eagerx_environments* batch = eagerx_create(&options);
  buffers b = make(4);
  const size_t bytes = 4 * states_size * sizeof(float);
  float* sampled = room(4 * states_size, sizeof(float));
  float* set = room(4 * states_size, sizeof(float));
  float* got = room(4 * states_size, sizeof(float));
  uint64_t seeds[4] = {3, 3, 4, 4};
  int good = eagerx_reset(batch, NULL, seeds, b.rows.observation) == 0 &&
             eagerx_get_states(batch, sampled) == 0;
  for (size_t i = 0; i < 4 * states_size; ++i) set[i] = NAN;
  memcpy(set + states_size, sampled,
         states_size * sizeof(float)); /* environment 1 begins as environment 0 did */
  b.mask[1] = 1;
  good = good && eagerx_set_states(batch, b.mask, set) == 0 &&
         eagerx_reset(batch, b.mask, NULL, NULL) == 0;
  good = good && eagerx_get_states(batch, got) == 0;
  memcpy(set, sampled, bytes);
  memcpy(set + states_size, sampled, states_size * sizeof(float));
  expect(good && memcmp(got, set, bytes) == 0, "states that are set");
  good = eagerx_reset(batch, NULL, seeds, b.rows.final_observation) == 0 &&
         eagerx_get_states(batch, got) == 0;
  expect(good && memcmp(got, sampled, bytes) == 0, "and sampled again for the episode behind it");
  expect(memcmp(b.rows.observation, b.rows.final_observation, 4 * observed * sizeof(float)) == 0,
         "a seed gives the same observations again");
  double* exact = room(4 * states_size, sizeof(double));
  good = eagerx_get_exact_states(batch, exact) == 0;
  for (size_t i = 0; i < 4 * states_size; ++i)
    good = good && ((float)exact[i] == sampled[i] || (exact[i] != exact[i] && sampled[i] != sampled[i]));
  expect(good, "the states as doubles are the same");
  free(exact);
  free(sampled);
  free(set);
  free(got);
  eagerx_destroy(batch);
  drop(&b);
}

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  observed = (size_t)atoi(argv[1]);
  acted = (size_t)atoi(argv[2]);
  states_size = (size_t)atoi(argv[3]);
  terms_size = (size_t)atoi(argv[4]);
  expect(eagerx_version() == EAGERX_ENVIRONMENTS_VERSION, "version");
  check_options();
  check_pictures();
  check_calls();
  check_not_finite();
  check_states();
  check_equality();
  check_threads((uint32_t)atoi(argv[5]));
  printf("%d failed\n", failures);
  return failures != 0;
}

/* A program in C against the C interface: every function with its type, every field, every constant. It must compile, and
   on 64-bit machines the structs must have these layouts, so that programs that are already built still fit. */
#include <eagerx_environments.h>
#include <stddef.h>

#define IS(condition, name) typedef char name[(condition) ? 1 : -1]

IS(EAGERX_NEXT_STEP == 0, next_step_is_0);
IS(EAGERX_SAME_STEP == 1, same_step_is_1);
IS(EAGERX_DISABLED == 2, disabled_is_2);
IS(EAGERX_ENVIRONMENTS_VERSION >= 5, version_grows);
IS(EAGERX_ENVIRONMENTS_MOST >= 1000000, as_many_environments);
IS(sizeof(void*) != 8 || (offsetof(eagerx_options, numbers) == 8 && offsetof(eagerx_options, seed) == 16 && offsetof(eagerx_options, pictures) == 36), options_layout);
IS(sizeof(void*) != 8 || (offsetof(eagerx_rows, observation) == 8 && offsetof(eagerx_rows, final_observation) == 56), rows_layout);

int step_once(const float* action, float* observation, uint8_t* pixels);
int step_once(const float* action, float* observation, uint8_t* pixels) {
  uint32_t (*const version)(void) = eagerx_version;
  const char* (*const describe)(void) = eagerx_describe;
  const char* (*const error)(void) = eagerx_error;
  eagerx_environments* (*const create)(const eagerx_options*) = eagerx_create;
  void (*const destroy)(eagerx_environments*) = eagerx_destroy;
  int (*const reset)(eagerx_environments*, const uint8_t*, const uint64_t*, float*) = eagerx_reset;
  int (*const step)(eagerx_environments*, const float*, const eagerx_rows*) = eagerx_step;
  int (*const act)(eagerx_environments*, const float*, float*) = eagerx_act;
  int (*const set_states)(eagerx_environments*, const uint8_t*, const float*) = eagerx_set_states;
  int (*const tune)(eagerx_environments*, const uint8_t*, const float*) = eagerx_tune;
  int (*const get_states)(eagerx_environments*, float*) = eagerx_get_states;
  int (*const get_exact_states)(eagerx_environments*, double*) = eagerx_get_exact_states;
  int (*const set_stage)(eagerx_environments*, const uint8_t*, const char*) = eagerx_set_stage;
  int (*const critic)(eagerx_environments*, float*, float*) = eagerx_critic;
  int (*const trace)(eagerx_environments*, uint32_t, const char*) = eagerx_trace;
  uint64_t (*const hash)(eagerx_environments*, uint32_t) = eagerx_hash;
  int (*const picture)(eagerx_environments*, uint32_t, uint32_t, uint32_t, uint8_t*) = eagerx_picture;
  const char* (*const stepping)(eagerx_environments*) = eagerx_stepping;
  const char* (*const counts)(eagerx_environments*) = eagerx_counts;

  const eagerx_options options = {.size = sizeof(eagerx_options), .environments = 1, .numbers = NULL, .seed = 1, .longest = 0,
                                  .autoreset = EAGERX_DISABLED, .threads = 1, .pictures = 1};
  float reward = 0.0F, terms = 0.0F, given = 0.0F, states = 0.0F;
  double exact = 0.0;
  uint8_t terminated = 0, truncated = 0, success = 0;
  const eagerx_rows rows = {.size = sizeof(eagerx_rows), .observation = observation, .reward = &reward, .terminated = &terminated,
                            .truncated = &truncated, .success = &success, .terms = &terms, .final_observation = NULL};
  eagerx_environments* const environments = version() == EAGERX_ENVIRONMENTS_VERSION ? create(&options) : NULL;
  int problems = environments == NULL || *error() != 0 || describe() == NULL;
  problems |= trace(environments, 0, "") | set_stage(environments, NULL, NULL) | reset(environments, NULL, NULL, observation);
  problems |= set_states(environments, NULL, &states) | tune(environments, NULL, &states) | act(environments, observation, &given);
  problems |= step(environments, action, &rows) | get_states(environments, &states) | get_exact_states(environments, &exact);
  problems |= critic(environments, NULL, NULL) | picture(environments, 0, 16, 16, pixels);
  problems |= hash(environments, 0) == 0 || stepping(environments) == NULL || counts(environments) == NULL;
  destroy(environments);
  return problems;
}

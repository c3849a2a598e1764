/* Many environments of one graph as a library: the C99 interface of `lib<graph>_environments.so`
   for programs in C, C++, Python and other languages.

   - Functions that return int return 0 on success, or -1 with the reason in eagerx_error().
   eagerx_step() can also return 1. Nothing is printed or thrown.
   - The caller owns all buffers. A buffer has contiguous rows, one for each environment:
   `[environments][numbers]` is row-major float32. Columns are sorted by the names of the actions,
   observations and states, not in the order of the graph's file; eagerx_describe() lists them.
   Numbers of other types are converted.
   - The samples of an environment depend only on (seed, number, episode): it has the same bits
   alone, in any batch and on any number of threads. Number k of seed S equals `PROGRAM --seed S
   --environment k` of target linux-sim.
   - Only one thread at a time can call a function of one `eagerx_environments`; a concurrent call
   is an error. Several `eagerx_environments` are independent.
   - A call that is rejected changes nothing: environments are as they were before it.
   - The following cases are undefined and not detected: a buffer or an array that is shorter than
   documented; an invalid pointer other than null; a string without a terminator; environments that
   eagerx_create() did not create, or that were destroyed; eagerx_destroy() while another thread is
   in a call with the same environments, or begins one; a buffer that another thread uses during the
   call; a struct with the right `size` and uninitialized fields.
   - eagerx_create() allocates the memory. After it, only the first eagerx_set_states(),
   eagerx_trace(), eagerx_counts() and a reward that is not finite allocate more. */
#ifndef EAGERX_ENVIRONMENTS_H
#define EAGERX_ENVIRONMENTS_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. A program compares it with eagerx_version() before any other call. */
#define EAGERX_ENVIRONMENTS_VERSION 5

/* Maximum number of environments in eagerx_create(). */
#define EAGERX_ENVIRONMENTS_MOST 1000000

typedef struct eagerx_environments eagerx_environments;

/* When an environment begins its next episode:
   - NEXT_STEP: in the next eagerx_step(), which resets it instead, with reward 0 and no end.
   - SAME_STEP: in the step that ends the episode. `observation` is the first one of the new
   episode, and `final_observation` the last one of the old episode.
   - DISABLED: in eagerx_reset(). Until then it does not change, with reward 0 and no end. */
enum { EAGERX_NEXT_STEP = 0, EAGERX_SAME_STEP = 1, EAGERX_DISABLED = 2 };

typedef struct {
  uint32_t size;           /* sizeof(eagerx_options) */
  uint32_t environments;   /* 1 to EAGERX_ENVIRONMENTS_MOST */
  const uint32_t* numbers; /* [environments] number of each; null: 0, 1, 2, ... Copied. Equal
                              numbers sample the same values unless their seeds differ */
  uint64_t seed;           /* of all environments, until eagerx_reset() sets others */
  uint32_t longest;   /* steps until `truncated`, in addition to the `task:`; 0: only the task */
  uint32_t autoreset; /* EAGERX_NEXT_STEP, EAGERX_SAME_STEP or EAGERX_DISABLED */
  uint32_t threads;   /* 0: one for each core */
  uint32_t pictures; /* 1: enables eagerx_picture(). Environments then run one by one, with the same
                        bits */
} eagerx_options;

/* Results of a step. A null pointer is not written. */
typedef struct {
  uint32_t size;       /* sizeof(eagerx_rows) */
  float* observation;  /* [environments][numbers of an observation] */
  float* reward;       /* [environments] */
  uint8_t* terminated; /* [environments] 1: the task ended the episode, by success or failure */
  uint8_t* truncated;  /* [environments] 1: the time limit is reached */
  uint8_t* success;    /* [environments] 1: the task's `success:` holds after this step */
  float* terms;        /* [environments][terms] weighted terms of the reward */
  float* final_observation; /* [environments][numbers of an observation] only rows whose episode
                               ended, SAME_STEP only */
} eagerx_rows;

/* Returns EAGERX_ENVIRONMENTS_VERSION of the library. */
uint32_t eagerx_version(void);

/* Returns a description as JSON, valid as long as the library is loaded:
   - "version": 5, "generator": "0.9", "graph": "pendulum_swing_up", "engine": "OdeEngine".
   - "hash": "0x…", with which a policy must agree.
   - "rate_hz": 30.
   - "isa": "avx512", "lanes": 64 if vectorized; otherwise 1 lane and "why_no_lanes".
   - "observations": [{"name": "angle", "shape": [2], "dtype": "float32", "window": 1, "low": […],
   "high": […], "first": 0}, …], in the order of the columns. `first` is the column of the first
   number. A window of w > 1 messages is the first number of the shape. Infinite bounds are null.
   - "actions" and "states": the same without window.
   - "tunable": ["controller.kp", …], states that eagerx_tune() sets.
   - "agent": "policy", "zero", "random" or "csv", which eagerx_act() runs.
   - "task": null or {"terms": ["angle", …], "success": true, "episode_steps": 150, "critic": […],
   "stages": [{"name": "near", "success": 0.9, "return": null}, …]}. `episode_steps` is 0 if the
   task has no limit. `critic` has the form of observations, without bounds. `success` and `return`
   of a stage are what a training must reach in it, or null.
   - "render": null or {"rate_hz": 30}. */
const char* eagerx_describe(void);

/* Returns the reason for the last failure in this thread, or for the last result of 1; "" if there
   is none. The text is valid until the next one. A successful call does not clear it, so ask only
   after another result than 0. */
const char* eagerx_error(void);

/* Returns null on failure, with the reason in eagerx_error(). */
eagerx_environments* eagerx_create(const eagerx_options* options);

/* Ignores null. Open traces end without their last line. */
void eagerx_destroy(eagerx_environments* environments);

/* Begins an episode in all environments, or in those where `mask` is not 0.
   - mask: [environments], or null for all.
   - seeds: [environments], or null for the next episode of the current seed. With seeds, episode 0
   of each seed.
   - observation: [environments][numbers of an observation], or null. Only the rows of environments
   that begin are written. */
int eagerx_reset(eagerx_environments* environments, const uint8_t* mask, const uint64_t* seeds,
                 float* observation);

/* Makes one step of all environments, each of which must have begun.
   - action: [environments][numbers of an action], not null unless the graph has no actions. The
   graph's guard applies: the safe action replaces numbers that are not finite, and other numbers
   are moved into their spaces; eagerx_counts() counts both.
   - rows: the results that the caller wants, or null.

   Returns 1 if a reward is not finite. The step is made and the rows are written. eagerx_error()
   names the term, the environment and the step, and eagerx_counts() has the steps of each term.

   Returns -1 with "cannot write ..." if writing the file of a trace fails. Here, too, the step is
   made and the rows are written. That trace ends, and the next steps continue without it. */
int eagerx_step(eagerx_environments* environments, const float* action, const eagerx_rows* rows);

/* Runs the graph's `agent:` (policy, zero or random) and writes the action of the next
   eagerx_step(). Call it once per step, because a policy can have memory. Actions have the bits of
   the program of target linux-sim.
   - observation: [environments][numbers of an observation], the last one that eagerx_reset() or
   eagerx_step() wrote.
   - action: [environments][numbers of an action]. Rows whose episode has ended are not written. */
int eagerx_act(eagerx_environments* environments, const float* observation, float* action);

/* Sets the states and delays of the next episode, in environments where `mask` is not 0 (null:
   all).
   - states: [environments][numbers of the states]. NaN: sampled as the graph specifies.

   A value outside of its space is an error, and nothing is set. Delays are doubles: 0.1F is 0.1 s,
   the shortest decimal that reads back to it. */
int eagerx_set_states(eagerx_environments* environments, const uint8_t* mask, const float* states);

/* Sets parameters of running episodes, in environments where `mask` is not 0 (null: all), each of
   which must have begun. Call it between two steps; the parameters take effect with the next
   action, and keep their values until they are set again, also after a reset.
   - states: [environments][numbers of the states]. NaN: unchanged. Set all numbers of a state, or
   none.

   A state that is not `tunable`, or a value outside of its space, is an error, and nothing is set.
   Traces record the change, and replays repeat it. */
int eagerx_tune(eagerx_environments* environments, const uint8_t* mask, const float* states);

/* Reads the states with which the episodes began.
   - states: [environments][numbers of the states]. NaN where nothing was set or sampled. */
int eagerx_get_states(eagerx_environments* environments, float* states);
/* Reads the same states as doubles, which represent 32-bit seeds and delays exactly. */
int eagerx_get_exact_states(eagerx_environments* environments, double* states);

/* Selects a stage of the graph's task for environments where `mask` is not 0 (null: all), from
   their next reset on. A stage samples some states differently, and has its own weights of the
   reward and its terms. The reward in a trace remains that of the graph as written.
   - stage: its name; null or "" for the graph as written, which is the default. */
int eagerx_set_stage(eagerx_environments* environments, const uint8_t* mask, const char* stage);

/* Reads the additional inputs of the critic in a training, `critic:` of the graph's task, as of the
   last step or reset.
   - critic: [environments][numbers of the critic], or null.
   - final_critic: [environments][numbers of the critic], or null. Only rows whose episode the last
   step ended are written, SAME_STEP only. */
int eagerx_critic(eagerx_environments* environments, float* critic, float* final_critic);

/* Writes every message of an environment (0 to environments - 1), from its next reset on, to a file
   for `eagerx-gen replay`. A null path ends the file; "" computes only the hash. A file holds one
   trace: a second trace is an error, also from other environments and programs. Without a reset,
   the file keeps its previous content. A replay knows only the seed of the first reset, so call
   this function again before a reset with another seed. */
int eagerx_trace(eagerx_environments* environments, uint32_t environment, const char* path);

/* Returns the hash of all messages of an environment since its trace began, equal to that of
   `--hash` in the program of target linux-sim for the same episodes. Returns 0 without
   eagerx_trace(), or with eagerx_error() for an environment that does not exist and during another
   thread's call. */
uint64_t eagerx_hash(eagerx_environments* environments, uint32_t environment);

/* Draws a picture of an environment, if `pictures` of eagerx_options is 1: what the graph's
   `render:` showed last, or white if it has shown nothing since the reset. Equal on every machine.
   - width, height: 1 to 4096 pixels.
   - pixels: [height][width][3] red, green, blue, from the top row down. */
int eagerx_picture(eagerx_environments* environments, uint32_t environment, uint32_t width,
                   uint32_t height, uint8_t* pixels);

/* Returns how the environments are stepped, and why not faster: "vectorized: 64 lanes (avx512)",
   "one by one: `imu` (ImuSensor) has no `vectorized: true` in its manifest …", "one by one: 1
   environment is too few for SIMD lanes". Valid until the next call with these environments.
   Returns null on failure, with the reason in eagerx_error(). */
const char* eagerx_stepping(eagerx_environments* environments);

/* Returns as JSON the counts of guards and nodes in all environments that are not 0, such as
   {"safe: action not finite: voltage": 3}, and the number of steps in which a term of the reward
   was not finite, such as {"not finite: task.angle": 12}. Valid until the next call with these
   environments. Returns null on failure, with the reason in eagerx_error(). */
const char* eagerx_counts(eagerx_environments* environments);

#ifdef __cplusplus
}
#endif
#endif

/* Many environments of one graph, as a library: what `lib<graph>_environments.so` gives to programs
   in C, C++, Python and others. Plain C99.

   - Functions that return int return 0, or -1 and eagerx_error() says why (eagerx_step() also 1,
   see there). Nothing is printed or thrown.
   - Buffers belong to the caller. They are rows without gaps, one for each environment:
   `[environments][numbers]` is row-major float32. Columns are in the order of the names of the
   actions, observations and states, not in that of the graph's file; eagerx_describe() lists them.
   Numbers of another type are converted.
   - An environment's samples depend on (seed, number, episode) and on nothing else: it has the same
   bits alone, in any batch and on any number of threads. Number k of seed S is `PROGRAM --seed S
   --environment k` of target linux-sim.
   - Of one `eagerx_environments` one thread calls a function at a time, else the later call is an
   error; several of them are independent.
   - What a call refuses changes nothing: environments are as they were before it.
   - Not noticed, and undefined: a buffer or an array that is shorter than said here; a pointer that
   points to nothing, other than null; strings without an end; environments that eagerx_create() did
   not make, or that were destroyed; eagerx_destroy() while another thread is in a call with the
   same environments, or begins one; a buffer that another thread uses during the call; a struct
   whose `size` is right and whose fields are not set.
   - Memory is taken by eagerx_create(). After it, only the first eagerx_set_states(),
   eagerx_trace(), eagerx_counts() and a reward that is not finite take some. */
#ifndef EAGERX_ENVIRONMENTS_H
#define EAGERX_ENVIRONMENTS_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this interface. A program asks eagerx_version() before anything else and compares. */
#define EAGERX_ENVIRONMENTS_VERSION 5

/* The most environments that eagerx_create() takes. */
#define EAGERX_ENVIRONMENTS_MOST 1000000

typedef struct eagerx_environments eagerx_environments;

/* When an environment whose episode has ended begins again:
   NEXT_STEP  with the next eagerx_step(): instead of a step there is a reset, with reward 0 and no
   end; SAME_STEP  within the step that ends it; `observation` is the first one of the new episode
   and `final_observation` the last one of the old episode; DISABLED   with eagerx_reset(): until
   then it stays as it is, with reward 0 and no end. */
enum { EAGERX_NEXT_STEP = 0, EAGERX_SAME_STEP = 1, EAGERX_DISABLED = 2 };

typedef struct {
  uint32_t size;           /* sizeof(eagerx_options) */
  uint32_t environments;   /* 1 to EAGERX_ENVIRONMENTS_MOST */
  const uint32_t* numbers; /* [environments] number of each; null: 0, 1, 2, ... Copied. Several may
                              be equal: they sample the same unless their seeds differ */
  uint64_t seed;           /* of all, until eagerx_reset() gives others */
  uint32_t
      longest; /* steps until `truncated`, besides what the graph's `task:` says; 0: only that */
  uint32_t autoreset; /* EAGERX_NEXT_STEP, EAGERX_SAME_STEP or EAGERX_DISABLED */
  uint32_t threads;   /* 0: one for each core */
  uint32_t pictures;  /* 1: eagerx_picture() can be called. Environments then run one by one; the
                         same bits */
} eagerx_options;

/* Where a step writes; a null pointer is not written. */
typedef struct {
  uint32_t size;            /* sizeof(eagerx_rows) */
  float* observation;       /* [environments][numbers of an observation] */
  float* reward;            /* [environments] */
  uint8_t* terminated;      /* [environments] 1: the task's end, success or failure */
  uint8_t* truncated;       /* [environments] 1: the time is over */
  uint8_t* success;         /* [environments] 1: the task's `success:` holds as of this step */
  float* terms;             /* [environments][terms] of the reward, weighted */
  float* final_observation; /* [environments][numbers of an observation] rows whose episode ended,
                               SAME_STEP only */
} eagerx_rows;

/* EAGERX_ENVIRONMENTS_VERSION of the library. */
uint32_t eagerx_version(void);

/* JSON, valid as long as the library is loaded:
   {"version": 5, "generator": "0.9", "graph": "pendulum_swing_up", "engine": "OdeEngine", "hash":
   "0x…", "rate_hz": 30, "isa": "avx512", "lanes": 64,            if vectorized; else 1 and
   "why_no_lanes" "observations": [{"name": "angle", "shape": [2], "dtype": "float32", "window": 1,
   "low": […], "high": […], "first": 0}, …],   in the order of the columns; `first`: column of the
   first number; a window of w > 1 messages is the shape's first number; bounds that are infinite:
   null "actions": [same without window], "states": [same without window], "tunable":
   ["controller.kp", …],   states that eagerx_tune() sets "agent": "policy", "zero", "random" or
   "csv", which is what eagerx_act() does, "task": null or {"terms": ["angle", …], "success": true,
   "episode_steps": 150, "critic": [as observations, without bounds], "stages": [{"name": "near",
   "success": 0.9, "return": null}, …]}, "render": null or {"rate_hz": 30}} `hash`: of what a policy
   must agree with; `episode_steps`: 0 where the task says none; a stage's `success` and `return`:
   what must be reached in it, null if it is not asked. */
const char* eagerx_describe(void);

/* Why this thread's last call did not return 0; valid until the next one that does not. "" if all
   did. Whose call was right does not ask, because the text of an earlier one stays. */
const char* eagerx_error(void);

/* Null: eagerx_error() says why. */
eagerx_environments* eagerx_create(const eagerx_options* options);

/* Null is ignored. Open traces end without their last line. */
void eagerx_destroy(eagerx_environments* environments);

/* Begins an episode in all environments, or where `mask` is not 0.
   mask         [environments] or null: all
   seeds        [environments] or null: the next episode of the seed it has. With seeds, episode 0
   of them observation  [environments][numbers of an observation], only the rows of those that
   begin; or null */
int eagerx_reset(eagerx_environments* environments, const uint8_t* mask, const uint64_t* seeds,
                 float* observation);

/* One step of all environments, each of which must have begun.
   action  [environments][numbers of an action], not null unless the graph has no actions. The
   graph's guard is applied: numbers that are not finite become the safe action, others are moved
   into their spaces; eagerx_counts() counts rows    what of the step is wanted, or null 1: the step
   was made and the rows are written, but a reward is not finite. eagerx_error() then says which
   term, of which environment, in which step; eagerx_counts() has the steps of each term. -1 with
   "cannot write ...", the file of a trace: here, too, the step was made and the rows are written;
   that trace is over, the next steps continue without it */
int eagerx_step(eagerx_environments* environments, const float* action, const eagerx_rows* rows);

/* What the graph's `agent:` does (policy, zero or random): the action of the next eagerx_step(). To
   be called once a step, because a policy may remember what it has seen. Actions have the bits of
   the program of target linux-sim. observation  [environments][numbers of an observation] the last
   one, as eagerx_reset() or eagerx_step() wrote it action       [environments][numbers of an
   action]; rows whose episode has ended are not written */
int eagerx_act(eagerx_environments* environments, const float* observation, float* action);

/* The states and delays of the next episode, for environments where `mask` is not 0 (null: all).
   states  [environments][numbers of the states]; NaN: sampled as the graph says. One that is
   outside of its space is an error, and nothing is set. Delays are doubles: 0.1F is 0.1 s, the
   shortest decimal that reads back to it */
int eagerx_set_states(eagerx_environments* environments, const uint8_t* mask, const float* states);

/* Sets parameters of running episodes, for environments where `mask` is not 0 (null: all), each of
   which must have begun: between two steps, so that they act as the next action does. They stay
   until they are set again, also by a reset. states  [environments][numbers of the states]; NaN:
   stays as it is. All numbers of a state, or none. One that is not `tunable`, or outside of its
   space, is an error, and nothing is set. Traces have it, and replays repeat it */
int eagerx_tune(eagerx_environments* environments, const uint8_t* mask, const float* states);

/* states  [environments][numbers of the states] what the episodes began with; NaN where nothing was
 * set or sampled */
int eagerx_get_states(eagerx_environments* environments, float* states);
/* The same as doubles, which hold 32-bit seeds and delays exactly. */
int eagerx_get_exact_states(eagerx_environments* environments, double* states);

/* From their next reset on, episodes are those of a stage of the graph's task, for environments
   where `mask` is not 0 (null: all): states that it samples otherwise, and reward and terms with
   its weights. What a trace says of the reward stays as the graph is written. stage  its name; null
   or
   "": the graph as it is written, as at first */
int eagerx_set_stage(eagerx_environments* environments, const uint8_t* mask, const char* stage);

/* What the critic of a training sees besides the observations, as of the last step or reset:
   `critic:` of the graph's task. critic        [environments][numbers of the critic], or null
   final_critic  [environments][numbers of the critic], or null: rows whose episode the last step
   ended, SAME_STEP only; the others are as they were */
int eagerx_critic(eagerx_environments* environments, float* critic, float* final_critic);

/* From its next reset on, writes every message of an environment (0 to environments - 1) to a file,
   which `eagerx-gen replay` reads. Path null: ends the file; "": no file, only the hash. A file has
   one trace: another one's is refused, of whatever environments and programs. If no reset comes,
   what was in the file stays. A replay knows the seed of the first reset: before one with another
   seed, call this again. */
int eagerx_trace(eagerx_environments* environments, uint32_t environment, const char* path);

/* Hash of all messages of an environment since its trace began; 0 without eagerx_trace(), or with
   eagerx_error() for an environment that does not exist, and during another thread's call. The same
   as with `--hash` in the program of target linux-sim for the same episodes. */
uint64_t eagerx_hash(eagerx_environments* environments, uint32_t environment);

/* A picture of an environment, for `pictures` of eagerx_options: what the graph's `render:` showed
   last, or white if it has shown nothing since the reset. Equal on every machine. width, height  1
   to 4096 pixels pixels         [height][width][3] red, green, blue; the first row is the upper one
 */
int eagerx_picture(eagerx_environments* environments, uint32_t environment, uint32_t width,
                   uint32_t height, uint8_t* pixels);

/* How they are stepped, and what made that slower: "vectorized: 64 lanes (avx512)", "one by one:
   `imu` (ImuSensor) has no `vectorized: true` in its manifest …", "one by one: 1 environment is too
   few for SIMD lanes". Valid until the next call with these environments. Null: eagerx_error() says
   why. */
const char* eagerx_stepping(eagerx_environments* environments);

/* JSON: what guards and nodes of all environments have counted that is not 0, such as
   {"safe: action not finite: voltage": 3}; and the steps in which a term of the reward was not
   finite,
   {"not finite: task.angle": 12}. Valid until the next call with these environments. Null:
   eagerx_error() says why. */
const char* eagerx_counts(eagerx_environments* environments);

#ifdef __cplusplus
}
#endif
#endif

// Named settings of a training, and the tasks that they were measured on: `--preset NAME`.
// eagerx-train applies them, and eagerx-gen lists them.
#pragma once

#include <cstddef>

namespace eagerx::options {

struct Preset {
  const char* name;
  const char* algorithm;
  const char* values;  // "n_envs=512 n_steps=24": those that differ from the defaults
  const char* about;
  const char* measured;
};

inline constexpr Preset kTrainPresets[] = {
    {.name = "locomotion",
     .algorithm = "ppo",
     .values = "net_arch=128,64 n_envs=1024 n_steps=24 max_n_steps=24 n_minibatches=16 n_epochs=2 "
               "initial_std=0.5 min_std=0.1 target_kl=0.02 decay_steps=8000000 "
               "target_success_rate=0.97 eval_interval=25",
     .about = "legged robots whose steps are cheap: few epochs over many environments",
     .measured =
         "examples/quadruped_walking, `--steps 26000000`, seeds 1 to 3: 126 to 135 s on two "
         "cores (AVX-512); 96.4 to 97.6 % of 1,000 other episodes succeed"},
    {.name = "rare_goal",
     .algorithm = "ppo",
     .values = "n_steps=128",
     .about = "tasks whose goal an untrained policy rarely reaches: longer iterations",
     .measured = "MountainCarContinuous-v0, seeds 1 to 10: 10 of 10 succeed, after a median of "
                 "82,000 steps; with the defaults 2 of 5 within 1 M"},
    {.name = "reaching",
     .algorithm = "sac",
     .values = "net_arch=256,256 activation_fn=relu gamma=0.97 decay_steps=500000 sac_n_envs=16 "
               "utd_ratio=0.25 reward_scale=20 norm_window_steps=20000 eval_interval=40",
     .about = "arms that reach for targets: wide layers, scales that forget the beginning",
     .measured =
         "examples/arm_reaching, `--steps 2450000`, seeds 1 to 3: 1.9 to 2.3 M steps, 37 to "
         "43 minutes of a processor; 99.0 to 99.3 % of 4,000 other episodes succeed"},
    {.name = "swing_up",
     .algorithm = "sac",
     .values = "utd_ratio=2",
     .about = "pendulums in few steps, each of which takes twice the time: two updates",
     .measured = "Pendulum-v1, `--until-return -160`, seeds 1 to 10: a median of 3,580 steps in "
                 "1.7 s; with the defaults of SAC 5,120 in 1.3 s"},
};

/// A graph of at least as many numbers in an action is like that of `locomotion`: its 12, with a
/// margin that was not measured.
inline constexpr std::size_t kLocomotionActions = 8;

}  // namespace eagerx::options

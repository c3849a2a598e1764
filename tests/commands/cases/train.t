Nothing is built for a training that cannot be.
  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ eagerx-gen train "$graph" -o policy.safetensors
  error[E0370]: the graph has no `task:`, so there is nothing to learn
   --> <root>/tests/golden/multi_rate/graph.yaml:4:7
    |
  4 | name: multi_rate
    |       ^^^^^^^^^^
  help: add one that says what is good, when an episode ends, and what success is: `task: {inputs: {th: pendulum.theta}, reward: {upright: {value: th^2, weight: -1.0}}, truncated: {after: 5.0}, success: {upright: abs(th) < 0.15, over_last: 2.0}}`
  
  1 error
  [1]
  $ eagerx-gen train "$graph" -o no/policy
  error: cannot write `no/policy`: No such file or directory
  [3]
  $ eagerx-gen train "$graph" --seed 1x
  error: --seed: `1x` is not a number from 0 to 4611686018427387903
  help: `eagerx-gen train --help` lists the options
  [2]
  $ eagerx-gen train "$graph" --until-return --steps 3
  error: `--until-return` needs a value
  help: `eagerx-gen train --help` lists the options
  [2]
  $ eagerx-gen train "$graph" --algorithm es
  error: --algorithm: there is no algorithm `es`, only ppo and sac
  help: `eagerx-gen train --help` lists the options
  [2]
Settings by the names that other libraries use, and options.
  $ eagerx-gen train "$graph" --setting lr=0.001
  error: --setting: there is no setting `lr`
  help: it is `learning_rate` here; `eagerx-gen help train-settings` lists them
  [2]
  $ eagerx-gen train "$graph" --setting total_timesteps=1000
  error: --setting: there is no setting `total_timesteps`
  help: it is an option: `--steps N`
  [2]
  $ eagerx-gen train "$graph" --setting seed=2
  error: --setting: there is no setting `seed`
  help: it is an option: `--seed N`
  [2]
  $ eagerx-gen train "$graph" --setting n_envs=4
  error: --setting: n_envs: `4` is not a number from 8 to 65536
  help: `eagerx-gen help train-settings` lists settings and ranges
  [2]
Sweeps, before anything is built.
  $ trained=$root/examples/pendulum_training/graph.yaml
  $ sweep() {
  >   printf '%b\n' "$1" >sweep.yaml
  >   shift
  >   eagerx-gen train "$trained" --sweep sweep.yaml "$@"
  > }
  $ sweep 'settings: {learning_rat: [0.001]}'
  error[E0201]: unknown key `learning_rat` in settings of a training
   --> sweep.yaml:1:12
    |
  1 | settings: {learning_rat: [0.001]}
    |            ^^^^^^^^^^^^
  help: did you mean `learning_rate`?
  
  1 error
  [1]
  $ sweep 'settings: {clip_range: {from: 0.3, to: 0.1, count: 3}}'
  error[E0204]: the range ends at 0.1 and begins at 0.3
   --> sweep.yaml:1:40
    |
  1 | settings: {clip_range: {from: 0.3, to: 0.1, count: 3}}
    |                                        ^^^
  
  1 error
  [1]
  $ sweep 'settings: {net_arch: [8, [8, 8]]}'
  error[E0203]: a width among lists of widths
   --> sweep.yaml:1:23
    |
  1 | settings: {net_arch: [8, [8, 8]]}
    |                       ^
  help: write [8]
  
  1 error
  [1]
  $ sweep 'settings: {clip_range: {from: 0.1, to: 0.3}}'
  error[E0202]: missing key `count` in a range
   --> sweep.yaml:1:24
    |
  1 | settings: {clip_range: {from: 0.1, to: 0.3}}
    |                        ^
  help: say how many values, or sample some: `random: 20` next to `settings:`
  
  1 error
  [1]
  $ sweep 'random: 3\nsettings: {clip_range: {from: 0.1, to: 0.3, count: 3}}'
  error[E0204]: with `random` any value of a range is sampled
   --> sweep.yaml:2:52
    |
  2 | settings: {clip_range: {from: 0.1, to: 0.3, count: 3}}
    |                                                    ^
  help: leave `count` out, or write a list of values
  
  1 error
  [1]
  $ sweep 'settings: {n_envs: {from: 128, to: 65536, count: 200}, n_steps: {from: 1, to: 4096, count: 200}}'
  error[E0204]: more than 10000 combinations
   --> sweep.yaml:1:11
    |
  1 | settings: {n_envs: {from: 128, to: 65536, count: 200}, n_steps: {from: 1, to: 4096, count: 200}}
    |           ^
  help: sample some of them: `random: 20` next to `settings:`
  
  1 error
  [1]
  $ sweep 'settings: {clip_range: [0.1, 0.2]}' --checkpoint c
  error: --sweep takes no --checkpoint: --results continues by itself
  help: `eagerx-gen train --help` lists the options
  [2]
  $ echo 'precious' >results.csv
  $ sweep 'settings: {clip_range: [0.1, 0.2]}' --results results.csv
  error: `results.csv` has no results of a sweep
  help: give a new file, or one that a sweep has written
  [3]
  $ cat results.csv
  precious
Without the trainer next to it.
  $ cp "$build/eagerx-gen" alone
  $ ./alone train "$trained"
  error: there is no `<folder>/eagerx-train`
  help: install the package of eagerx-gen again, or build all of it
  [3]

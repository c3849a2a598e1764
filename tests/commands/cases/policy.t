A policy instead of the graph's agent: as if the graph named it. (program.map says where in the graph it stands.)
  $ cp "$root/examples/pendulum_swing_up/"{graph.yaml,swing_up.onnx} .
  $ eagerx-gen generate graph.yaml -o named -q
  $ sed -i 's/^agent: .*/agent: zero/' graph.yaml
  $ eagerx-gen generate graph.yaml -o given -q --policy swing_up.onnx
  $ diff -r -x program.map named given
  $ eagerx-gen generate graph.yaml -o given --policy no.onnx
  error[E0601]: cannot read policy `no.onnx`: no such file
    --> graph.yaml:39:8
     |
  39 | agent: zero
     |        ^^^^
  help: available: `swing_up.onnx`
  
  1 error
  [3]
Known answers of a policy.
  $ policies=$root/tests/data/policy
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --normalize "$policies/ppo_64_vecnormalize.pkl" --rows 20 -o g.csv
  g.csv: 20 rows
  observations   20 sampled, seed 1, within 2 deviations of the statistics
  $ eagerx-gen policy test "$policies/ppo_64.zip" g.csv --normalize "$policies/ppo_64_vecnormalize.pkl"
  <root>/tests/data/policy/ppo_64.zip against g.csv: 20 rows
  largest error  5.75e-07 (against float64)
  file's own     0; in row 6 at most 0.000324 is allowed
  with int8      off by mean 0.014, largest 0.042 in a range of 6.5, on 20 golden rows
  actions        2.66e-07 off; in row 11 at most 0.0002 is allowed
  $ eagerx-gen policy test "$policies/ppo_64.onnx" g.csv
  <root>/tests/data/policy/ppo_64.onnx against g.csv: 20 rows
  normalised     taken from the rows, because there is no `--normalize`
  largest error  5.75e-07 (against float64)
  file's own     0; in row 6 at most 0.000324 is allowed
  with int8      off by mean 0.014, largest 0.042 in a range of 6.5, on 20 golden rows
  actions        not compared: the file does not say their bounds
Its own first layer may normalize, which the file does not say.
  $ eagerx-gen policy info "$policies/ppo_64.onnx" | grep normalised
    normalised     by nothing but its own layers (give statistics with --normalize)
  $ eagerx-gen policy test "$policies/sac_64.onnx" g.csv
  error[E0633]: the policy `<root>/tests/data/policy/sac_64.onnx` does not answer the golden rows `g.csv`: row 15 is 4.5 off
  help: give the statistics of its observations as `normalize`
  
  1 error
  [1]
  $ grep -v '^#' g.csv | cut -d, -f1-3 >asked.csv
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --observations asked.csv -o given.csv -q
  $ eagerx-gen policy golden "$policies/architectures/gru.onnx" --rows 40 --seed 7 -o h.csv
  h.csv: 40 rows
  observations   40 sampled, seed 7, in -1…1
  episodes       as `episode_start` says
  actions        left out: the file does not say their bounds
  $ eagerx-gen policy test "$policies/architectures/gru.onnx" h.csv
  <root>/tests/data/policy/architectures/gru.onnx against h.csv: 40 rows
  largest error  3.87e-08 (against float64)
  file's own     0; in row 6 at most 7.64e-06 is allowed
  with int8      off by mean 0.00018, largest 0.00039 in a range of 0.15, on 40 golden rows
  $ eagerx-gen policy golden "$policies/architectures/gru.onnx" --observations asked.csv -o no.csv
  error[E0761]: the policy `<root>/tests/data/policy/architectures/gru.onnx` remembers, and observations `asked.csv` do not say where episodes start
  help: add a column `episode_start`: 1 in the first row of each episode, else 0
  
  1 error
  [1]
  $ printf 'obs0,obs1\n1,2\n' >two.csv
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --observations two.csv -o no.csv
  error[E0632]: observations `two.csv` have rows of 2 numbers, but the policy `<root>/tests/data/policy/ppo_64.zip` takes 3
  help: columns are obs0, obs1 …, network_out, action; arrays obs, network_out, action
  
  1 error
  [1]
  $ eagerx-gen policy golden "$policies/libraries/dqn_cnn.zip" --rows 1000000 -o no.csv
  error[E0760]: 1000000 rows are too many for the policy `<root>/tests/data/policy/libraries/dqn_cnn.zip`: it takes 21779 products a row
  help: at most 38491 rows of it can be answered in one run
  
  1 error
  [1]
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --rows 0 -o no.csv
  error: --rows: 0 is not a whole number from 1 to 1000000
  help: `eagerx-gen policy golden --help` lists the options
  [2]
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --rows 5 --observations asked.csv -o no.csv
  error: --rows and --seed are for sampled observations, not for --observations
  help: `eagerx-gen policy golden --help` lists the options
  [2]
  $ eagerx-gen policy golden "$policies/ppo_64.zip" --rows 5 -o asked.csv/no.csv
  error[E0901]: cannot write `asked.csv/no.csv`: Not a directory
  
  1 error
  [3]
  $ [ ! -e no.csv ]
Two policies side by side.
  $ eagerx-gen policy compare "$policies/sac_64.zip" --int8 --tolerance 0.2
  first          <root>/tests/data/policy/sac_64.zip: Stable-Baselines3 2.3.2, Stable-Baselines3's SAC
  second         <root>/tests/data/policy/sac_64.zip with weights of eight bits: Stable-Baselines3 2.3.2, Stable-Baselines3's SAC
  observations   1000 sampled, seed 1, within the bounds of their space
  output   largest     mean        range       allowed     in row
    0      0.074       0.0059      2           0.2         214
  farthest off   output 0 in row 214
    observation  [0.946442, 0.949432, -0.494995]
    first        [0.126837]
    second       [0.200862]
  actions        at most 0.148 off
  layer    weights     largest     mean        in row
    1      0.00686     0.0124      0.00059     254    3 -> 64 relu
    2      0.00915     0.0499      0.00211     264    64 -> 64 relu
    3      0.00786     0.074       0.0059      214    64 -> 1 tanh
  $ eagerx-gen policy compare "$policies/sac_64.zip" --int8
  first          <root>/tests/data/policy/sac_64.zip: Stable-Baselines3 2.3.2, Stable-Baselines3's SAC
  second         <root>/tests/data/policy/sac_64.zip with weights of eight bits: Stable-Baselines3 2.3.2, Stable-Baselines3's SAC
  observations   1000 sampled, seed 1, within the bounds of their space
  output   largest     mean        range       allowed     in row
    0      0.074       0.0059      2           2e-05       214
  farthest off   output 0 in row 214
    observation  [0.946442, 0.949432, -0.494995]
    first        [0.126837]
    second       [0.200862]
  actions        at most 0.148 off
  layer    weights     largest     mean        in row
    1      0.00686     0.0124      0.00059     254    3 -> 64 relu
    2      0.00915     0.0499      0.00211     264    64 -> 64 relu
    3      0.00786     0.074       0.0059      214    64 -> 1 tanh
  error[E0758]: output 0 of the policy `<root>/tests/data/policy/sac_64.zip with weights of eight bits` is 0.074 off that of `<root>/tests/data/policy/sac_64.zip`, more than 2e-05
  
  1 error
  [1]
  $ eagerx-gen policy compare "$policies/ppo_64.zip" "$policies/ppo_64.onnx" --tolerance 0
  first          <root>/tests/data/policy/ppo_64.zip: Stable-Baselines3 2.3.2, Stable-Baselines3's PPO or A2C
  second         <root>/tests/data/policy/ppo_64.onnx: ONNX opset 17, exported by pytorch 1.13.0
  observations   1000 sampled, seed 1, within the bounds of their space
  output   largest     mean        range       allowed     in row
    0      0           0           7.08        0           1
  layer    weights     largest     mean        in row
    1      0           0           0           1      3 -> 64 tanh
    2      0           0           0           1      64 -> 64 tanh
    3      0           0           0           1      64 -> 1
  $ eagerx-gen policy compare "$policies/ppo_64.zip" "$policies/ppo_64.onnx" --json | grep -e within -e layers
    "observations": "1000 sampled, seed 1, within the bounds of their space",
    "within": true,
    "layers": [
  $ eagerx-gen policy compare "$policies/ppo_64.zip" "$policies/ppo_64.onnx" --normalize "$policies/ppo_64_vecnormalize.pkl" --normalize - 2>&1 |
  >   grep -e E0758
  error[E0758]: output 0 of the policy `<root>/tests/data/policy/ppo_64.onnx` is 4.67 off that of `<root>/tests/data/policy/ppo_64.zip`, more than 7.55e-05
  [1]
  $ eagerx-gen policy compare "$policies/sac_64.zip" "$policies/ppo_64.zip" 2>&1 | grep layers
  layers         not compared: layer 1 is 3 -> 64 relu in one, 3 -> 64 tanh in the other
  [1]
  $ eagerx-gen policy compare "$root/tests/diagnostics/cases/files/three_to_two.onnx" "$policies/ppo_64.zip"
  error[E0757]: the policy `<root>/tests/diagnostics/cases/files/three_to_two.onnx` gives 2 numbers, but `<root>/tests/data/policy/ppo_64.zip` gives 1
  help: only policies for the same observations and actions can be compared
  
  1 error
  [1]
  $ eagerx-gen policy compare "$policies/ppo_64.zip"
  error: a second file is missing, or --int8
  help: `eagerx-gen policy compare --help` lists the options
  [2]
  $ eagerx-gen policy compare "$policies/ppo_64.zip" --int8 --tolerance nan
  error: --tolerance: nan is not a number from 0 on
  help: `eagerx-gen policy compare --help` lists the options
  [2]
  $ eagerx-gen policy compare "$policies/ppo_64.zip" --int8 --actor a --actor b --actor c
  error: an option is there more than twice: there are two files
  help: `eagerx-gen policy compare --help` lists the options
  [2]
  $ eagerx-gen policy compare "$policies/ppo_64.zip" no.onnx
  error[E0601]: cannot read policy `no.onnx`: no such file
  help: available: `swing_up.onnx`
  
  1 error
  [3]

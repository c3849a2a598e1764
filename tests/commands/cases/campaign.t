Nothing is built for a campaign that has nothing to count.
  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ swing=$root/tests/environments/swing.yaml
  $ eagerx-gen campaign "$graph"
  error[E0380]: the graph has no `task:`, so there is no success to count
   --> <root>/tests/golden/multi_rate/graph.yaml:4:7
    |
  4 | name: multi_rate
    |       ^^^^^^^^^^
  help: add one that says when an episode ends and what success is: `task: {inputs: {th: pendulum.theta}, reward: {upright: {value: th^2, weight: -1.0}}, truncated: {after: 5.0}, success: {upright: abs(th) < 0.15, over_last: 2.0}}`
  
  1 error
  [1]
  $ eagerx-gen campaign "$graph" --runs --seed=3
  error: `--runs` needs a value
  help: `eagerx-gen campaign --help` lists the options
  [2]
  $ sed '/^  success:/d' "$swing" >no_success.yaml
  $ eagerx-gen campaign no_success.yaml
  error[E0380]: the task has no `success:`, so there is nothing to count
    --> no_success.yaml:16:1
     |
  16 | task:
     | ^^^^
  help: say when an episode is a success: `success: {upright: abs(th) < 0.15, over_last: 2.0}`
  
  1 error
  [1]
  $ sed 's/^agent: random/agent: {csv: actions.csv}/' "$swing" >actions.yaml
  $ eagerx-gen campaign actions.yaml
  error[E0381]: the agent is a file of actions, which many runs cannot all repeat
    --> actions.yaml:38:14
     |
  38 | agent: {csv: actions.csv}
     |              ^^^^^^^^^^^
  help: name a policy with `--policy FILE`, or in the graph: `agent: {policy: FILE}`; `zero` and `random` are agents, too
  
  1 error
  [1]
  $ eagerx-gen campaign "$graph" --vary pendulum.mass=1
  error: --vary: `pendulum.mass=1` is not NAME=LOW:HIGH, such as pendulum.mass=0.1:0.2
  help: `eagerx-gen campaign --help` lists the options
  [2]
  $ eagerx-gen campaign "$graph" --csv no/runs
  error: cannot write `no/runs`: No such file or directory
  [3]
  $ eagerx-gen campaign "$swing" --vary 'pendulum.model_state[1]=0:10' --build not_built
  error: `pendulum.model_state[1]` cannot be from 0 to 10: its space is from -9 to 9
  help: choose a range within it, or give the state another `space` in the graph
  [1]
  $ [ ! -e not_built ]

What is in the way of an output stays.
  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ touch a_file
  $ eagerx-gen "$graph" -o depfile --depfile a_file/x.d
  error[E0901]: cannot write `a_file/x.d`: Not a directory
  
  1 error
  [3]
  $ [ ! -e depfile ]
  $ eagerx-gen "$graph" -o depfile --depfile depfile/x.d -q
  $ mkdir own && echo "project(own)" >own/CMakeLists.txt
  $ eagerx-gen "$graph" -o own
  error[E0903]: `own/CMakeLists.txt` was not written by eagerx-gen
  help: choose another folder with `--output`, or move the file away
  
  1 error
  [3]
  $ cat own/*
  project(own)
The other commands and their files: tests/commands/one_file.
  $ cp "$graph" mine.yaml
  $ eagerx-gen report mine.yaml -o mine.yaml
  error: `--output mine.yaml` and `graph mine.yaml` are one file
  help: give each its own
  [2]
  $ cp "$graph" multi_rate.html
  $ eagerx-gen report multi_rate.html
  error[E0906]: `multi_rate.html` is a file that is read, as `graph multi_rate.html`
  help: give another name for what is written
  
  1 error
  [2]
  $ eagerx-gen "$graph" --split agent=stm32f405 --standalone -o alone
  error[E0336]: a split graph has no standalone tree
  help: leave out `--standalone` and `--package`
  
  1 error
  [1]
  $ eagerx-gen "$graph" --split agent=stm32f405 --library -o alone
  error[E0336]: a split graph has no library
  help: leave out `--library`
  
  1 error
  [1]
  $ [ ! -e alone ]
What is named twice is made once.
  $ eagerx-gen "$graph" --target mps2-an386 --target mps2-an386 --package arduino --package arduino -o twice -q
  $ eagerx-gen "$graph" --target mps2-an386 --package arduino -o twice | grep -o "twice: 0 files written"
  twice: 0 files written
An entity that sets its delay, in a graph that simulates none: what it sets is kept for nothing.
  $ cat >still.yaml <<'END'
  > name: still
  > rate: 30
  > engine: {type: OdeEngine, rate: 30, simulate_delays: false}
  > objects:
  >   pendulum: {type: DcscPendulum}
  > actions: [voltage]
  > observations: [x]
  > connections:
  >   - {from: actions.voltage, to: pendulum.u}
  >   - {from: pendulum.x, to: observations.x}
  > END
  $ eagerx-gen still.yaml -o still -q
  $ grep -ho -e "struct Delays" -e "double pendulum_u_action_delay_s_ = 0.0;" still/still/*.hpp
  struct Delays
  double pendulum_u_action_delay_s_ = 0.0;

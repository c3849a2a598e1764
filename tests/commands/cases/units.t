Units are read as what they mean: the same program, but for what it is made from.
  $ mkdir -p units/plain units/written && cat >units/plain/graph.yaml <<'END'
  > name: units
  > rate: 30
  > engine: {type: OdeEngine, rate: 60}
  > objects:
  >   pendulum: {type: DcscPendulum}
  > nodes:
  >   smooth: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 12}}
  > actions: {voltage: {space: {like: pendulum.u}}}
  > observations: [x]
  > connections:
  >   - {from: actions.voltage, to: smooth.signal, delay: {uniform: {low: 0.01, high: 0.02}}}
  >   - {from: smooth.filtered, to: pendulum.u, delay: 1/30}
  >   - {from: pendulum.x, to: observations.x, delay: 0.00005}
  > reset_timeout: 60
  > allow: [W0109]
  > END
  $ sed -e 's/^rate: 30/rate: 30 Hz/; s/rate: 60/rate: 0.06kHz/; s/cutoff_hz: 12/cutoff_hz: 12 Hz/; s/low: 0.01, high: 0.02/low: 10 ms, high: 2e4us/' \
  >   -e 's/delay: 1\/30/delay: 1\/30 s/; s/0.00005/50 µs/; s/timeout: 60/timeout: 1 min/' units/plain/graph.yaml >units/written/graph.yaml
  $ grep -c -e Hz -e ms -e us -e " s}" -e µs -e min units/written/graph.yaml
  7
  $ eagerx-gen units/plain/graph.yaml -o units/plain/made -q
  $ eagerx-gen units/written/graph.yaml -o units/written/made -q
  $ diff -r units/plain/made units/written/made
  $ eagerx-gen check units/written/graph.yaml --rate "30 Hz" --engine-rate 60Hz | tail -n 1
  units/written/graph.yaml: 5 nodes, 2 rates, 5 buffers with room for 14 messages; no problems
  $ eagerx-gen check units/written/graph.yaml --rate 10ms
  error: --rate: 10ms is not a rate such as 30, 30Hz or 30000/1001
  help: `eagerx-gen check --help` lists the options
  [2]

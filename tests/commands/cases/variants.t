The form of variants that are not chosen; a chosen one is looked at alone.
  $ eagerx-gen check "$root/tests/commands/variant_typo.yaml"
  error[E0202]: missing key `type` in an object
    --> <root>/tests/commands/variant_typo.yaml:13:21
     |
  13 |   wrong: {objects: {pendlum: {config: {mass: 2.0}}}, engine: {rat: 60}}
     |                     ^^^^^^^
  note: with `--variant wrong`
  help: did you mean `pendulum`? If it is another one, add `type:`, the id of an entity as `eagerx-gen info` lists them
  
  error[E0201]: unknown key `rat` in the engine
    --> <root>/tests/commands/variant_typo.yaml:13:63
     |
  13 |   wrong: {objects: {pendlum: {config: {mass: 2.0}}}, engine: {rat: 60}}
     |                                                               ^^^
  note: with `--variant wrong`
  help: did you mean `rate`?
  
  error[E0203]: expected a rate in Hz, found `fast`
    --> <root>/tests/commands/variant_typo.yaml:14:17
     |
  14 |   worse: {rate: fast}
     |                 ^^^^
  note: with `--variant worse`
  help: write it in digits, such as `30`
  
  3 errors
  [1]
  $ eagerx-gen check "$root/tests/commands/variant_typo.yaml" --variant slow | tail -n 1
  <root>/tests/commands/variant_typo.yaml: 6 nodes, 2 rates, 6 buffers with room for 6 messages; no problems
  $ eagerx-gen check "$root/examples/controller_in_your_main/graph.yaml" | tail -n 1
  <root>/examples/controller_in_your_main/graph.yaml: 7 nodes, 2 rates, 6 buffers with room for 6 messages; no problems; 1 variant of the right form

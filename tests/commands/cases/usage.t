Wrong usage is answered with what would be right.
  $ eagerx-gen
  error: `eagerx-gen` alone is not enough
  help: give a graph, or one of generate, build, run, train, campaign, pil, check, info, diff, graph, report, explain, import, schema, new, size, replay, identify, trace, plot, monitor, policy, key, docs, linearize, design, trim, fix, rename, lsp, serve, help
  [2]
  $ eagerx-gen generte graph.yaml
  error: `generte` is neither a command nor a file
  help: did you mean `generate`?
  [2]
  $ eagerx-gen --vers
  error: `eagerx-gen` has no option `--vers`
  help: did you mean `--version`?
  [2]
  $ eagerx-gen check x.yaml --engin=A
  error: `eagerx-gen check` has no option `--engin`
  help: did you mean `--engine`?
  [2]
  $ eagerx-gen check a b
  error: `b` is one argument too many for `eagerx-gen check`
  help: `eagerx-gen check --help` lists the options
  [2]
  $ eagerx-gen new bord x
  error: kind: `bord` is not possible
  help: did you mean `board`?
  [2]
  $ eagerx-gen new motor x
  error: kind: `motor` is not possible
  help: available: board, engine, example, node, object, processor, project, reset-node
  [2]
  $ eagerx-gen check x.yaml --real flot
  error: --real: `flot` is not possible
  help: did you mean `float`?
  [2]
  $ eagerx-gen policy
  error: `eagerx-gen policy` alone is not enough
  help: available: info, test, golden, compare
  [2]
  $ eagerx-gen no.yaml
  error[E0101]: cannot read `no.yaml`: no such file or directory
   --> no.yaml
  
  1 error
  [3]
  $ eagerx-gen size no.elf
  error[E0911]: cannot read `no.elf`: no such file
  
  1 error
  [3]
  $ eagerx-gen size "$build/eagerx-gen"
  error[E0911]: `<build>/eagerx-gen` is not the image of a board
  help: give the .elf file that was built for one
  
  1 error
  [3]
  $ eagerx-gen check --path "" "$root/tests/golden/multi_rate/graph.yaml"
  error[E0301]: a folder of a library has no name
  
  1 error
  [3]
Options before the file or the command.
  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ eagerx-gen -q check "$graph"
  $ eagerx-gen --diagnostics json -q check "$graph"
  []
  $ eagerx-gen -q "$graph" -o quiet
  $ eagerx-gen -x "$graph"
  error: `eagerx-gen` has no option `-x`
  help: `eagerx-gen --help` lists the options
  [2]
Without its data, each command that needs them says so.
  $ EAGERX_HOME=nowhere eagerx-gen new project robot
  error[E0301]: there are no templates for a new `project`
  help: install eagerx-gen with `cmake --install`, or set EAGERX_HOME to the folder that has models and templates
  
  1 error
  [3]
  $ EAGERX_HOME=nowhere eagerx-gen info Pendulum
  error[E0301]: cannot find the folder with models and templates
  help: install eagerx-gen with `cmake --install`, or set EAGERX_HOME to that folder
  
  1 error
  [3]
  $ EAGERX_HOME=nowhere eagerx-gen --version | sed 's/ [0-9.]*$//'
  eagerx-gen

  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ eagerx-gen check --path "$root/tests/data/library" "$root/tests/programs/own_library.yaml" | tail -n 1
  <root>/tests/programs/own_library.yaml: 4 nodes, 3 rates, 6 buffers with room for 17 messages; no problems
A copy of a built-in entity, as it is and with a change.
  $ mkdir copies && cp -r "$root/models/nodes/nan_guard" copies
  $ eagerx-gen check --path copies "$graph" | tail -n 1
  <root>/tests/golden/multi_rate/graph.yaml: 13 nodes, 5 rates, 16 buffers with room for 36 messages; no problems
  $ echo "// mine" >>copies/nan_guard/nan_guard.hpp
  $ eagerx-gen check --path copies "$graph"
  error[E0302]: `NanGuard` is defined twice
   --> <root>/models/nodes/nan_guard/manifest.yaml:2:5
    |
  2 | id: NanGuard
    |     ^^^^^^^^
  note: first here
   --> copies/nan_guard/manifest.yaml:2:5
  
  1 error
  [1]
An id that another manifest has: the other file is named.
  $ mkdir -p twice/gain && cp "$root"/models/nodes/gain/* twice/gain/ && sed -i 's/^summary:.*/summary: mine/' twice/gain/manifest.yaml
  $ eagerx-gen check twice/gain/manifest.yaml
  error[E0302]: `Gain` is defined twice
   --> twice/gain/manifest.yaml:2:5
    |
  2 | id: Gain
    |     ^^^^
  note: also defined in `<root>/models/nodes/gain/manifest.yaml:2`
  
  1 error
  [1]
A header that a standalone tree would not have.
  $ cp -r "$root/tests/data/library" entities
  $ mkdir outside graphs && mv entities/nodes/leaky_sum/leaky_sum.hpp outside
  $ echo "#include \"$PWD/outside/leaky_sum.hpp\"" >entities/nodes/leaky_sum/leaky_sum.hpp
  $ mv entities graphs && sed 's#^library:.*#library: [entities]#' "$root/tests/programs/own_library.yaml" >graphs/graph.yaml
  $ eagerx-gen graphs/graph.yaml --standalone -o alone
  error[E0904]: `src/entities/nodes/leaky_sum/leaky_sum.hpp` includes `<folder>/outside/leaky_sum.hpp`, which is in no folder of entities
   --> <folder>/graphs/entities/nodes/leaky_sum/leaky_sum.hpp:1:11
    |
  1 | #include "<folder>/outside/leaky_sum.hpp"
    |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  help: move it below the folder that `library:` or `--path` names, or next to that folder: a tree has what lies there, too
  
  1 error
  [1]
  $ [ ! -e alone ]
A standalone tree in the folder of the library is not a part of the library, also the second time.
  $ mkdir around && cp -r "$root/tests/data/library" around/entities
  $ sed 's#^library:.*#library: [.]#' "$root/tests/programs/own_library.yaml" >around/graph.yaml
  $ eagerx-gen around/graph.yaml --standalone -o around/out -q
  $ eagerx-gen around/graph.yaml --standalone -o around/out -q
  $ cp -r around/entities/nodes/leaky_sum around/out/leaky_sum
  $ eagerx-gen check around/graph.yaml | tail -n 1
  around/graph.yaml: 4 nodes, 3 rates, 6 buffers with room for 17 messages; no problems
  $ echo "// mine" >>around/out/leaky_sum/leaky_sum.hpp
  $ eagerx-gen check around/graph.yaml
  error[E0302]: `LeakySum` is defined twice
   --> around/./out/leaky_sum/manifest.yaml:2:5
    |
  2 | id: LeakySum
    |     ^^^^^^^^
  note: first here
   --> around/./entities/nodes/leaky_sum/manifest.yaml:2:5
  
  1 error
  [1]
What is to be filled in of a main loop: an output is within the limits of `safety:`, whatever its node may send.
  $ eagerx-gen generate "$root/tests/own_loop/poisoned.yaml" --package arduino --library -o loop -q
  $ grep "FILL IN ." loop/examples/poisoned/hardware.h
    // FILL IN speed: float32 [1], from -2 to 2; one number
    // FILL IN position: float32 [1], from -1 to 1; the sum
In the comments of a library, an output has the limits of `safety:`.
  $ sed 's/low: .-60.0, -30.0., high: .60.0, 30.0./low: -60.0, high: 60.0/' "$root/tests/own_loop/arm.yaml" >arm.yaml
  $ eagerx-gen generate arm.yaml --library -o arm | head -n 1
  arm: 9 files written, 0 unchanged
  $ grep seen.torque arm/arm.hpp
  //     … = seen.torque.back();  // eagerx::Array<float, 2>, float32 [2], from -60 to 60

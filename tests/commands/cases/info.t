  $ graph=$root/examples/pendulum_swing_up/graph.yaml
  $ eagerx-gen check "$graph" --engine OpenDynamicsEngine 2>&1 | grep "left out"
  note: method, substeps of `OdeEngine` left out: `OpenDynamicsEngine` takes its own defaults
  $ eagerx-gen info Pendulum --flat
  error: `--flat` is for graphs
  help: give a file GRAPH.yaml
  [2]
  $ eagerx-gen info Pendulum --image pendulum.elf
  error: `--image` is for graphs
  help: give a file GRAPH.yaml
  [2]
  $ eagerx-gen info Pendulum --json | grep -e '"id":' -e '"kind"' -e '"made_for"' -e '"unit"'
    "id": "Pendulum",
    "kind": "object",
        "id": "eagerx_tutorials.pendulum.objects/Pendulum",
    "made_for": [
        "unit": "rad",
        "unit": "rad/s",
        "unit": "V",
        "unit": "V",
        "unit": "kg",
        "unit": "m",
        "unit": "rad/s",
  $ eagerx-gen info mps2-an386 --json | grep -e '"id"' -e '"kind"'
    "id": "mps2-an386",
    "kind": "target",
  $ mkdir theirs && cp -r "$root/tests/data/library" theirs/entities
  $ eagerx-gen info LeakySum --json --path theirs/entities | grep manifest
    "manifest": "entities/nodes/leaky_sum/manifest.yaml",
  $ eagerx-gen info Pendulumm --json
  error[E0303]: unknown entity or target `Pendulumm`
  help: did you mean `Pendulum`?
  
  1 error
  [1]
  $ eagerx-gen info DcMotor | grep -e "implemented for" -e "^config"
  implemented for: OdeEngine, PinEngine
  config
A family is a name of manifests.
  $ eagerx-gen info PinEngine
  PinEngine (family of engines)
  A name, not an engine: an object that is implemented for PinEngine runs on each engine of the family.
  
  engines that run it: LinuxEngine, Stm32F405Engine
  objects implemented for it: DcMotor
  $ eagerx-gen info mps2
  mps2 (family of boards)
  A name for boards with the same peripherals. Entities that need these name the family.
  
  boards: mps2-an385, mps2-an386, mps2-an500
  entities that need one of them: Mps2Engine
  $ eagerx-gen info PinEngin 2>&1 | head -n 2
  error[E0303]: unknown entity or target `PinEngin`
  help: `eagerx-gen info` lists all entities and targets
  [1]
  $ eagerx-gen info PID
  error[E0303]: unknown entity or target `PID`
  help: did you mean `PidController`?
  
  1 error
  [1]

Help of each command ends with examples, and `help COMMAND` is the same.
  $ for command in train campaign generate check info graph report explain import schema new size replay identify policy; do
  >   eagerx-gen $command --help >asked && eagerx-gen help $command | diff asked - || echo "differs: $command"
  >   grep "^Usage:" asked
  >   sed -n '/^Examples:/,$p' asked | grep -c "^  eagerx-gen $command"
  > done
  Usage: eagerx-gen train [OPTIONS] graph
  7
  Usage: eagerx-gen campaign [OPTIONS] graph
  5
  Usage: eagerx-gen generate [OPTIONS] graph
  6
  Usage: eagerx-gen check [OPTIONS] graph
  5
  Usage: eagerx-gen info [OPTIONS] [entity]
  6
  Usage: eagerx-gen graph [OPTIONS] graph
  2
  Usage: eagerx-gen report [OPTIONS] graph
  6
  Usage: eagerx-gen explain [OPTIONS] [code]
  2
  Usage: eagerx-gen import [OPTIONS] state
  2
  Usage: eagerx-gen schema [OPTIONS]
  4
  Usage: eagerx-gen new [OPTIONS] kind name
  4
  Usage: eagerx-gen size [OPTIONS] image
  4
  Usage: eagerx-gen replay [OPTIONS] [program] [log]
  2
  Usage: eagerx-gen identify [OPTIONS] program log
  1
  Usage: eagerx-gen policy [OPTIONS] SUBCOMMAND
  2
  $ eagerx-gen help linearize | head -n 1
  linearize the sampled loop as it runs, with its rates, delays and windows: matrices, poles, and stability margins (experimental)
  $ eagerx-gen help policy test | grep "^Usage:"
  Usage: eagerx-gen policy test [OPTIONS] file golden
  $ eagerx-gen help | sed -n '/^Topics of `help`:/,$p' | grep -e Topics -e graph-file -e units
  Topics of `help`:
    graph-file                  the keys of a graph file
    units                       units of rates and times
  $ eagerx-gen help graph-file | grep "the rate of the environment in Hz"
  rate            the rate of the environment in Hz: one step is 1/rate
  $ eagerx-gen help units
  Rates and times may have a unit: `rate: 30 Hz`, `delay: 10ms`, `delay: 1/3 s`.
  Without a unit, rates are in Hz and times in seconds. Case counts.
  
  rates   Hz, kHz, MHz, mHz
  times   s, ms, us, ns, min, h (or µs)
  angles  deg
  gains   dB (of margins)
  memory  kB, KiB, MB, MiB, B, k, K, M, KB (of `budget:`; k is 1024, M is 1024 k)
  $ eagerx-gen help gaph
  error: there is no help for `gaph`
  help: did you mean `graph`?
  [2]
  $ eagerx-gen help policy inf
  error: there is no help for `inf`
  help: did you mean `info`?
  [2]
What codes mean: the list, a page in each spelling, and what is none. (That each is its page: tests/diagnostics/codes.)
  $ eagerx-gen explain | sed -n '1,2p;$p'
  E01xx reading text
    E0101  a file cannot be read
  `eagerx-gen explain CODE` says more about one of them
  $ eagerx-gen explain E0307 >page
  $ head -n 1 page && grep -e "^## " -e thetta page
  # E0307: unknown port, state, action, observation or node
  ## Cause
  ## Example
    - {from: pendulum.thetta, to: observations.angle}
  error[E0307]: `pendulum` has no sensor `thetta`
  ## Fix
  $ for spelling in e0307 E307 307 0307; do eagerx-gen explain $spelling | diff page -; done
  $ eagerx-gen explain 319
  error: there is no code `E0319`
  help: next to it are E0318 (an invalid reset routine) and E0320 (an unknown parameter); `eagerx-gen explain` lists all
  [2]
  $ eagerx-gen explain E9999
  error: there is no code `E9999`
  help: next to it are E0911 (an image cannot be measured) and W0101 (an action wider than its actuator); `eagerx-gen explain` lists all
  [2]
  $ eagerx-gen explain E03x7
  error: `E03x7` is not a code
  help: codes are such as E0307; `eagerx-gen explain` lists them
  [2]
  $ eagerx-gen explain 03070
  error: `03070` is not a code
  help: codes are such as E0307; `eagerx-gen explain` lists them
  [2]
  $ eagerx-gen explain E0307 E0310
  error: `E0310` is one argument too many for `eagerx-gen explain`
  help: `eagerx-gen explain --help` lists the options
  [2]
They are named on a terminal, not in a file.
  $ on_terminal() {
  >   script -qec true /dev/null >/dev/null 2>&1 || { echo "SKIPPED: on a terminal, as this system has no pseudo-terminals" && return; }
  >   script -qec "$1" /dev/null
  > }
  $ on_terminal "eagerx-gen check no.yaml" | tail -n 1 | tr -d '\r'
  `eagerx-gen explain E0101` says more about this error
  [3]

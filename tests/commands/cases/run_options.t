Options of a program that make no sense on its target are refused by their name, before anything is built.
On boards:
  $ on_board() { eagerx-gen run "$root/examples/pendulum_swing_up/graph.yaml" --quiet --target "$@"; }
  $ for board in mps2-an385 mps3-an547 riscv32-virt stm32f405; do on_board $board --steps 3 --render window; done
  error[E0516]: a program for `mps2-an385` does not take `--render`
  help: a board shows no pictures
  
  1 error
  error[E0516]: a program for `mps3-an547` does not take `--render`
  help: a board shows no pictures
  
  1 error
  error[E0516]: a program for `riscv32-virt` does not take `--render`
  help: a board shows no pictures
  
  1 error
  error[E0516]: a program for `stm32f405` does not take `--render`
  help: a board shows no pictures
  
  1 error
  [2]
  $ on_board mps2-an386 --replay run.trace --hash --fault angle=silent@4
  error[E0516]: a program for `mps2-an386` does not take `--replay`
  help: a board has no files
  
  error[E0516]: a program for `mps2-an386` does not take `--fault`
  help: faults are put in on Linux
  
  2 errors
  [2]
  $ on_board mps2-an386 --csv run.csv
  error[E0516]: `--csv` has no value in a program for `mps2-an386`: `run.csv`
  help: a board has no files: `--csv` prints the table, and `--csv > FILE` keeps it
  
  1 error
  [2]
  $ on_board mps2-an386 --steps 0
  error[E0516]: `0` is not a value of `--steps`
  help: write `--steps N`, a whole number from 1 on
  
  1 error
  [2]
  $ on_board mps2-an386 --seed
  error[E0516]: `--seed` needs a value
  help: write `--seed N`, a whole number from 0 on
  
  1 error
  [2]
  $ on_board mps2-an386 --agent=csv
  error[E0516]: `csv` is not a value of `--agent`
  help: write `--agent policy|zero|random`
  
  1 error
  [2]
  $ on_board mps2-an386 --stepps 3
  error[E0516]: a program for `mps2-an386` does not take `--stepps`
  help: did you mean `--steps`?
  
  1 error
  [2]
  $ on_board mps2-an386 -- 7
  error[E0516]: a program for `mps2-an386` does not take `7`
  help: it takes --episodes N, --steps N, --seed N, --agent policy|zero|random, --csv, --output semihosting|uart, --timing, --pace, --late-limit N
  
  1 error
  [2]
  $ find . -name '*.elf'
On Linux, of a whole graph and of one with parts:
  $ on_linux() { eagerx-gen run "$root/examples/pendulum_swing_up/graph.yaml" --quiet -o on_linux "$@"; }
  $ on_linux --stpes 3
  error[E0516]: a program for `linux-sim` does not take `--stpes`
  help: did you mean `--steps`?
  
  1 error
  [2]
  $ on_linux -- --hlep
  error[E0516]: a program for `linux-sim` does not take `--hlep`
  help: did you mean `--help`?
  
  1 error
  [2]
  $ on_linux --tagret mps2-an386
  error[E0516]: a program for `linux-sim` does not take `--tagret`
  help: did you mean `--target`?
  
  1 error
  [2]
  $ on_linux --frobnicate
  error[E0516]: a program for `linux-sim` does not take `--frobnicate`
  help: `eagerx-gen run GRAPH.yaml -- --help` lists what it takes
  
  1 error
  [2]
  $ on_linux --environment=-1
  error[E0516]: `-1` is not a value of `--environment`
  help: write `--environment N`, a whole number from 0 to 4294967295
  
  1 error
  [2]
  $ on_linux --csv
  error[E0516]: `--csv` needs a value
  help: write `--csv FILE`
  
  1 error
  [2]
  $ on_linux --lockstep
  error[E0516]: a program for `linux-sim` does not take `--lockstep`
  help: only a graph with parts takes it: `placement:`, or `--split NAME=TARGET`
  
  1 error
  [2]
  $ eagerx-gen run "$root/tests/golden/multi_rate/graph.yaml" --quiet -o on_linux --split slow=linux-sim --lnik x
  error[E0516]: a program for `linux-sim` does not take `--lnik`
  help: did you mean `--link`?
  
  1 error
  [2]
  $ [ ! -d on_linux/build ]
The table of these options is that of the board's program, and it knows each option of programs for Linux.
  $ options=$root/targets/common/bare-metal/options.yaml
  $ sed -n '/^takes:/,/^always:/s/^  \(--[a-z-]*\):.*/\1/p' "$options" | sort >taken
  $ sed -n 's/.*word_ == "\(--[a-z-]*\)".*/\1/p' "${options%/*}/app.hpp" | grep -vx -e --trace | sort | diff taken -
  $ [ -s taken ]
  $ grep -ho '"--[a-z-]*' "$root"/targets/linux-sim/option_table.cpp | tr -d '"' | sort -u |
  >   while read -r name; do grep -q "^  $name:" "$options" || echo "$name"; done
And so of programs for Linux: names, what stands for values, which are only for graphs with parts.
  $ tr -d '\n' <"$root/targets/linux-sim/option_table.cpp" | grep -o 'Option{ *"--[^}]*}' |
  >   sed -E 's/Option\{ *"(--[a-z-]+)", *"([^"]*)".*set_[a-z_]+(, *(true))?\}/\1|\2|\4/; s/\|K\|/|N|/' >table
  $ sed -nE 's/^  (--[a-z-]+): \{(.*)\}$/\1|\2|/p' "$root/targets/linux-sim/options.yaml" | sed -E '
  >   s/\|(from: [0-9]+(, to: [0-9]+)?)/|value: N/; s/(, )?split: true\|/|true/; s/value: //; s/"//g' | diff table -
  $ [ -s table ]

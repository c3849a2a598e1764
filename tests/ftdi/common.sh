# For run and soak: source it. `emulated SETTINGS PROGRAM OPTIONS…` runs a program on the emulated adapter.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
faults=0 # of the last soak

emulated() {
  local settings=$1
  shift
  EAGERX_EMULATOR="$settings report=$work/report" LD_PRELOAD=$emulator "$@"
}
usb() { awk -v name="$1" '$1 == name { print $2 }' "$work/report"; }           # of the emulator
said() { sed -n "s/^$1 //p" "$work/said" | head -1 | grep . || echo 0; }      # of the program
check() { # name, then a condition as awk takes it
  if awk "BEGIN { exit !($2) }"; then
    echo "ok   $1"
  else
    echo "FAIL $1: $2"
    failures=$((failures + 1))
  fi
}

# soak PROGRAM SEED STEPS PROBABILITY: one run with random faults; all counts, and how soon it was safe.
soak() {
  local program=$1 seed=$2 steps=$3 probability=$4 status=0
  timeout 600 env EAGERX_EMULATOR="seed=$seed faults=$probability from=3 report=$work/report" LD_PRELOAD="$emulator" \
    "$program" --seed "$seed" --steps "$steps" >"$work/said" 2>"$work/errors" || status=$?
  check "seed $seed: ends by itself" "$status == 0"
  faults=0
  [ -s "$work/report" ] || return 0
  local kind total=0
  for kind in unplug cut silent late split spike corrupt stuck_low stuck_high oversleep; do
    total=$((total + $(usb $kind)))
  done
  echo "     $total faults in $steps steps: $(grep -E '^(unplug|cut|silent|late|split|spike|corrupt|stuck_low|stuck_high|oversleep) ' "$work/report" | paste -sd' ')"
  faults=$total
  check "seed $seed: all steps done" "$(said steps) == $steps"
  check "seed $seed: pulled out" "$(said 'adapter lost') == $(usb unplug)"
  check "seed $seed: found again, but for one that is out at the end" \
    "$(said 'adapter lost') - $(said 'adapter found again') <= 1"
  check "seed $seed: answers cut" "$(said 'answers too short') == $(usb cut)"
  check "seed $seed: answers missing or too late" "$(said 'answers missing') == $(usb silent) + $(usb late)"
  check "seed $seed: wrong bits" "$(said 'sensor parity') == $(usb corrupt)"
  check "seed $seed: line stuck at 0" "$(said 'sensor not ready') == $(usb stuck_low)"
  check "seed $seed: line stuck at 1" "$(said 'sensor refused') == $(usb stuck_high)"
  check "seed $seed: woken up too late" "$(said 'instants too late') == $(usb oversleep)"
  # Declared: the answer's timeout of 10 ms, then two transfers and at most a resynchronisation.
  check "seed $seed: 0 V within 13 ms, at most $(usb slowest_zero_us) us" "$(usb slowest_zero_us) <= 13000"
  check "seed $seed: 0 V first after power came back" "$(usb unsafe_starts) == 0"
  check "seed $seed: no byte in a wrong mode" "$(usb wrong_modes) == 0"
  check "seed $seed: 0 V at the end" "$(usb voltage) == 0"
}

finish() {
  [ $failures = 0 ] || { echo "$failures failed"; exit 1; }
}

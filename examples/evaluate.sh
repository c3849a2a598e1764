# For the `evaluate` of an example: source it, with the arguments PROGRAM=FILE…
# `table PROGRAM OPTIONS…` is the CSV of a run, `expect TEXT COMMAND…` a line of the answer, `finish` the exit.
set -eu
cd "$(dirname "${BASH_SOURCE[1]}")"
declare -A program
for argument in "$@"; do program[${argument%%=*}]=$(realpath "${argument#*=}"); done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
missed=0

table() { "${program[$1]}" --quiet --csv - "${@:2}"; }

expect() {
  if "${@:2}" >"$work/.said" 2>&1; then
    echo "ok   $1"
  else
    echo "NOT  $1"
    head -20 "$work/.said" | sed 's/^/     /'
    missed=$((missed + 1))
  fi
}

# refuses GRAPH WORDS…: eagerx-gen finds a problem in the graph and says all of the WORDS.
refuses() {
  if "$EAGERX_GEN" check "$1" >"$work/.refused" 2>&1; then
    echo "$1 is accepted"
    return 1
  fi
  local words
  for words in "${@:2}"; do
    grep -qF -- "$words" "$work/.refused" || { echo "nothing of \`$words\` in:" && cat "$work/.refused" && return 1; }
  done
}

# page_shows FILE: the README shows output (blocks of ```csv and ```text), and each of its lines is in the file.
page_shows() {
  awk 'NR == FNR { there[$0]; next } FNR == 1 { block = 0 }
    /^```/ { block = $0 == "```csv" || $0 == "```text"; next }
    block { ++shown; if (!($0 in there)) { print "not in the output: " $0; wrong = 1 } }
    END { exit wrong || !shown }' "$1" README.md
}

# Prefix of awk programs for tables: c["angle"] is the column of that name, near(a, b, tolerance) compares.
columns='BEGIN { FS = "," } NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
function abs(x) { return x < 0 ? -x : x }
function near(a, b, tolerance) { return abs(a - b) <= tolerance }
function wrong(what) { print "row " NR ": " what; bad = 1; exit 1 }
'
# check_table FILE PROGRAM: an awk program over a table; `wrong("…")` makes it fail, and so does an empty table.
check_table() { awk "$columns $2 END { if (bad || NR < 2) exit 1 }" "$1"; }

finish() { [ $missed = 0 ]; }

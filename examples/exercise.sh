# For the `check` of a tutorial's exercise: source it, with the folder to look at as the argument (default: exercise).
# A check lists what the exercise asks for, each with a hint. What is there is `ok`, what is missing is `TODO` with the
# hint and what was found. After a TODO of `valid` or `runs` the rest cannot be looked at yet, and is listed only.
# $EAGERX_GEN is the generator; programs are built in $EAGERX_EXERCISES.
set -u
here=$(realpath "$(dirname "${BASH_SOURCE[1]}")")
generator=${EAGERX_GEN:-eagerx-gen}
programs=${EAGERX_EXERCISES:-$here/../../build/exercises}
command -v "$generator" >/dev/null ||
  { echo "error: there is no \`$generator\`: use examples/run TUTORIAL --exercise, or install eagerx-gen" >&2 && exit 2; }
cd "$here/${1:-exercise}" || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
missing=0
blocked=

# asks TEXT HINT COMMAND…: the command says whether it is there.
asks() {
  local text=$1 hint=$2
  shift 2
  if [ -n "$blocked" ]; then
    echo "     then: $text"
  elif "$@" >"$work/.said" 2>&1; then
    echo "ok   $text"
  else
    missing=$((missing + 1))
    echo "TODO $text"
    printf '%s\n' "$hint" | sed 's/^/       /'
    head -n 20 "$work/.said" | sed 's/^/       | /'
    return 1
  fi
}

# valid TEXT HINT [OPTION…]: `eagerx-gen check` has no problems with the graph.
valid() {
  local text=$1 hint=$2
  shift 2
  asks "$text" "$hint" "$generator" check -q graph.yaml "$@" || blocked=yes
}

# runs TEXT HINT TABLE PROGRAM_OPTION…: the graph builds and runs, and $work/TABLE is what it observed; $work/TABLE.said
# is its summary. Options of `eagerx-gen run` may be among the PROGRAM_OPTIONs.
runs() {
  asks "$1" "$2" run_to "${@:3}" || blocked=yes
}
run_to() {
  "$generator" run graph.yaml -o "$programs/$(basename "$here")-$(basename "$PWD")" --csv "$work/$1" "${@:2}" \
    >"$work/$1.said" || { cat "$work/$1.said" && false; }
}

# plan_has PATTERN…: `eagerx-gen info` prints a line that matches each of the patterns.
plan_has() {
  "$generator" info graph.yaml >"$work/.plan" || return 1
  local pattern
  for pattern in "$@"; do
    grep -qE -- "$pattern" "$work/.plan" || { echo "eagerx-gen info graph.yaml: no line with \`$pattern\`" && return 1; }
  done
}

# check_table TABLE PROGRAM: an awk program over a table. c["angle"] is the column of that name, near(a, b, tolerance)
# compares, and `wrong("…")` says what is wrong with a row.
check_table() {
  awk 'BEGIN { FS = "," }
    function abs(x) { return x < 0 ? -x : x }
    function near(a, b, tolerance) { return a != "nan" && b != "nan" && abs(a - b) <= tolerance }
    function wrong(what) { print "line " NR " of the table: " what; bad = 1; exit 1 }
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    '"$2"'
    END { if (!bad && NR < 2) { print "the table is empty"; bad = 1 } exit bad }' "$work/$1"
}
# has TABLE COLUMN…: these were observed.
has() {
  local table=$1 column
  shift
  for column in "$@"; do
    head -n 1 "$work/$table" | tr , '\n' | grep -qxF -- "$column" ||
      { echo "there is no column \`$column\` in: $(head -n 1 "$work/$table")" && return 1; }
  done
}

finish() {
  if [ $missing = 0 ]; then
    echo "Solved."
  else
    echo "Not solved yet: work on $(realpath --relative-to="$here/../.." "$PWD"), and run this again."
    exit 1
  fi
}

# The common parts of scripts/test and scripts/check; sourced, never run.
# Every step runs, also after a failed one, and leaves a note in build/results. The totals are added up at the end.
# shellcheck shell=bash
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

results=$root/build/results

# step KIND NAME COMMAND…: says which step this is, runs the command, says how long it took and notes whether it failed.
#   prepare   counts only when it fails (a build)
#   check     counts as one test
#   tests     its tests are counted from the files build/results/NAME.* that it writes
step() {
  local kind=$1 name=$2 outcome=passed started=$SECONDS
  shift 2
  steps_begun=$((steps_begun + 1))
  say "== $steps_begun of $steps_expected: $name (after $(((SECONDS - steps_started) / 60)) min)"
  "$@" || outcome=failed
  say "   $outcome after $((SECONDS - started)) s"
  printf '%s\t%s\t%s\n' "$outcome" "$kind" "$name" >>"$results/steps.txt"
  [[ $outcome == passed ]]
}

# beside NAME COMMAND…: begins a command that takes only the processor time that all others leave, once those begun before
# it have ended. `awaited NAME` waits for its end, and prints what it said.
declare -A beside_pids
beside_last=''
beside() {
  local name=$1 last=(chrt -i 0)
  shift
  "${last[@]}" true 2>/dev/null || last=(nice -n 19) # some containers allow no other scheduling
  # Linux first shares the processor among sessions (sched(7), autogroup), and Chromium makes one of its own. So the command
  # gets a session too, and a priority for it. The session is also a process group, which can be ended whole.
  # shellcheck disable=SC2016  # for the inner shell
  setsid bash -c '(echo 19 >/proc/self/autogroup) 2>/dev/null
    if [[ -n $1 ]]; then tail -s 0.1 --pid="$1" -f /dev/null; fi
    exec "${@:2}"' bash "$beside_last" "${last[@]}" "$@" \
    >"$results/$name.beside.txt" 2>&1 </dev/null &
  beside_last=$!
  beside_pids[$name]=$beside_last
  trap end_those_beside EXIT
}
awaited() {
  local status=0
  wait "${beside_pids[$1]}" || status=$?
  unset "beside_pids[$1]"
  cat "$results/$1.beside.txt"
  return "$status"
}
end_those_beside() {
  local pid
  for pid in "${beside_pids[@]}"; do kill -TERM -- "-$pid" 2>/dev/null || true; done
}

# begin_steps COUNT: forgets the results of the last run. COUNT is how many steps will follow.
begin_steps() {
  steps_expected=$1 steps_begun=0 steps_started=$SECONDS
  rm -rf "$results"
  mkdir -p "$results"
}

# Prints failures, skips and the totals; status 1 if anything failed.
end_steps() { node "$root/scripts/lib-totals.mjs" "$results"; }

# Reads the common options of scripts/test and scripts/check, and FORESIGHT_DATA.
# shellcheck disable=SC2034  # read by those who source this
setup_options=()
# shellcheck disable=SC2034
test_options() {
  local argument
  for argument in "$@"; do
    case $argument in
      --yes) setup_options=(--yes) ;;
      --require-data) export FORESIGHT_REQUIRE_DATA=1 ;;
      --help | -h) show_help ;;
      *) die "unknown argument '$argument'; see scripts/${0##*/} --help" ;;
    esac
  done
  if [[ -n ${FORESIGHT_DATA:-} ]]; then
    [[ -d $FORESIGHT_DATA ]] || die "FORESIGHT_DATA names the folder of real recordings, but '$FORESIGHT_DATA' is no folder"
    FORESIGHT_DATA=$(cd "$FORESIGHT_DATA" && pwd)
    export FORESIGHT_DATA
  fi
}

# run_ctest NAME PRESET [OPTION…]: the C++ tests of build/PRESET. Shows what did not pass.
run_ctest() {
  local name=$1 preset=$2
  shift 2
  on_fixed_addresses ctest --test-dir "$root/build/$preset" -j 2 --timeout 300 --no-tests=error --output-on-failure \
    --output-junit "$results/$name.junit.xml" "$@" 2>&1 |
    once_a_minute "$name" | sed -u -E '/^ *Start +[0-9]+: /d; /^Internal ctest changing/d'
}

# run_node_tests NAME FILE…
run_node_tests() {
  local name=$1
  shift
  while_counting "$name" "$results/$name.tap" \
    node --test --test-reporter=spec --test-reporter-destination="$results/$name.txt" \
    --test-reporter=tap --test-reporter-destination="$results/$name.tap" "$@" || { cat "$results/$name.txt"; return 1; }
}

# while_counting NAME TAP COMMAND…: runs the command; says once a minute how many tests its TAP file holds.
while_counting() {
  local name=$1 tap=$2 counter status=0
  shift 2
  (while sleep 60 >/dev/null 2>&1 </dev/null; do say "   $name: $(grep -c '^ *\(not \)\?ok ' "$tap" || true) tests so far"; done) &
  counter=$!
  "$@" || status=$?
  kill "$counter" 2>/dev/null || true
  wait "$counter" 2>/dev/null || true
  return "$status"
}

run_vitest() {
  (cd "$root/viewer-web" &&
    npx --no-install vitest run --reporter=default --reporter=json --outputFile.json="$results/viewer.vitest.json") \
    >"$results/viewer.txt" 2>&1 || { cat "$results/viewer.txt"; return 1; }
}

# Runs a command; shows its output only when it fails.
quietly() {
  local talk
  talk=$("$@" 2>&1) || { printf '%s\n' "$talk"; return 1; }
}

# Tests of what was built for development from outside; scripts/test and scripts/check share them. How many steps these are.
program_step_count=9
program_steps() {
  # the viewer itself was built together with the programs
  if step prepare 'viewer packages' "$root/scripts/viewer-packages"; then
    step check 'viewer types and lints' quietly npm --prefix "$root/viewer-web" run --silent check || true
    step tests 'viewer' run_vitest || true
  fi

  # tests of the checks and of the benches' statistics; they need only node
  step tests 'checks' run_node_tests checks "$root"/tests/check/*.test.mjs "$root"/tests/bench/*.test.mjs || true

  export FORESIGHT_BIN=$root/build/dev/bin
  step check 'commands in documents' node "$root/tests/check/run.mjs" commands || true

  step tests 'deploy' run_node_tests deploy "$root"/tests/deploy/*.test.mjs || true

  step tests 'guardian' run_node_tests guardian "$root"/tests/guardian/*.test.mjs || true

  # the viewer of another project, for one browser test; without it that test is skipped
  step prepare 'another viewer' another_viewer || true

  step tests 'browser' run_node_tests browser "$root"/tests/e2e/*.test.mjs || true
}

another_viewer() {
  local folder=$root/tests/e2e/independent
  [[ -d $folder/node_modules ]] || quietly npm --prefix "$folder" ci --no-fund --no-audit --loglevel=error
}

#!/bin/sh
# Builds the fuzzers with clang and runs each for a time, as many at once as there are cores.
#   tests/fuzz/run.sh [seconds per reader, default 600] [readers, default all]
# Leaves logs, grown corpora and (in crashes/) inputs that broke a reader in build/fuzz/runs. Exits non-zero on
# any report of a sanitizer. What it found and was mended belongs to tests/fuzz/corpus/<reader>/found_*.
set -eu

source=$(cd "$(dirname "$0")/../.." && pwd)
build=${ARIADNE_FUZZ_BUILD:-$source/build/fuzz}
runs=$build/runs
seconds=${1:-600}
[ $# -gt 0 ] && shift
readers=${*:-$(ls "$source/tests/fuzz/corpus")}

cmake -S "$source" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DARIADNE_FUZZ=ON -DCMAKE_UNITY_BUILD=ON > /dev/null
cmake --build "$build" --target fuzzers

run_one() {
  mkdir -p "$runs/$1" "$runs/crashes"
  echo "$1: fuzzing for $seconds s"
  status=0
  "$(find "$build" -name "$1_fuzz" -type f)" "$runs/$1" "$source/tests/fuzz/corpus/$1" \
    -max_total_time="$seconds" -max_len=4096 -timeout=10 -malloc_limit_mb=64 -print_final_stats=1 \
    -artifact_prefix="$runs/crashes/$1-" > "$runs/$1.log" 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    echo "$1: FAILED, see $runs/$1.log"
    return 1
  fi
  echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$runs/$1.log") inputs without a report"
}

# Starts the readers in turns of one per core, so that the times are comparable.
cores=$(nproc)
failed=0
set -- $readers
while [ $# -gt 0 ]; do
  pids=""
  for _ in $(seq "$cores"); do
    [ $# -gt 0 ] || break
    run_one "$1" &
    pids="$pids $!"
    shift
  done
  for pid in $pids; do
    wait "$pid" || failed=1
  done
done
exit $failed

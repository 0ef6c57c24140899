#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Verifies the Spin model of the claims policy exhaustively, and that the model sees known errors.
#   verify.sh        what fits a continuous integration run
#   verify.sh full   the larger searches too: minutes, and up to 4 GiB of memory
# Exit code: 0 all as expected, 1 not, 2 wrong arguments, 77 skipped.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case "${1:-ci}" in
  ci) memory_mib=1800 ;;
  full) memory_mib=4096 ;;
  *) echo "usage: verify.sh [full]" >&2; exit 2 ;;
esac
for tool in spin gcc; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0

field() { sed -nE "s/$1/\1/p" "$work/out" | head -1; }

# run WHAT EXPECTED MODE DEFINES…: EXPECTED is "holds", or what pan must say; MODE is safety|cycles.
run() {
  local what=$1 expected=$2 mode=$3 build=(-DSAFETY) search=() verdict errors
  shift 3
  [ "$mode" = safety ] || { build=(-DNP); search=(-l); }
  : >"$work/out"
  (cd "$work" && rm -f pan pan.* ./*.trail && spin -a -o3 "$@" "$here/claims.pml" &&
    gcc -O2 -w -DNOREDUCE -DMEMLIM=$memory_mib "${build[@]}" -o pan pan.c &&
    nice ./pan -n -m1000000 -w22 "${search[@]}") >"$work/out" 2>&1
  errors=$(field '.*errors: ([0-9]+).*')
  if [ "$expected" = holds ]; then
    verdict=holds
    { [ "$errors" = 0 ] && ! grep -qE 'not completed|max search depth|pan:.*error' "$work/out"; } || verdict=WRONG
  else
    verdict=found
    { [ "${errors:-0}" -gt 0 ] && grep -q "pan:1: .*$expected" "$work/out"; } || verdict=WRONG
  fi
  printf '%-42s %-6s %9s %6s %7s %6s  %s\n' "$what" "$verdict" "$(field ' *([0-9]+) states, stored.*')" \
    "$(field '.*depth reached ([0-9]+),.*')" "$(field ' *([0-9]+)\.[0-9]+\ttotal actual.*')" \
    "$(field '.*elapsed time ([0-9.]+) .*')" "$*"
  [ "$verdict" = WRONG ] || return 0
  wrong=1
  echo "expected: $expected; spin and pan said:"
  cut -c1-200 "$work/out" | head -30
}

spin -V
printf '%-42s %-6s %9s %6s %7s %6s  %s\n' search result states depth MiB s defines
for table in 1 2 3 4; do run "no faults, scores $table" holds safety -DTABLE=$table; done
run "no cycles at all" holds cycles -DTABLE=3 -DRENUMBER
run "a crash, a return" holds safety -DTABLE=3 -DCRASHES=1
run "a living agent is buried" holds safety -DTABLE=3 -DFALSE_BURIALS=1
run "a late message" holds safety -DTABLE=4 -DLATE_MESSAGES=1
if [ "${1:-ci}" = full ]; then
  run "a crash, a return" holds safety -DTABLE=4 -DCRASHES=1
  run "a crash, a return, ring of wishes broken" holds safety -DTABLE=1 -DCRASHES=1 -DINTRODUCED
  run "a living agent is buried, diminishing" holds safety -DTABLE=4 -DFALSE_BURIALS=1
  run "buried twice" holds safety -DTABLE=3 -DFALSE_BURIALS=2 -DINTRODUCED
  run "a late message, most contention" holds safety -DTABLE=1 -DLATE_MESSAGES=1 -DINTRODUCED
  run "two late messages" holds safety -DTABLE=4 -DLATE_MESSAGES=2 -DINTRODUCED
  run "crash, return, late message (agent 0)" holds safety -DTABLE=3 -DCRASHES=1 -DLATE_MESSAGES=1 -DUNLUCKY=0 -DINTRODUCED
  run "crash, return, burial (agent 0 crashes)" holds safety -DTABLE=3 -DCRASHES=1 -DFALSE_BURIALS=1 -DUNLUCKY=0 -DINTRODUCED
fi

faulty=(-DTABLE=1 -DCRASHES=1)
run "witness: agreement after a return" W_no_agreement_after_return safety "${faulty[@]}" -DWITNESS
run "mutant: ready before the decision" S1_no_task_is_left_out safety -DTABLE=1 -DMUTANT_READY_EARLY
run "mutant: one incarnation, hash of keys" S1_no_task_is_owned_twice safety "${faulty[@]}" -DMUTANT_SAME_INCARNATION -DMUTANT_HASH_OF_KEYS
run "mutant: one incarnation, full hash" L1_rest_is_agreement safety "${faulty[@]}" -DMUTANT_SAME_INCARNATION
run "mutant: bids not warped" L1_minds_settle safety -DTABLE=3 -DMUTANT_NO_WARP
run "mutant: bids not warped, cycle" "non-progress cycle" cycles -DTABLE=3 -DRENUMBER -DMUTANT_NO_WARP
exit $wrong

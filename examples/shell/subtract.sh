#!/usr/bin/env bash
# Removes the gear from the cow, checks the result, and draws it. Usage: subtract.sh DATA OUT
set -euo pipefail
data=$1 out=$2
strata difference "$data/spot.obj" "$data/gear.off" -o "$out/cut.ply" --certify --report "$out/report.json"
strata check "$out/cut.ply"
strata draw "$out/cut.ply" --direction -1,-0.35,1 --up 0,1,0 --style both -o "$out/subtract.svg"

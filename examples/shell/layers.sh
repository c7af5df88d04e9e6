#!/usr/bin/env bash
# Layers for a printer: the bracket in steps of a fifth, as SVG, and how many polygons each one has. Usage: layers.sh DATA OUT
set -euo pipefail
data=$1 out=$2
strata slice "$data/bracket.off" --along z --step 0.2 -o "$out/layers.svg"
strata slice "$data/bracket.off" --along z --step 0.2 -o "$out/layers.wkt" -q
grep -c . "$out/layers.wkt"

#!/usr/bin/env bash
# Checks all meshes of a folder, in a pool of processes; lists those that are no solids. Usage: check_folder.sh DATA OUT
set -euo pipefail
data=$1 out=$2
for file in "$data"/*.off "$data"/*.obj; do
  printf '{"id": "%s", "args": ["check", "%s"]}\n' "$(basename "$file")" "$file"
done >"$out/jobs.jsonl"
strata batch "$out/jobs.jsonl" -o "$out/records.jsonl" || true  # exit code 1: not all are solids
grep -v '"status":"ok"' "$out/records.jsonl" || echo "all $(wc -l <"$out/records.jsonl") are solids"

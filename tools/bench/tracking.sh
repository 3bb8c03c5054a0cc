#!/usr/bin/env bash
# Tracking on a rendered clip: aspect-replay with and without --track and, where it was built
# (cmake -DASPECT_VISP=ON), ViSP's model-based tracker, one after the other on one core.
# usage: tools/bench/tracking.sh OBJECTS.py INDEX_FOLDER CLIP [SEED]
# INDEX_FOLDER has the objects' indexes, NAME.index or NAME.aspect; CLIP is rendered by make_clip.py if
# it is not there. BUILD: the folder of the programs [build/release/bin].
set -euo pipefail
[ $# -ge 3 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
objects=$1 indexes=$2 clip=$3 seed=${4:-1}
here=$(cd "$(dirname "$0")" && pwd)
build=${BUILD:-$here/../../build/release/bin}
[ -f "$clip/truth.csv" ] || "$here/make_clip.py" "$objects" "$clip" --seed "$seed"
arguments=()
for index in "$indexes"/*.index "$indexes"/*.aspect; do
  [ -f "$index" ] && arguments+=(--index "$index")
done
[ ${#arguments[@]} -gt 0 ] || { echo "tracking.sh: $indexes: no indexes in it; compile the objects" >&2; exit 1; }
arguments+=(--config "$clip/camera.toml" --top 1)

score() {  # NAME COMMAND...
  echo "$1"
  OMP_NUM_THREADS=1 taskset -c 0 "${@:2}" >"$clip/$1.ndjson"
  "$here/score_clip.py" "$clip/truth.csv" "$clip/$1.ndjson" | sed 's/^/  /'
}
score tracked "$build/aspect-replay" "${arguments[@]}" --track "$clip/frames"
score each-frame "$build/aspect-replay" "${arguments[@]}" "$clip/frames"
if [ -x "$build/visp-clip" ]; then
  "$here/visp_models.py" "$objects" "$clip"
  score visp "$build/visp-clip" "$clip"
fi

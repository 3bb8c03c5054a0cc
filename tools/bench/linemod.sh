#!/usr/bin/env bash
# Recognition on a set of frames with truth: aspect-replay and OpenCV's LINEMOD, one after the other,
# each on one core. LINEMOD is built by cmake -DASPECT_LINEMOD=ON, with Debian's libopencv-contrib-dev.
# usage: tools/bench/linemod.sh SET SCENE_FOLDER INDEX_FOLDER SCORE.py OUT [OPTION...]
# SET has frames/, truth.csv and camera.toml; the objects are those of SCENE_FOLDER/NAME.b, their indexes
# INDEX_FOLDER/NAME.index. OPTIONs are linemod-clutter's. BUILD: the folder of the programs [build/release/bin].
set -euo pipefail
[ $# -ge 5 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
set_folder=$1 scenes=$2 indexes=$3 score=$4 out=$5
shift 5
here=$(cd "$(dirname "$0")" && pwd)
build=${BUILD:-$here/../../build/release/bin}
mkdir -p "$out"
scene_arguments=() index_arguments=() index_bytes=0
for scene in "$scenes"/*.b; do
  index=$indexes/$(basename "$scene" .b).index
  [ -f "$index" ] || { echo "linemod.sh: $index: not there; compile $scene with aspectc" >&2; exit 1; }
  scene_arguments+=(--scene "$scene")
  index_arguments+=(--index "$index")
  index_bytes=$((index_bytes + $(stat -c %s "$index")))
done

export OMP_NUM_THREADS=1
taskset -c 0 "$build/aspect-replay" "${index_arguments[@]}" --config "$set_folder/camera.toml" --top 1 \
  "$set_folder/frames" >"$out/aspect.ndjson"
# Its templates are made on two cores, its frames matched on one.
"$build/linemod-clutter" "$set_folder" "$out" "${scene_arguments[@]}" "$@"

row() {  # FILE.ndjson
  "$score" "$set_folder/truth.csv" "$1" | python3 -c '
import json, sys
scored = json.load(sys.stdin)["all"]
keys = "recall pose_median_deg pose_within5 shift_median false_per_frame ms_median ms_p99".split()
print("|", sys.argv[1], "|", " | ".join(str(scored[key]) for key in keys), "|")' "$(basename "$1" .ndjson)"
}
echo "| program and threshold | right | pose, median degrees | within 5 degrees | shift | falsely named a frame | ms, median | ms, slowest in 100 |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
for found in "$out"/*.ndjson; do row "$found"; done
echo "indexes: $((index_bytes / 1024)) KiB"
if compgen -G "$out/templates_*.yml.gz" >/dev/null; then
  echo "templates: $(($(cat "$out"/templates_*.yml.gz | wc -c) / 1024)) KiB"
fi

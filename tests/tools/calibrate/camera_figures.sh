#!/usr/bin/env bash
# How exactly aspect-calibrate measures a camera: sets of 12 rendered pictures, one a seed.
#   camera_figures.sh BUILD_FOLDER [checkerboard|charuco] [SEEDS] [WIDTH] [BLUR] [NOISE]
set -euo pipefail
build=$1 kind=${2:-checkerboard} seeds=${3:-10} width=${4:-640} blur=${5:-0.7} noise=${6:-2}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for seed in $(seq "$seeds"); do
  truth=$("$build"/bin/make_board_pictures "$folder/$seed" "$kind" 12 "$width" "$seed" "$blur" "$noise" | tail -1)
  "$build"/bin/aspect-calibrate camera --kind "$kind" --json "$folder/$seed" 2>/dev/null > "$folder/$seed.json"
  python3 - "$folder/$seed.json" "$seed" $truth <<'END'
import json, sys
seen = json.load(open(sys.argv[1])); words = sys.argv[3:]; truth = dict(zip(words[::2], map(float, words[1::2]))); c = seen["camera"]
print("seed %s: fx %+.3f %% fy %+.3f %% cx %+.2f cy %+.2f px, residual %.3f px, covered %.0f %%" % (sys.argv[2], 100 * (c["fx"] / truth["fx"] - 1), 100 * (c["fy"] / truth["fy"] - 1), c["cx"] - truth["cx"], c["cy"] - truth["cy"], seen["residual_px"], 100 * seen["covered"]))
END
done

#!/usr/bin/env python3
"""Does what a page of tools/docs says: page_test.py SOURCE_DIR PROGRAMS PAGE.md

Runs its commands (blocks marked sh) from top to bottom in one folder, checks that every option of
our programs that it names exists, in blocks for boards as well, and that its links lead somewhere."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PROGRAMS = ("aspectc", "aspect-replay", "aspectd", "aspect-eval", "aspect-report", "aspect-score", "aspect-bench",
            "aspect-calibrate", "aspect-export")


def blocks(text):
    """(marks, commands) of each fenced block."""
    return [(info.split(), body) for info, body in re.findall(r"^```([^\n]*)\n(.*?)^```", text, re.M | re.S)]


def commands(text):
    """Lines that call one of our programs, from blocks and from `code`."""
    for marks, body in blocks(text):
        if marks[:1] == ["sh"]:
            yield from body.replace("\\\n", " ").splitlines()
    for code in re.findall(r"`([^`\n]+)`", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
        yield code


def unknown_options(text, programs):
    helps = {}
    for line in commands(text):
        try:
            words = shlex.split(line, comments=True)
        except ValueError:
            continue
        if not words or words[0] not in PROGRAMS:
            continue
        call = (words[0],)
        if words[0] == "aspectc" and len(words) > 1 and words[1] in ("init", "doctor", "convert", "explain", "render", "inspect", "models-info"):
            call = tuple(words[:2])
        if words[0] == "aspect-calibrate" and len(words) > 1 and words[1] in ("board", "camera", "colours", "noise", "segmentation"):
            call = tuple(words[:2])
        if call not in helps:
            helps[call] = subprocess.run([programs / call[0], *call[1:], "--help"], text=True,
                                         capture_output=True, check=True).stdout
        for word in words:
            option = word.split("=")[0]
            if re.fullmatch(r"--?[a-z][\w-]*", option) and not re.search(re.escape(option) + r"\b", helps[call]):
                yield f"{' '.join(call)} has no option {option}: {line}"


def broken_links(text, page):
    for link in re.findall(r"\]\(([^)#]+)[^)]*\)", text):
        # Pictures are made later, by make_pictures.sh.
        if not re.match(r"\w+:", link) and not link.startswith("pictures/") and not (page.parent / link).exists():
            yield f"{page.name}: {link} is not there"


def run(text, source, programs, folder):
    (folder / "photos").mkdir()
    for picture in sorted((source / "tests/data/cluttered/frames").glob("*.jpg"))[:3]:
        shutil.copy(picture, folder / "photos")
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", MODELS=str(source / "compiler/models"))
    done = 0
    for marks, body in blocks(text):
        if marks != ["sh"]:
            continue
        result = subprocess.run(["bash", "-euo", "pipefail", "-c", body], cwd=folder, env=environment,
                                text=True, capture_output=True)
        if result.returncode:
            sys.exit(f"failed with {result.returncode}:\n{body}\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
        done += 1
    return done


def main():
    source, programs, page = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    page = source / page
    text = page.read_text()
    faults = [*unknown_options(text, programs), *broken_links(text, page)]
    if faults:
        sys.exit("\n".join(faults))
    with tempfile.TemporaryDirectory() as folder:
        done = run(text, source, programs, pathlib.Path(folder))
    print(f"{page.name}: {done} blocks run")


if __name__ == "__main__":
    main()

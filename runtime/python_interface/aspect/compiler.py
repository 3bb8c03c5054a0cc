"""The compiler, where it is installed: aspectc as a function."""
import os
import pathlib
import shutil
import subprocess

from . import _native


def _aspectc():
    named = os.environ.get("ASPECTC")
    if named:
        return named
    # Beside the module in the folder that it was built in.
    built = pathlib.Path(__file__).resolve().parents[2] / "bin" / "aspectc"
    found = str(built) if built.exists() else shutil.which("aspectc")
    if found is None:
        raise _native.Error("aspectc is not installed; install aspect-compiler, or name it in the "
                            "environment variable ASPECTC")
    return found


def _words(options):
    for key, value in options.items():
        option = "--" + key.replace("_", "-")
        if value is True:
            yield option
        elif value is None or value is False:
            continue
        elif isinstance(value, (list, tuple)):
            yield option
            yield ",".join(str(each) for each in value)
        else:
            yield option
            yield str(value)


def compile(scene, output=None, *, progress=False, **options):
    """Compiles a scene, a mesh or a project into a class index, and returns the index's path.

    Options are those of `aspectc --help`, with _ for -: level=4, max_index_kib=32, no_store=True.
    progress=True shows aspectc's progress on standard error. A run that is interrupted goes on where
    it was when it is called again, unless no_store=True. Raises aspect.Error with aspectc's line.
    """
    scene = pathlib.Path(scene)
    if not scene.exists():
        raise FileNotFoundError(2, "no such file", str(scene))
    command = [_aspectc(), os.fspath(scene), *_words(options), "--progress",
               "always" if progress else "never"]
    if output is not None:
        command += ["-o", os.fspath(output)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True,
                          stderr=None if progress else subprocess.PIPE) as running:
        try:
            said, errors = running.communicate()
        except BaseException:
            # As Ctrl-C in a terminal: the work done so far is kept.
            running.terminate()
            running.wait()
            raise
    if running.returncode != 0:
        lines = [line for line in (errors or said).splitlines() if line]
        raise _native.Error(lines[-1] if lines else f"aspectc ended with {running.returncode}")
    return pathlib.Path(output) if output is not None else pathlib.Path(scene.stem + ".aspect")

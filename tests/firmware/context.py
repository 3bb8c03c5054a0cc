"""What every firmware test is called with, and how it fails."""

import argparse
import os
import subprocess
import sys
import traceback

import guest

OBJECTS = ("blockcyl1", "blockcyl2", "cube", "l_shape", "pegblock")


class Failure(Exception):
    """A promise that was not kept; one line and what it was seen in."""


def check(holds, what):
    if not holds:
        raise Failure(what)


class Context:
    """Paths of one architecture, and a boot with everything in it."""

    def __init__(self, arguments):
        self.arch = arguments.arch
        self.processor = arguments.processor or arguments.arch
        self.build = arguments.build
        self.replay = arguments.replay
        self.device_programs = arguments.device_programs
        self.guest_programs = arguments.guest_programs

    def frame_file(self, name):
        return os.path.join(self.build, "frames", name)

    def index_files(self):
        return [os.path.join(self.build, "indexes", name + ".aspect") for name in OBJECTS]

    def boot(self, name, script, files, frame_files=(), **options):
        """`files` besides the programs, the indexes and the frames, which are always there."""
        steps = os.path.join(os.path.dirname(os.path.abspath(__file__)), "steps.sh")
        everything = {"test/steps": steps}
        for program in ("feeder", "grab", "stamp"):
            everything["bin/" + program] = os.path.join(self.guest_programs, program)
        for index in self.index_files():
            everything["test/" + os.path.basename(index)] = index
        for frame_file in frame_files:
            everything["test/" + frame_file] = self.frame_file(frame_file)
        everything.update(files)
        kept = os.path.join(self.build, "%s-%s" % (name, self.arch))
        outcome = guest.boot(self.arch, os.path.join(self.build, "rootfs-" + self.arch),
                             everything, script, keep=kept + ".console",
                             keep_results=kept + ".results", **options)
        print("%s %s: %.1f s of the guest in %.1f s" % (
            name, self.arch, outcome.guest_s, outcome.wall_s))
        return outcome

    def boot_service(self, name, watch, files):
        """As on a board: aspectd is started by the root file system; `watch` is a program that
        looks on. The console's text."""
        extra = guest.with_modes(files)
        extra["etc/start.d/50-watch"] = (0o755, watch.encode())
        console, _, wall_s = guest.boot_console(
            self.arch, os.path.join(self.build, "rootfs-" + self.arch), extra,
            keep=os.path.join(self.build, "%s-%s.console" % (name, self.arch)))
        print("%s %s: %.1f s" % (name, self.arch, wall_s))
        return console

    def replayed(self, frame_file):
        """The lines of aspect-replay on this machine."""
        command = [self.replay, self.frame_file(frame_file)]
        for index in self.index_files():
            command += ["--index", index]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        check(run.returncode == 0, "aspect-replay: " + run.stderr.decode())
        return run.stdout.decode().splitlines()


def run(test):
    parser = argparse.ArgumentParser()
    parser.add_argument("--arch", required=True, choices=["arm64", "amd64"])
    parser.add_argument("--processor", help="that --device-programs are for; as --arch if left out")
    parser.add_argument("--build", required=True, help="folder that prepare.sh filled")
    parser.add_argument("--guest-programs", required=True, help="feeder, grab and stamp")
    parser.add_argument("--device-programs", required=True, help="static aspectd, aspect-replay")
    parser.add_argument("--replay", required=True, help="aspect-replay of this machine")
    context = Context(parser.parse_args())
    try:
        test(context)
    except (Failure, guest.GuestFailed) as failure:
        print("FAILED: %s" % failure)
        sys.exit(1)
    except Exception:
        traceback.print_exc()
        sys.exit(1)

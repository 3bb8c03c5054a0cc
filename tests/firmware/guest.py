"""Boots a kernel in QEMU, in the mode where its clock counts instructions, and brings back what it
wrote: the console, and the files of its folder /run/results.

The root file system is make_rootfs.sh's. What a test needs besides goes behind it as a second
archive: files, and a shell script that runs at the end of the start-up, before aspectd. One
instruction takes a nanosecond of the guest's time; idle time is skipped. The same guest writes the
same times on every machine, so time limits of the guest are exact; the wall's only end a hung guest.
"""

import io
import os
import re
import signal
import subprocess
import tarfile
import tempfile
import time

END_MARKER = "guest: all done"
TROUBLE = re.compile(
    r"Kernel panic|\bOops\b|\bBUG:|WARNING: CPU|Call Trace|segfault|Unable to handle kernel"
    r"|general protection|Out of memory|rcu_sched self-detected|hung task")

QEMU = {
    "arm64": ["qemu-system-aarch64", "-M", "virt,dtb-randomness=off", "-cpu", "cortex-a53"],
    "amd64": ["qemu-system-x86_64", "-M", "pc", "-cpu", "qemu64"],
}
CONSOLE = {"arm64": "ttyAMA0", "amd64": "ttyS0"}

# The test's script stands in `script`; its status is looked at outside.
START = """#!/bin/sh
mkdir -p /run/results
cd /run/results
sh -e /test/script >/run/results/script.log 2>&1
echo $? >/run/results/status
tail -n 5 /run/results/script.log
tar -c -f - -C /run/results . >/dev/vport0p1
echo "guest: uptime $(cut -d' ' -f1 /proc/uptime)"
echo "%s"
poweroff -f
""" % END_MARKER


class GuestFailed(Exception):
    """A guest that did not do what it should; with its console."""


class Outcome:
    """What a guest left behind."""

    def __init__(self, console, files, wall_s):
        self.console = console
        self.files = files
        self.wall_s = wall_s
        uptime = re.search(r"guest: uptime ([0-9.]+)", console)
        self.guest_s = float(uptime.group(1)) if uptime else float("nan")

    def save(self, folder):
        os.makedirs(folder, exist_ok=True)
        for name, data in self.files.items():
            with open(os.path.join(folder, name), "wb") as file:
                file.write(data)

    def text(self, name):
        """A file of /run/results."""
        if name not in self.files:
            raise GuestFailed("the guest left no file %s, only %s" % (name, sorted(self.files)))
        return self.files[name].decode("utf-8", "replace")


def archive(files):
    """A cpio archive (newc) of {path: (mode, bytes)}; folders are made as needed."""
    out = io.BytesIO()
    folders = set()

    def entry(path, mode, data):
        name = path.encode() + b"\0"
        fields = [entry.number, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name), 0]
        entry.number += 1
        out.write(b"070701" + b"".join(b"%08X" % field for field in fields) + name)
        out.write(b"\0" * (-out.tell() % 4) + data)
        out.write(b"\0" * (-out.tell() % 4))

    entry.number = 1
    for path, (mode, data) in files.items():
        parts = path.strip("/").split("/")
        for depth in range(1, len(parts)):
            folder = "/".join(parts[:depth])
            if folder not in folders:
                folders.add(folder)
                entry(folder, 0o040755, b"")
        entry("/".join(parts), 0o100000 | mode, data)
    entry.number = 0
    entry("TRAILER!!!", 0, b"")
    return out.getvalue()


def padded(data):
    """The kernel looks for the next archive at a multiple of four bytes."""
    return data + b"\0" * (-len(data) % 4)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def command_line(arch, image, initrd, results, memory_mb, shift):
    console = CONSOLE[arch]
    return QEMU[arch] + [
        "-accel", "tcg", "-m", str(memory_mb), "-smp", "1", "-nographic", "-nic", "none",
        "-no-reboot", "-icount", "shift=%d,sleep=off" % shift,
        "-rtc", "base=2024-01-01,clock=vm", "-device", "virtio-serial-pci",
        "-chardev", "file,id=results,path=" + results,
        "-device", "virtserialport,chardev=results,name=results",
        "-kernel", image + ".kernel", "-initrd", initrd,
        "-append", "console=%s panic=-1 loglevel=5 nokaslr" % console]


def run_qemu(command, limit_s):
    """The console's text. Ends QEMU, by its process, when the time is over."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, start_new_session=True) as qemu:
        try:
            console, _ = qemu.communicate(timeout=limit_s)
        except (subprocess.TimeoutExpired, KeyboardInterrupt):
            os.killpg(qemu.pid, signal.SIGKILL)
            console, _ = qemu.communicate()
            console += b"\nguest.py: ended after %d s of wall time\n" % limit_s
    return console.decode("utf-8", "replace").replace("\r\n", "\n")


def boot_console(arch, image, extra, limit_s=150, memory_mb=512, shift=0, keep=None):
    """Boots `image` with a second archive of `extra`, {path: (mode, bytes)}. The console, what came
    out of the port, and the wall time. GuestFailed without the end marker, or with a complaint."""
    with tempfile.TemporaryDirectory(prefix="aspect-guest-") as folder:
        initrd = os.path.join(folder, "initrd")
        with open(initrd, "wb") as file:
            file.write(padded(read(image)) + archive(extra))
        results = os.path.join(folder, "results")
        started = time.monotonic()
        console = run_qemu(command_line(arch, image, initrd, results, memory_mb, shift), limit_s)
        wall_s = time.monotonic() - started
        packed = read(results) if os.path.exists(results) else b""
    if keep:
        with open(keep, "w", encoding="utf-8") as file:
            file.write(console)
    if END_MARKER not in console:
        raise GuestFailed("the guest never reached its end\n" + console)
    trouble = TROUBLE.search(console)
    if trouble:
        raise GuestFailed("the kernel complains: %s\n%s" % (trouble.group(0), console))
    return console, packed, wall_s


def with_modes(files):
    """{path in the guest: path here, or bytes} as {path: (mode, bytes)}; programs stay programs."""
    extra = {}
    for path, source in files.items():
        data = source if isinstance(source, bytes) else read(source)
        program = not isinstance(source, bytes) and os.access(source, os.X_OK)
        extra[path.strip("/")] = (0o755 if program else 0o644, data)
    return extra


def boot(arch, image, files, script, keep_results=None, **options):
    """Boots `image` with files {path in the guest: path here, or bytes} and runs `script` instead
    of the service. Keeps its results in a folder. GuestFailed where anything is not as it should."""
    extra = with_modes(files)
    extra["etc/start.d/50-test"] = (0o755, START.encode())
    extra["test/script"] = (0o644, script.encode())
    console, packed, wall_s = boot_console(arch, image, extra, **options)
    outcome = Outcome(console, unpack(packed), wall_s)
    if keep_results:
        outcome.save(keep_results)
    status = outcome.text("status").strip()
    if status != "0":
        raise GuestFailed("the script ended with status %s\n%s" % (
            status, outcome.text("script.log")))
    return outcome


def unpack(packed):
    with tarfile.open(fileobj=io.BytesIO(packed)) as tar:
        return {member.name[2:]: tar.extractfile(member).read()
                for member in tar.getmembers() if member.isfile()}

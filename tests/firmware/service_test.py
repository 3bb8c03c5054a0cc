#!/usr/bin/env python3
"""The root file system by itself: aspectd is started as its own user, and again when it dies."""

import re

import daemon_contract as contract
from context import check, run

# Looks on from outside while init goes on, and ends the guest.
WATCH = """#!/bin/sh
(
  sleep 2
  pid=$(pidof aspectd)
  echo "watch: first $pid user $(stat -c %U /proc/$pid)"
  kill -KILL $pid
  sleep 3
  pid=$(pidof aspectd)
  echo "watch: second $pid user $(stat -c %U /proc/$pid)"
  ps -o user,comm
  echo "guest: all done"
  poweroff -f
) &
"""


def service_test(context):
    files = {"etc/aspect/aspectd.toml": contract.configuration(["cube.aspect"], 640, 480, "RGB3"),
             "etc/aspect/cube.aspect": context.index_files()[2]}
    console = context.boot_service("service", WATCH, files)
    watched = re.findall(r"watch: \w+ (\d+) user (\w+)", console)
    check(len(watched) == 2, "aspectd was not there twice:\n" + console)
    check(watched[0][0] != watched[1][0], "aspectd was not ended:\n" + console)
    check({user for _, user in watched} == {"aspect"}, "another user than aspect:\n" + console)
    check(console.count("aspectd: ready") == 2, "aspectd was not ready twice:\n" + console)
    check(console.count('"state":"streaming"') == 2, "aspectd did not stream twice:\n" + console)


if __name__ == "__main__":
    run(service_test)

#!/usr/bin/env python3
"""Prints how long the player takes from its start to the first picture of a wall, off screen, with a warm catalogue.

    bench/playback/start.py BUILD_DIRECTORY MEDIA_FOLDER STATE_DIRECTORY [RUNS]

The state directory is the one that the analyzer keeps for the folder. Wall time depends on what else the machine does: the processor seconds until then stand beside it.
"""
import os
import subprocess
import sys
import time
from pathlib import Path

BUILD, MEDIA, STATE = (Path(word).resolve() for word in sys.argv[1:4])
RUNS = int(sys.argv[4]) if len(sys.argv) > 4 else 5
TICK = os.sysconf("SC_CLK_TCK")


def processor_seconds(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def start(settings):
    command = [BUILD / "player" / "vitrine-player", *settings, "--screen", "offscreen:1280x720", "--pace", "realtime", "--duration", "20s", "--log.level", "debug"]
    began = time.monotonic()
    process = subprocess.Popen(list(map(str, command)), stderr=subprocess.PIPE, text=True)
    for line in process.stderr:
        if "appears" in line:
            took, cpu = time.monotonic() - began, processor_seconds(process.pid)
            process.terminate()  # in order, so that nobody is blamed for its end
            process.wait()
            return took, cpu
    sys.exit("there was no picture")


def main():
    for _ in range(RUNS):
        took, cpu = start(["--media.root", MEDIA, "--state.directory", STATE])
        print(f"first picture after {1000 * took:.0f} ms, {1000 * cpu:.0f} ms of processor time", flush=True)


if __name__ == "__main__":
    main()

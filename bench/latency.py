#!/usr/bin/env python3
"""Prints how long it takes from a file landing in the folder to its first frame on the wall.

    bench/latency.py BUILD_DIRECTORY [FILM]

Runs both programs as a box does, off screen at their own pace, with the shipped settings but a wall that is not full. FILM is a
ten-minute 720p film (default: drawn by ffmpeg). Also prints what playing a shot from its clip costs against playing it from the
film, in processor time of the same run, and what the store takes. Nothing here passes or fails.
"""
import atexit
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 120  # seconds
DRAWN_SECONDS, FILM_SECONDS = 60, 600


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


class Said:
    """The lines of a program's log with the time at which each came."""

    def __init__(self, process):
        self.lines = []
        self.changed = threading.Condition()
        threading.Thread(target=self.read, args=[process.stderr], daemon=True).start()

    def read(self, stream):
        for line in stream:
            with self.changed:
                self.lines.append((time.monotonic(), line.strip()))
                self.changed.notify_all()

    def heard(self, pattern, since):
        """The first line like this that came at `since` or later: when, and what of it matched."""
        found = None

        def is_there():
            nonlocal found
            matches = ((at, re.search(pattern, line)) for at, line in self.lines if at >= since)
            found = next((pair for pair in matches if pair[1]), None)
            return found is not None

        with self.changed:
            if not self.changed.wait_for(is_there, PATIENCE):
                sys.exit(f"'{pattern}' never came:\n" + "\n".join(line for _, line in self.lines[-20:]))
        return found

    def when(self, pattern, since):
        return self.heard(pattern, since)[0]

    def line(self, pattern, since):
        return self.heard(pattern, since)[1]


def start(*command):
    process = subprocess.Popen(list(map(str, command)), stderr=subprocess.PIPE, text=True)
    atexit.register(process.kill)  # whatever happens here
    return process, Said(process)


def stop(process):
    process.send_signal(signal.SIGTERM)
    process.wait(PATIENCE)


def land(file, folder):
    """Copies it in as a file manager does: another name, then renamed. The copying does not count."""
    shutil.copyfile(file, folder / "landing.part")
    os.rename(folder / "landing.part", folder / file.name)
    return time.monotonic()


def make_film(path):
    """Ten minutes in shots of five seconds; drawn once a minute long."""
    minute = path.with_suffix(".minute.mp4")
    shots = DRAWN_SECONDS // 5
    hues = "+".join(f"between(t,{5 * i},{5 * i + 5})*{(i * 137) % 360}" for i in range(shots))
    ffmpeg("-f", "lavfi", "-i", f"testsrc2=size=1280x720:rate=30:duration={DRAWN_SECONDS}", "-vf", f"hue=h='{hues}',noise=alls=6:allf=t",
           "-pix_fmt", "yuv420p", "-c:v", "libx264", "-preset", "veryfast", "-b:v", "4000k", "-g", 60, "-bf", 2, minute)
    ffmpeg("-stream_loop", FILM_SECONDS // DRAWN_SECONDS - 1, "-i", minute, "-c", "copy", path)
    minute.unlink()


def make_photo(path, i):
    """Patterns that are not alike: near-copies would be one for the wall."""
    pattern = ["mandelbrot=start_scale=3:", "testsrc2=", "sierpinski=", "smptehdbars="][i]
    ffmpeg("-f", "lavfi", "-i", f"{pattern}size=1000x750:rate=1", "-frames:v", 1, "-vf", "scale=4000:3000,noise=alls=12", "-q:v", 3, path)


def begin(root, state):
    settings = ["--media.root", root, "--state.directory", state]
    analyzer, noted = start(ANALYZER, "watch", *settings)
    player, shown = start(PLAYER, *settings, "--screen", "offscreen:1280x720", "--pace", "realtime", "--log.level", "debug")
    began = time.monotonic()
    noted.when("watching", began - 1)
    shown.when("screen:", began - 1)
    return analyzer, player, shown


def measure_latency(root, files, shown):
    items = len([file for file in root.iterdir() if file.is_file()])
    for i, file in enumerate(files, items):
        at = land(file, root)
        known = shown.when(rf"new: '{file.name}'", at)
        source = shown.line(rf"source (\d+): '{file.name}'", at)[1]
        seen = shown.when(rf"source {source} appears", at)
        print(f"{file.name}: {known - at:.2f} s until the player knows of it, {seen - at:.2f} s until its first frame is drawn", flush=True)
        shown.when(f"wall of {i + 1} item", at)  # the crossfade is not part of the next


def measure_notice(root, photo, shown, beside):
    """A notice of 12 megapixels, from its landing until it is all that the screen shows."""
    file = photo.with_name(f"!NOW 20min {beside}.jpg")
    shutil.copyfile(photo, file)
    at = land(file, root)
    known = shown.when(r"new: '!NOW", at)
    source = shown.line(r"source (\d+): '!NOW", at)[1]
    seen = shown.when(rf"source {source} appears", at)
    whole = shown.when("wall of 1 item", seen)
    print(f"a notice of 12 MP beside {beside}: {known - at:.2f} s until the player knows of it, {seen - at:.2f} s until it comes, "
          f"{whole - at:.2f} s until it is the whole screen", flush=True)
    return root / file.name


def record_of(state, name):
    for file in (state / "catalogue").glob("*.json"):
        record = json.loads(file.read_text())
        if record["path"] == name:
            return record
    return None


def decoding(file, begin, seconds):
    """Processor seconds of decoding a part of a film in one thread."""
    before = os.times()
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-threads", "1", "-ss", str(begin), "-t", str(seconds), "-i", str(file), "-an", "-f", "null", "-"],
                   check=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def measure_clips(state, film):
    shots = [shot for shot in record_of(state, film.name)["shots"] if "stored" in shot][:4]
    whole = clips = size = length = 0
    for shot in shots:
        begin, seconds = shot["begin_ns"] / 1e9, (shot["end_ns"] - shot["begin_ns"]) / 1e9
        clip = state / "store" / shot["stored"]["file"]
        whole += decoding(film, begin, seconds)
        clips += decoding(clip, 0, seconds)
        size += clip.stat().st_size
        length += seconds
    rate = film.stat().st_size / FILM_SECONDS
    print(f"{len(shots)} clips of {shots[0]['stored']['width']}x{shots[0]['stored']['height']}: decoding costs {clips / whole:.2f} of the film's, "
          f"{size / length / 1000:.0f} kB a second, {size / length / rate:.2f} of the film's")


def main():
    with tempfile.TemporaryDirectory(prefix="vitrine-latency-") as name:
        work = Path(name)
        root, state = work / "media", work / "state"
        root.mkdir()
        photos = [work / f"photo{i}.jpg" for i in range(3)]
        for i, photo in enumerate(photos):
            make_photo(photo, i)
        film = work / "film.mp4"
        if len(sys.argv) > 2:
            film = Path(sys.argv[2])
        else:
            make_film(film)
        *programs, shown = begin(root, state)
        notice = work / "notice.jpg"
        make_photo(notice, 3)
        measure_latency(root, photos, shown)
        measure_notice(root, notice, shown, "photos").unlink()
        shown.when(f"wall of {len(photos)} items", time.monotonic())
        measure_latency(root, [film], shown)
        measure_notice(root, notice, shown, "a film that is analysed")
        end = time.monotonic() + PATIENCE
        while sum("stored" in shot for shot in record_of(state, film.name)["shots"]) < 4 and time.monotonic() < end:
            time.sleep(0.5)
        for program in programs:
            stop(program)
        measure_clips(state, film)


if __name__ == "__main__":
    main()

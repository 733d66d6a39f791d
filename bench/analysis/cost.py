#!/usr/bin/env python3
"""Prints what the analysis costs, against decoding alone in the same run.

    bench/analysis/cost.py BUILD_DIRECTORY [--media DIR] [--films DIR] [--pairs 3] [--hours 2] [--threads 2]

Analysis of a 1080p H.264 film of about 10 Mb/s against ffmpeg's pure decoding of it with the same number of threads, in
interleaved pairs; a 12-megapixel JPEG from spawn to record; the peak memory of a film of --hours hours (0: left out), with
its growth over the second half. DIR holds clips and photos of which the film and the JPEG are made (default: shared/media
beside the tree; where it is missing both are drawn). --films keeps what is made for another run. Everything is processor
time: other work on the machine changes it little. Nothing here passes or fails.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
RATE = 30
CLIPS = ["single/dog_and_woman.mp4", "single/frog_toy.mp4", "edited/bbb_30s_854x480.mp4"]
CLIP_SECONDS = 9
PHOTO = "photos/immich_craft-beer_24mp.jpg"
ENCODER = ["-c:v", "libx264", "-preset", "fast", "-b:v", "10M", "-maxrate", "12M", "-bufsize", "10M", "-g", "60", "-an",
           "-pix_fmt", "yuv420p", "-color_primaries", "bt709", "-color_trc", "bt709", "-colorspace", "bt709"]


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def make_film(path, media):
    """Real clips joined, scaled to 1080p, with the grain that the bit rate pays for."""
    clips = [media / clip for clip in CLIPS if (media / clip).is_file()]
    shape = f"trim=duration={CLIP_SECONDS},fps={RATE},scale=1920:1080,setsar=1,format=yuv420p,noise=alls=6:allf=t"
    inputs = [word for clip in clips for word in ("-i", clip)]
    if not clips:
        inputs = ["-f", "lavfi", "-i", f"mandelbrot=size=1920x1080:rate={RATE}",
                  "-f", "lavfi", "-i", f"testsrc2=size=1920x1080:rate={RATE}"]
    parts = [f"[{i}:v]{shape}[p{i}]" for i in range(len(clips) or 2)]
    joined = "".join(f"[p{i}]" for i in range(len(parts))) + f"concat=n={len(parts)}[all]"
    ffmpeg(*inputs, "-filter_complex", ";".join([*parts, joined]), "-map", "[all]", *ENCODER, path)


def make_jpeg(path, media):
    source = ["-i", media / PHOTO] if (media / PHOTO).is_file() else ["-f", "lavfi", "-i", "mandelbrot=size=2000x1500"]
    ffmpeg(*source, "-frames:v", 1, "-vf", "scale=4243:2829", "-q:v", 3, path)


def frames_of(film):
    said = subprocess.run(["ffprobe", "-v", "error", "-select_streams", "v", "-show_entries", "stream=nb_frames,bit_rate", "-of",
                           "json", str(film)], check=True, capture_output=True).stdout
    stream = json.loads(said)["streams"][0]
    return int(stream["nb_frames"]), int(stream["bit_rate"])


def cost(command):
    """Processor seconds, wall seconds, peak resident MiB of a command, and what it printed."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as said:
        start = time.monotonic()
        process = subprocess.Popen(list(map(str, command)), stdout=out, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        out.seek(0)
        said.seek(0)
        if status != 0:
            sys.exit(f"{command[0]} failed:\n{said.read()}")
        return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss / 1024, out.read()


def resident(pid):
    """Resident MiB now, 0 where the process has ended."""
    try:
        return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
    except (OSError, IndexError):
        return 0


def long_film(analyze, film, hours, folder):
    """The peak memory of a film joined of many copies, and how much it grows from its first half to its second."""
    path = folder / "long.mkv"
    seconds = hours * 3600
    if not path.is_file():
        ffmpeg("-stream_loop", int(seconds / (CLIP_SECONDS * 2)) + 1, "-i", film, "-t", seconds, "-c", "copy", path)
    samples, shots = [], []
    process = subprocess.Popen(list(map(str, [*analyze, "--grow", path])), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def hear():
        for line in process.stdout:
            shots.append((time.monotonic(), json.loads(line)))

    start = time.monotonic()
    ear = threading.Thread(target=hear)
    ear.start()
    while process.poll() is None:
        samples.append(resident(process.pid))
        time.sleep(1)
    ear.join()
    half = len(samples) // 2
    first, second = max(samples[:half], default=0), max(samples[half:], default=0)
    print(f"film of {seconds} s: first shot after {shots[0][0] - start:.1f} s, {len(shots[-1][1]['shots'])} shots after "
          f"{shots[-1][0] - start:.0f} s; peak {max(samples):.0f} MiB, {second - first:+.0f} MiB from the first half to the second")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--media", type=Path, default=TREE.parent / "shared" / "media")
    parser.add_argument("--films", type=Path)
    parser.add_argument("--pairs", type=int, default=3)
    parser.add_argument("--hours", type=float, default=2)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--face-model", type=Path, default=TREE / "analyzer/models/face_detection_yunet.onnx")
    line = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="vitrine-cost-") as name:
        folder = line.films or Path(name)
        folder.mkdir(parents=True, exist_ok=True)
        film, jpeg = folder / "film.mp4", folder / "photo.jpg"
        if not film.is_file():
            make_film(film, line.media)
        if not jpeg.is_file():
            make_jpeg(jpeg, line.media)
        frames, rate = frames_of(film)
        print(f"{frames} frames of 1080p H.264 at {rate / 1e6:.1f} Mb/s, {line.threads} threads")
        detectors = {"Viola-Jones": ["--analyzer.face_model", ""]}
        if line.face_model.is_file():
            detectors["YuNet"] = ["--analyzer.face_model", line.face_model]
        for faces, options in detectors.items():
            analyze = [line.build / "analyzer" / "vitrine-analyzer", *options, "analyze"]
            pairs = [(cost([*analyze, film]), cost(["ffmpeg", "-nostdin", "-v", "error", "-threads", line.threads, "-i", film,
                                                    "-f", "null", "-"])) for _ in range(line.pairs)]
            ratios = [ours[0] / theirs[0] for ours, theirs in pairs]
            seconds = statistics.median(ours[0] for ours, _ in pairs)
            print(f"{faces}: {statistics.median(ratios):.2f} times decoding ({', '.join(f'{r:.2f}' for r in ratios)}); "
                  f"{seconds:.2f} against {statistics.median(theirs[0] for _, theirs in pairs):.2f} processor seconds; "
                  f"{frames / seconds:.0f} frames a processor second, {2 * frames / seconds:.0f} a second on two idle cores, "
                  f"{frames / min(ours[1] for ours, _ in pairs):.0f} measured; {max(ours[2] for ours, _ in pairs):.0f} MiB")
            photos = [cost([*analyze, jpeg]) for _ in range(2 * line.pairs + 1)]
            print(f"{faces}: 12-megapixel JPEG: {1000 * statistics.median(p[0] for p in photos):.0f} ms of processor "
                  f"(best {1000 * min(p[0] for p in photos):.0f}), {max(p[2] for p in photos):.0f} MiB")
        if line.hours > 0:
            long_film(analyze, film, line.hours, folder)


if __name__ == "__main__":
    main()

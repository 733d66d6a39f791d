#!/usr/bin/python3
"""Makes edited films whose transitions are known exactly, to try shot detection on what it was not tuned to.

    make_edited_films.py MEDIA OUT [--photos FOLDER]... [--seeds 4 5 6] [--films 8] [--shots 12] [--hard]

Takes are real clips of one take (MEDIA/single), single shots of MEDIA/edited, and moves of a camera over photos
(MEDIA/photos and every FOLDER). They are disturbed (shake, noise, exposure, camera flashes, things passing close by, bars
sliding in) and joined by cuts, jump cuts, dissolves, fades over black and white, wipes and black stretches, at 12 to 60
frames a second or at a variable rate. Seeds 4 to 9 use every second source, other seeds the others: what is tuned on the
first is tried on material it never saw. Writes OUT/seedN/*.mp4 and OUT/seedN/gt/*.json (as MEDIA/composites/gt; a film of
variable rate lists its frames' "times" in s). Needs ffmpeg and python3-opencv.

With --hard the takes pan fast, are blurred or have a title, films have bars above and below, and they are joined as
detectors miss it: by circles, wipes of 8 frames, dissolves of 2, cuts under one title, and cuts shortly before a
logo. They are written to OUT/hardN. docs/algorithms.md says which seeds the detector was tuned on.
"""
import argparse
import json
import random
import subprocess
from pathlib import Path

import cv2
import numpy as np

RATES = [12, 15, 24000 / 1001, 24, 25, 25, 30000 / 1001, 30, 30, 50, 60, "variable"]
SIZES = [(320, 180), (320, 180), (480, 270), (480, 204), (400, 300), (270, 480)]
LONGEST_CLIP = 240  # frames kept of a clip
DULL = 25  # standard deviation of a picture that shows next to nothing


def fill(picture, size):
    """The middle of a picture at the size, no bars."""
    scale = max(size[0] / picture.shape[1], size[1] / picture.shape[0])
    big = cv2.resize(picture, None, fx=scale * 1.001, fy=scale * 1.001, interpolation=cv2.INTER_AREA)
    x, y = (big.shape[1] - size[0]) // 2, (big.shape[0] - size[1]) // 2
    return big[y:y + size[1], x:x + size[0]]


class Clip:
    """A clip of one take, at most 480 px, LONGEST_CLIP frames."""

    def __init__(self, path, first=0, last=10**6):
        probe = subprocess.run(
            ["ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries", "stream=width,height,avg_frame_rate", "-of",
             "csv=p=0:s=,", path], capture_output=True, text=True, check=True).stdout.split("\n")[0].split(",")
        width, height, rate = int(probe[0]), int(probe[1]), [int(x) for x in probe[2].split("/")]
        self.rate = rate[0] / rate[1]
        scale = min(1, 480 / max(width, height))
        width, height = round(width * scale / 2) * 2, round(height * scale / 2) * 2
        last = min(last, first + LONGEST_CLIP - 1)
        raw = subprocess.run(
            ["ffmpeg", "-nostdin", "-v", "error", "-i", path, "-map", "0:v:0", "-vf",
             f"select=between(n\\,{first}\\,{last}),scale={width}:{height}", "-vsync", "0", "-f", "rawvideo", "-pix_fmt",
             "bgr24", "-"], capture_output=True, check=True).stdout
        self.frames = np.frombuffer(raw, np.uint8).reshape(-1, height, width, 3)
        self.is_still = "cars" in str(path)


def sources(media, folders, held_out):
    """The clips and photos of one half of the material."""
    clips = [(p, 0, 10**6) for p in sorted((media / "single").iterdir()) if p.is_file()]
    for truth in sorted((media / "edited/gt").iterdir()):
        known = json.loads(truth.read_text())
        busy = [(t.get("start", t.get("frame")), t.get("end", t.get("frame"))) for t in known["transitions"]]
        busy += [(r[0], r[1]) for r in known.get("ignore", [])]
        for first, last, *_ in known["shots"]:
            first = max([first] + [end + 2 for start, end in busy if start <= first <= end])
            last = min([last] + [start - 2 for start, end in busy if start <= last <= end or first < start < last])
            if last - first >= 24:
                clips.append((media / known["file"], first, last))
    photos = [p for folder in [media / "photos", *folders] for p in sorted(folder.rglob("*.*"))
              if p.suffix in (".jpg", ".png", ".webp")]
    half = slice(1, None, 2) if held_out else slice(0, None, 2)
    pictures = [cv2.imread(str(p)) for p in photos[half]]
    return ([Clip(str(p), first, last) for p, first, last in clips[half]],
            [fill(p, (1440, 1440 * p.shape[0] // p.shape[1])) for p in pictures if p is not None and p.std() > DULL])


def eased(t):
    return t * t * (3 - 2 * t)


class Take:
    """An endless take: frame(t) is the picture t seconds after its start."""

    def __init__(self, rng, clips, photos, size, rate, like=None, unlike=None):
        self.rng, self.size, self.seed = rng, size, rng.randrange(2**31)
        self.clips, self.photos = clips, photos
        if like:
            self.clip, self.photo = like.clip, like.photo
        else:
            shown = (unlike.clip, unlike.photo) if unlike else (None, None)
            self.clip = rng.choice([c for c in clips if c is not shown[0]]) if rng.random() < .6 else None
            self.photo = None if self.clip else rng.choice([p for p in photos if p is not shown[1]])
        self.zoom = rng.uniform(1, 1.3)
        self.at = (rng.random(), rng.random())
        self.start = 0
        if self.clip:
            self.start = rng.uniform(0, len(self.clip.frames) * .5 / self.clip.rate)
            if like:
                self.start = (like.start + len(self.clip.frames) * .45 / self.clip.rate)
                self.zoom = like.zoom * rng.uniform(1.5, 1.9)
        self.is_mirrored = like.is_mirrored if like else rng.random() < .5
        self.move_over_photo(rng, like)
        self.disturb(rng, rate)
        self.blur, self.title, self.whip = 0, None, None

    def move_over_photo(self, rng, like):
        span = lambda: rng.uniform(.35, 1)
        point = lambda: (rng.random(), rng.random())
        self.duration = rng.choice([1.5, 3, 4, 6])
        self.windows = [(span(), point()), (span(), point())]
        kind = rng.choice(["still", "slow", "slow", "pan", "zoom"])
        if kind in ("still", "slow"):
            (a, p), near = self.windows[0], .0 if kind == "still" else .1
            self.windows[1] = (min(1, a * (1 + near)), (p[0], abs(p[1] - near)))
        if kind == "pan":
            self.windows = [(.45, (0, p)) if x else (.45, (1, p)) for x, p in zip((0, 1), [rng.random()] * 2)]
        if like and like.photo is not None:
            self.windows = [(like.windows[1][0] * .55, (1 - like.windows[1][1][0], .5))] * 2

    def disturb(self, rng, rate):
        maybe = lambda share: rng.random() < share
        self.shake = rng.choice([0, 0, 0, 1, 3]) * self.size[0] / 320
        self.noise = rng.choice([0, 0, 2, 5, 10])
        self.gain = rng.choice([1, 1, 1, .35, .6, 1.3])
        self.exposure = (rng.uniform(.3, 3), rng.uniform(.15, 1), rng.uniform(.55, 1.7)) if maybe(.2) else None
        self.flashes = [(t, rng.choice([1, 1, 2, 3]) / max(rate, 24), rng.uniform(40, 200))
                        for t in sorted(rng.uniform(.2, 5) for _ in range(rng.choice([1, 2, 5])))] if maybe(.2) else []
        self.passer = (rng.uniform(.3, 2.5), rng.uniform(.15, .8), rng.uniform(.15, .7), rng.choice([-1, 1]),
                       fill(rng.choice(self.photos), (self.size[0], self.size[1]))) if maybe(.2) else None
        self.bars = (rng.uniform(.06, .13), rng.uniform(.5, 2), maybe(.3)) if maybe(.15) else None

    def picture(self, t):
        width, height = self.size
        if self.clip:
            frames = self.clip.frames
            i = int((self.start + t) * self.clip.rate) % (2 * len(frames) - 2)
            frame = frames[min(i, 2 * len(frames) - 2 - i)]  # there and back again: no cut where the clip ends
            centre, span = self.at, 1 / self.zoom
        else:
            frame = self.photo
            share = eased(min(1, t / self.duration))
            (a, p), (b, q) = self.windows
            span = a + (b - a) * share
            centre = [p[i] + (q[i] - p[i]) * share for i in (0, 1)]
        if self.whip:
            begin, length, p, q = self.whip
            share = eased(min(1, max(0, (t - begin) / length)))
            centre, span = [p[i] + (q[i] - p[i]) * share for i in (0, 1)], .4
        scale = min(frame.shape[1] / width, frame.shape[0] / height) * span
        x = (frame.shape[1] - width * scale) * centre[0]
        y = (frame.shape[0] - height * scale) * centre[1]
        if self.shake:
            x += scale * self.shake * (np.sin(9 * t + self.seed) + np.sin(23.7 * t))
            y += scale * self.shake * (np.cos(11 * t + self.seed) + np.sin(19.3 * t))
        whole = np.float32([[1 / scale, 0, -x / scale], [0, 1 / scale, -y / scale]])
        out = cv2.warpAffine(frame, whole, self.size, flags=cv2.INTER_AREA, borderMode=cv2.BORDER_REFLECT)
        return out[:, ::-1] if self.is_mirrored else out

    def exposed(self, t):
        """The picture as a shutter sees it that is open for half a frame: a fast pan is blurred."""
        if not self.whip or not self.whip[0] <= t <= self.whip[0] + self.whip[1]:
            return self.picture(t).astype(np.float32)
        return np.mean([self.picture(t + i / 5 * .02) for i in range(5)], axis=0, dtype=np.float32)

    def frame(self, t):
        out = self.exposed(t) * self.gain
        if self.blur:
            out = cv2.GaussianBlur(out, None, self.blur)
        width, height = self.size
        if self.passer:
            begin, length, size, way, thing = self.passer
            share = (t - begin) / length
            if 0 < share < 1:
                part = int(width * size)
                x = int((width + part) * (share if way > 0 else 1 - share)) - part
                left, right = max(0, x), min(width, x + part)
                top = int(height * .15)
                if right > left:
                    out[top:, left:right] = thing[top:, left - x:right - x]
        if self.exposure:
            begin, length, gain = self.exposure
            out *= 1 + (gain - 1) * eased(min(1, max(0, (t - begin) / length)))
        if self.noise:
            seed = np.random.default_rng(self.seed + int(t * 1000))
            out += seed.standard_normal((height // 2 + 1, width // 2 + 1, 1), np.float32).repeat(2, 0).repeat(
                2, 1)[:height, :width] * self.noise
        for begin, length, light in self.flashes:
            if begin <= t < begin + length:
                out += light
        if self.title is not None:
            out = out * (1 - self.title) + 245 * self.title
        if self.bars:
            share, begin, slides = self.bars
            bar = int(height * share * (1 if not slides else min(1, max(0, (t - begin) / .5))))
            out[:bar] = 16
            out[height - bar:] = 16
        return np.clip(out, 0, 255)


def wiped(a, b, share, way, softness):
    """b over a, its edge moving: right, left, down, up or along a diagonal."""
    height, width = a.shape[:2]
    x, y = np.meshgrid(np.linspace(0, 1, width), np.linspace(0, 1, height))
    place = {"right": x, "left": 1 - x, "down": y, "up": 1 - y, "diagonal": (x + y) / 2}[way]
    edge = share * (1 + softness)
    alpha = np.clip((edge - place) / max(softness, 1e-3), 0, 1)[..., None]
    return a * (1 - alpha) + b * alpha


def circle(a, b, share, opens, softness):
    """b over a within a growing circle, or outside of a shrinking one."""
    height, width = a.shape[:2]
    x, y = np.meshgrid(np.arange(width) - width / 2, np.arange(height) - height / 2)
    place = np.hypot(x, y) / np.hypot(width / 2, height / 2)
    place = place if opens else 1 - place
    alpha = np.clip((share * (1 + softness) - place) / max(softness, 1e-2), 0, 1)[..., None]
    return a * (1 - alpha) + b * alpha


def words(rng, size, scale):
    """A title as a mask of the film's size, in [0, 1]."""
    width, height = size
    mask = np.zeros((height, width), np.uint8)
    text = rng.choice(["THE LONG WAY HOME", "Autumn sale", "Welcome", "Part two: the river", "a film by nobody"])
    font = rng.choice([cv2.FONT_HERSHEY_DUPLEX, cv2.FONT_HERSHEY_TRIPLEX, cv2.FONT_HERSHEY_COMPLEX])
    (wide, high), _ = cv2.getTextSize(text, font, 1, 2)
    factor = scale * width / wide
    at = (int((width - factor * wide) / 2), int(height * rng.uniform(.35, .8)))
    cv2.putText(mask, text, at, font, factor, 255, max(1, round(2 * factor)), cv2.LINE_AA)
    return mask[..., None].astype(np.float32) / 255


class Logo:
    """A title on one colour."""

    def __init__(self, rng, size):
        ground = rng.choice([(0, 0, 0), (255, 255, 255), (90, 40, 20), (30, 30, 160)])
        self.clip = self.photo = None
        self.picture = np.full((size[1], size[0], 3), ground, np.float32)
        mask = words(rng, size, rng.uniform(.3, .7))
        self.picture = self.picture * (1 - mask) + mask * (255 - self.picture)

    def frame(self, t):
        return self.picture


class Film:
    """Frames and truth of one edited film; the writer gets frames one after another."""

    def __init__(self, rng, clips, photos, write, rate, size):
        self.rng, self.clips, self.photos = rng, clips, photos
        self.write, self.rate, self.size = write, rate, size
        self.count, self.truth, self.shots = 0, [], []
        self.plain = np.zeros((size[1], size[0], 3), np.float32)
        self.bar = 0  # px above and below

    def take(self, like=None, unlike=None):
        return Take(self.rng, self.clips, self.photos, self.size, self.rate, like, unlike)

    def put(self, picture):
        if self.bar:
            picture = picture.copy()
            picture[:self.bar] = 0
            picture[self.size[1] - self.bar:] = 0
        self.write(picture)
        self.count += 1

    def run(self, take, since, frames):
        """Shows so many frames of a take, of which `since` are gone."""
        for i in range(frames):
            self.put(take.frame((since + i) / self.rate))
        return since + frames

    def mix(self, a, gone, b, frames, blend, kind, **more):
        start = self.count
        for i in range(frames):
            share = (i + 1) / (frames + 1)
            self.put(blend(a.frame((gone + i) / self.rate), b.frame(i / self.rate), share))
        self.truth.append({"type": kind, "start": start, "end": self.count - 1, **more})
        return frames

    def join(self, a, gone, kind):
        """Goes over to a new take; gives it and how many of its frames are gone."""
        rng = self.rng
        gradual = max(4, round(self.rate * rng.choice([.15, .25, .4, .6, .8, 1, 1.5])))
        if kind == "cut" or (kind == "jump" and a.clip and a.clip.is_still):
            b, gone = self.take(unlike=a), 0
            self.truth.append({"type": "cut", "frame": self.count})
        elif kind == "jump":
            b, gone = self.take(a), 0
            self.truth.append({"type": "cut", "frame": self.count, "note": "same scene"})
        elif kind == "dissolve":
            b = self.take(unlike=a)
            gone = self.mix(a, gone, b, min(40, gradual), lambda p, q, s: p * (1 - s) + q * s, "dissolve")
        elif kind == "wipe":
            b, way, soft = self.take(unlike=a), rng.choice(["right", "left", "down", "up", "diagonal"]), rng.choice([0, .05, .2])
            gone = self.mix(a, gone, b, gradual, lambda p, q, s: wiped(p, q, s, way, soft), "wipe", note=way)
        elif kind == "black":
            frames = round(self.rate * rng.uniform(.3, 1.5))
            self.truth.append({"type": "cut", "frame": self.count, "note": "to black"})
            for _ in range(frames):
                self.put(self.plain)
            b, gone = self.take(), 0
            self.truth.append({"type": "cut", "frame": self.count, "note": "from black"})
        else:
            b, gone = self.fade(a, gone, kind, gradual)
        return b, gone

    def fade(self, a, gone, kind, frames):
        rng, plain = self.rng, self.plain + (255 if kind == "fadewhite" else 0)
        hold = rng.choice([0, 0, 1, 3, round(.5 * self.rate)])
        start = self.count
        for i in range(frames):
            self.put(a.frame((gone + i) / self.rate) * (1 - (i + 1) / (frames + 1)) + plain * (i + 1) / (frames + 1))
        for _ in range(hold):
            self.put(plain)
        b = self.take(unlike=a)
        for i in range(frames):
            self.put(b.frame(i / self.rate) * (i + 1) / (frames + 1) + plain * (1 - (i + 1) / (frames + 1)))
        self.truth.append({"type": kind, "start": start, "end": self.count - 1})
        return b, frames

    def edit(self, shots):
        rng = self.rng
        kinds = ["cut"] * 10 + ["jump"] * 2 + ["dissolve"] * 5 + ["fadeblack"] * 3 + ["fadewhite"] + ["wipe"] * 3 + ["black"]
        take, gone, short = self.take(), 0, 0
        for i in range(shots):
            first = self.count
            if short == 0 and rng.random() < .06:
                short = rng.choice([1, 2, 4])
            seconds = rng.uniform(.15, .38) if short else rng.choice([.8, 1.2, 2, 2, 3, 4])
            gone = self.run(take, gone, max(3, round(seconds * self.rate)))
            self.shots.append([first, self.count - 1])
            if i + 1 < shots:
                take, gone = self.join(take, gone, "cut" if short else rng.choice(kinds))
            short = max(0, short - 1)


class HardFilm(Film):
    """Joins that detectors miss, and takes that they cut."""

    def __init__(self, *given):
        super().__init__(*given)
        if self.rng.random() < .35:
            self.bar = int(self.size[1] * self.rng.uniform(.07, .15))

    def take(self, like=None, unlike=None):
        take, rng = super().take(like, unlike), self.rng
        take.bars = take.passer = None
        if take.photo is not None and rng.random() < .3:
            points = [(rng.choice([0, .1]), rng.random()), (rng.choice([.9, 1]), rng.random())]
            take.whip = (rng.uniform(.4, 1.2), rng.uniform(.3, 1.2), *points[::rng.choice([1, -1])])
        return take

    def join(self, a, gone, kind):
        rng = self.rng
        cut = lambda note: self.truth.append({"type": "cut", "frame": self.count, "note": note})
        frames = 2 if kind == "short" else 8 if kind == "wipe8" else max(8, round(self.rate * rng.choice([.4, .6, 1, 1.5])))
        b = self.take(unlike=a)
        if kind == "circle":
            opens, soft = rng.random() < .6, rng.choice([0, .05, .3])
            return b, self.mix(a, gone, b, frames, lambda p, q, s: circle(p, q, s, opens, soft), "wipe", note="circle")
        if kind == "wipe8":
            way = rng.choice(["right", "left", "down", "up", "diagonal"])
            return b, self.mix(a, gone, b, frames, lambda p, q, s: wiped(p, q, s, way, 0), "wipe", note=way)
        if kind == "short":
            return b, self.mix(a, gone, b, frames, lambda p, q, s: p * (1 - s) + q * s, "dissolve", note="2 frames")
        if kind == "title":
            title = words(rng, self.size, rng.uniform(.5, .9))
            a.title = b.title = title
            gone = self.run(a, gone, round(rng.uniform(.8, 2) * self.rate))
        if kind == "logo":
            cut("before a logo")
            self.run(b, 0, round(rng.uniform(.5, .95) * self.rate))
            b = Logo(rng, self.size)
        if kind == "blurred":
            b.blur = rng.uniform(.015, .03) * self.size[0]
            cut("to a blurred picture")
            self.run(b, 0, round(rng.uniform(.6, 2) * self.rate))
            b = self.take(unlike=b)
        cut(kind)
        return b, 0

    def edit(self, shots):
        kinds = ["cut"] * 3 + ["circle", "wipe8", "short"] * 2 + ["title", "logo", "blurred"]
        self.rng.shuffle(kinds)
        take, gone = self.take(), 0
        for i in range(shots):
            first = self.count
            gone = self.run(take, gone, round(self.rng.choice([1.2, 2, 3, 4]) * self.rate))
            self.shots.append([first, self.count - 1])
            if i + 1 < shots:
                take, gone = self.join(take, gone, kinds[i % len(kinds)])


def frame_times(rng, frames, rate):
    """(expression for ffmpeg, seconds of every frame): a rate that swings by half around `rate`."""
    swing, period = .5, rng.choice([5, 13, 40])
    wave = swing * period / rate
    times = [i / rate + wave * (1 - np.cos(i / period)) for i in range(frames)]
    return f"(N/{rate}+{wave}*(1-cos(N/{period})))/TB", times


def make(rng, clips, photos, path, shots, kind=Film):
    rate = rng.choice(RATES)
    variable, rate = rate == "variable", 30 if rate == "variable" else rate
    size = rng.choice(SIZES)
    expression, times = frame_times(rng, 20000, rate)
    timing = ["-vf", f"settb=1/90000,setpts={expression}", "-vsync", "passthrough", "-enc_time_base", "1/90000"]
    encoder = subprocess.Popen(
        ["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "bgr24", "-s", f"{size[0]}x{size[1]}", "-r",
         f"{rate:.6f}", "-i", "-", *(timing if variable else []), "-c:v", "libx264", "-preset", "veryfast", "-crf",
         str(rng.choice([18, 23, 28, 33])), "-pix_fmt", "yuv420p", "-threads", "1", path], stdin=subprocess.PIPE)
    write = lambda picture: encoder.stdin.write(np.clip(picture, 0, 255).astype(np.uint8).tobytes())
    film = kind(rng, clips, photos, write, rate, size)
    if shots:
        film.edit(shots)
    else:
        film.run(film.take(), 0, round(6 * rate))
    encoder.stdin.close()
    if encoder.wait():
        raise SystemExit(f"ffmpeg failed on '{path}'")
    truth = {"file": "/".join(path.parts[-2:]), "frames": film.count, "fps": f"{rate:.6f}", "source": "made, exact",
             "transitions": film.truth, "shots": film.shots}
    if variable:
        truth["times"] = [round(float(t), 6) for t in times[:film.count]]
    (path.parent / "gt" / f"{path.stem}.json").write_text(json.dumps(truth, indent=1))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("media", type=Path)
    options.add_argument("out", type=Path)
    options.add_argument("--photos", type=Path, action="append", default=[])
    options.add_argument("--seeds", type=int, nargs="+", default=[4, 5, 6])
    options.add_argument("--films", type=int, default=8, help="edited films a seed, and half as many of one take")
    options.add_argument("--shots", type=int, default=12, help="shots of an edited film")
    options.add_argument("--hard", action="store_true", help="takes and joins that detectors get wrong")
    given = options.parse_args()
    cv2.setNumThreads(1)
    halves = {}
    for seed in given.seeds:
        held_out = 4 <= seed <= 9
        if held_out not in halves:
            halves[held_out] = sources(given.media, given.photos, held_out)
        folder = given.out / f"{'hard' if given.hard else 'seed'}{seed}"
        (folder / "gt").mkdir(parents=True, exist_ok=True)
        for i in range(given.films * 3 // 2):
            single = i >= given.films
            name = f"take{i - given.films}" if single else f"film{i}"
            rng = random.Random(f"{'hard/' if given.hard else ''}{seed}/{i}")
            make(rng, *halves[held_out], folder / f"{name}.mp4", 0 if single else given.shots, HardFilm if given.hard else Film)


if __name__ == "__main__":
    main()

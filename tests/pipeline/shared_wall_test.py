#!/usr/bin/env python3
"""Two boxes of one wall as they run: players, links, Debian's broker and rsync, a network between them. See shared_boxes.py.

    shared_wall_test.py BUILD_DIRECTORY [unittest arguments]

The boxes share the clock of this machine, which counts as kept right. A machine that lacks one of the daemons, or may
not make namespaces, prints NOT RUN.
"""
import json
import os
import signal
import statistics
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

from drawn_media import pattern, png
from shared_boxes import BUILD, LEADER, PATIENCE, Box, Broker, join_namespaces, run_tests, start_share, until
from private_bus import start_bus  # in the folder that shared_boxes adds

ANALYZER, PLAYER, CTL = (BUILD / name for name in ("analyzer/vitrine-analyzer", "player/vitrine-player", "player/control/vitrinectl"))
RATE = 25  # pictures a second
BRIGHT = 150  # level that the walls of these tests always have somewhere, and the idle picture never
ACROSS, DOWN = 32, 18  # px of the pictures that are compared
SAME = 2  # levels: the mean difference of two coded pictures of one moment is less
NEAR = 5  # the same while a hand moves a shot
HAND = 12  # pictures by which others see it late at most
DRAG_AT = 20  # seconds after the follower's start
END = 38  # a film begins with the first picture, on a busy machine some seconds after the start


def ffmpeg(*arguments):
    return subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True, capture_output=True).stdout


def draw_media(folder):
    folder.mkdir()
    for number in range(4):  # each brighter than the one before
        fields = pattern(number)
        png(folder / f"photo{number}.png", 240, 180, lambda x, y, n=number, of=fields: [value // 4 + 50 * n + 10 for value in of(x, y)])
    for seconds in (5, 14):  # the whole picture tells the time: a bright bar goes to the right
        ffmpeg("-f", "lavfi", "-i", f"color=0x203050:size=320x180:rate={RATE}:duration={seconds}", "-f", "lavfi", "-i",
               f"color=0xf0f0e0:size=40x180:rate={RATE}:duration={seconds}", "-filter_complex", f"overlay=x=280*t/{seconds}",
               "-pix_fmt", "yuv420p", folder / f"film{seconds}.mp4")


def small_pictures(film):
    """Each picture of a film as grey values, ACROSS x DOWN."""
    raw = ffmpeg("-i", film, "-vf", f"scale={ACROSS}:{DOWN}:flags=area,format=gray", "-f", "rawvideo", "-")
    size = ACROSS * DOWN
    return [raw[i:i + size] for i in range(0, len(raw), size)]


def difference(a, b):
    return sum(abs(x - y) for x, y in zip(a, b)) / len(a)


def shift(left, right, begin, count, most=None):
    """By how many pictures the films of two boxes are apart, as they show the same, and how far these are from equal. @param most  of these pictures"""
    found = {}
    for apart in range(-begin, len(left) - begin - count) if most is None else range(-most, most + 1):
        found[apart] = statistics.fmean(difference(left[begin + apart + k], right[begin + k]) for k in range(0, count, 5))
    best = min(found, key=found.get)
    return best, found[best]


def trail(left, right, begin, count, apart):
    """How far from equal the films of two boxes are while a hand moves a shot: one box may show it up to HAND pictures after the other.

    @param apart  by how many pictures they are apart without a hand"""
    shifts = range(apart - HAND, apart + HAND + 1)
    return statistics.fmean(min(difference(left[begin + k + by], right[begin + k]) for by in shifts) for k in range(0, count, 5))


class Wall(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-shared-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        far, inside = join_namespaces()
        cls.addClassCleanup(far.wait)
        cls.addClassCleanup(far.kill)
        cls.left, cls.right = Box(cls.folder, "left"), Box(cls.folder, "right", inside)
        assert cls.left.wall("lead", "lobby").returncode == 0
        assert cls.right.wall("join", "lobby", str(cls.left.key), LEADER).returncode == 0
        cls.broker = Broker(cls.left)
        cls.media = cls.folder / "media"
        draw_media(cls.media)
        subprocess.run([ANALYZER, "watch", "--once", "--config", cls.left.settings, "--media.root", cls.media,
                        "--analyzer.saliency", "plain", "--status.folder", ""], check=True, timeout=5 * PATIENCE, capture_output=True)

    def setUp(self):
        self.broker.start()
        self.addCleanup(self.broker.stop)
        self.ended = threading.Event()
        self.follow_fetches()
        for box in (self.left, self.right):
            box.start()
            self.addCleanup(box.stop, signal.SIGKILL)

    def end(self, process):
        process.kill()
        process.wait()

    def follow_fetches(self):
        """Fetches as the units of a follower do: when the link has heard of files, and now and then."""
        share = start_share(self.left)
        self.addCleanup(self.end, share)

        def fetch():
            while not self.ended.wait(0.5):
                self.right.fetch()

        thread = threading.Thread(target=fetch)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(self.ended.set)

    def environment(self, box):
        return {**os.environ, "DBUS_SYSTEM_BUS_ADDRESS": f"unix:path={box.root / 'bus'}", "LD_LIBRARY_PATH": ""}

    def start_player(self, box, name, *options, films=True):
        """Starts a player on a bus of its own. It films what it shows as NAME."""
        environment = self.environment(box)
        if not (box.root / "bus").exists():
            bus = start_bus(box.root / "bus", env=environment, stderr=subprocess.DEVNULL)
            self.addCleanup((box.root / "bus").unlink)
            self.addCleanup(self.end, bus)
        with open(box.root / f"{name}.log", "w") as log:
            player = subprocess.Popen([*box.inside, PLAYER, "--config", box.settings, "--wall.key", box.key, "--wall.socket", box.socket(),
                                       "--screen", "offscreen:320x180", "--output.frame_rate", str(RATE), "--pace", "realtime", "--status.folder", "",
                                       *(("--film", self.folder / f"{name}.mp4") if films else ()), *map(str, options)],
                                      env={**environment, "LD_PRELOAD": str(BUILD / "tests/pipeline/libkept_clock.so")}, stderr=log)
        self.addCleanup(self.end, player)
        return player

    def start_leader(self, name, *options, slots=6):
        return self.start_player(self.left, name, "--media.root", self.media, "--layout.slots", slots, "--show.dwell_seconds", 3600, *options)

    def ctl(self, box, *words):
        return subprocess.run([CTL, *words], env=self.environment(box), capture_output=True, text=True, timeout=PATIENCE)

    def boxes(self, box):
        """What a box says of all boxes, by their names."""
        said = self.ctl(box, "status", "--json")
        return {b["name"]: b["says"] for b in json.loads(said.stdout).get("wall", {}).get("boxes", [])} if said.returncode == 0 else {}

    def wait_until_in_step(self):
        for box in (self.left, self.right):
            until(f"{box.name} tells that all are in step", lambda: "in step" in self.boxes(box).get("right", "").replace("not in step", ""))

    def subscriber(self, topic):
        return ["mosquitto_sub", "-h", LEADER, "-p", "8883", "--psk", self.left.key.read_text().strip(), "--psk-identity", "lobby",
                "-t", f"vitrine/lobby/{topic}"]

    def listen(self):
        """Notes when which message passes the broker. @return  the times and topics so far"""
        heard = []
        spy = subprocess.Popen([*self.subscriber("#"), "-F", "%U %t"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(spy.stdout.close)
        self.addCleanup(self.end, spy)

        def note():
            for line in spy.stdout:
                moment, topic = line.split()
                heard.append((float(moment), topic.removeprefix("vitrine/lobby/")))

        threading.Thread(target=note, daemon=True).start()
        return heard

    def film_two_boxes(self, names, seconds, *options, touches=f"{DRAG_AT} drag 80 45 240 135 2", **kinds):
        """Films a leader and, so long, a follower whose visitor touches it. @return  the pictures of both, and the messages"""
        script = self.folder / "script"
        script.write_text(touches + "\n")
        leader = self.start_leader(names[0], "--duration", f"{seconds + 2}s", *options, **kinds)
        heard = self.listen()
        follower = self.start_player(self.right, names[1], "--media.root", self.folder / "none", "--rehearse", script, "--duration", f"{seconds}s")
        self.wait_until_in_step()
        for player in (follower, leader):
            self.assertEqual(player.wait(PATIENCE), 0)
        return (*(small_pictures(self.folder / f"{name}.mp4") for name in names), heard)

    def check_in_step(self, left, right, *after_drag):
        """@param after_drag  seconds from the drag's begin at which they are compared, too"""
        with self.subTest("the same picture at the same moment, before, while and after the wall is moved"):
            windows = {at: shift(left, right, at * RATE, RATE) for at in (12, 16, *(DRAG_AT + later for later in after_drag))}
            dragged = trail(left, right, (DRAG_AT + 1) * RATE, RATE, windows[12][0])
            print(f"pictures apart, and how far from equal: {windows}, and {dragged} under a hand")
            for at, (apart, off) in windows.items():
                self.assertLess(off, SAME, f"at {at} s")
                self.assertLessEqual(abs(apart - windows[12][0]), 1, f"at {at} s")
            self.assertLess(dragged, NEAR)

    def test_a_follower_shows_a_panning_wall_and_its_visitors_move_it(self):
        left, right, _ = self.film_two_boxes(("pan", "pans"), DRAG_AT + 12, "--layout.mode", "pan", "--show.pan_pixels_per_second", 20)
        self.check_in_step(left, right, 5)
        for k, picture in enumerate(right[12 * RATE:]):
            self.assertGreater(max(picture), BRIGHT, f"picture {12 * RATE + k} of {len(right)} is dark")

    def test_a_follower_shows_the_leaders_wall_and_its_visitors_move_it(self):
        left, right, heard = self.film_two_boxes(("left", "right"), END)
        self.check_in_step(left, right, 6, 10)
        with self.subTest("the drag moved both"):
            before, after = ([max(pixel) for pixel in zip(*right[at * RATE:(at + 7) * RATE:5])] for at in (12, DRAG_AT + 6))
            self.assertGreater(difference(before, after), SAME)
        touches = [moment for moment, topic in heard if topic == "touch/right"]
        news = [moment for moment, topic in heard if topic in ("act", "lifted")]
        self.assertTrue(touches)
        back = [min(moment for moment in news if moment >= touch) - touch for touch in touches if news and touch <= news[-1]]
        self.assertTrue(back, "nothing came back of a touch")
        print(f"{len(touches)} messages of touches; the leader answers after {1000 * statistics.median(back):.0f} ms in the median, "
              f"95 %: {1000 * sorted(back)[len(back) * 95 // 100]:.0f} ms, {RATE} pictures a second")

    def test_a_visitor_of_a_follower_opens_a_tapestry_on_all_boxes(self):
        at = DRAG_AT
        touches = "\n".join((f"{at} tap 160 90", f"{at + 0.25} tap 160 90", f"{at + 6} tap 60 125",
                             f"{at + 12} drag 200 150 90 150 1.5", f"{at + 18} key back"))
        left, right, _ = self.film_two_boxes(("strip", "strips"), at + 25, "--show.order", "name", touches=touches, slots=1)
        # A busy box needs a second or two to open what a touch lets play.
        with self.subTest("the same picture at the same moment"):
            windows = {later: shift(left, right, (at + later) * RATE, RATE, 2 * RATE) for later in (-4, 4, 9, 16, 22)}
            dragged = trail(left, right, (at + 12) * RATE, RATE, windows[-4][0])
            print(f"pictures apart, and how far from equal, by seconds after the first touch: {windows}, and {dragged} under a finger")
            for later, (_, off) in windows.items():
                self.assertLess(off, SAME, f"{later} s after the first touch")
            out = [later for later, (apart, _) in windows.items() if abs(apart - windows[-4][0]) > 1]
            self.assertNotIn(22, out, "the wall is back")
            self.assertLessEqual(len(out), 1, f"{out} s after the first touch")  # once a busy box may be late after a touch
            self.assertLess(dragged, NEAR)
        with self.subTest("a tapestry was seen, moved, and went"):
            moments = [right[round((at + later) * RATE)] for later in (-1, 4.5, 16.5, 22)]
            for one, other in zip(moments, moments[1:]):
                self.assertGreater(difference(one, other), 3 * SAME)

    def off_now(self):
        """Options of a player whose display is off at this hour."""
        far = (time.localtime().tm_hour + 12) % 24
        return "--output.on", f"{far:02}:00-{far:02}:59"

    def told(self, topic, what):
        """A fact of the last message of a kind, as the broker has kept it. None: there is none."""
        ask = [*self.subscriber(topic), "-C", "1", "-W", "2", "-F", "%p"]
        note = subprocess.run(ask, capture_output=True, text=True).stdout
        return json.loads(note).get(what) if note else None

    def test_a_follower_whose_display_is_off_tells_that_it_has_none_and_leaves_commands_and_settings_to_the_leader(self):
        self.start_leader("alone")
        self.start_player(self.right, "off", "--media.root", self.folder / "none", *self.off_now(), films=False)
        until("the follower tells of its displays", lambda: self.told("box/right", "outputs") is not None)
        self.assertEqual(self.told("box/right", "outputs"), [])
        for words in (("next",), ("pause",), ("pin", "photo0.png"), ("pin", "0"), ("remove", "photo0.png"), ("layout", "save", "a"), ("layout", "load", "a")):
            refused = self.ctl(self.right, *words)
            self.assertEqual((refused.returncode, "the box that leads decides" in refused.stderr), (1, True), f"{words}: {refused}")
        self.assertEqual(self.ctl(self.left, "canvas").returncode, 0)
        until("the leader tells of its guides", lambda: self.told("box/left", "has_guides"))
        settings = self.left.settings.read_text()
        self.addCleanup(self.left.settings.write_text, settings)
        until("the leader tells of its wall", lambda: self.told("act", "run"))
        run = self.told("act", "run")
        self.left.settings.write_text(settings + '\n[layout]\nlook = "tiles"\n')
        self.assertEqual(self.ctl(self.left, "reload").returncode, 0)
        until("the leader tells of the wall with its new settings", lambda: self.told("act", "run") != run)

    def test_a_leader_whose_display_is_off_leads(self):
        leader = self.start_player(self.left, "dark", "--media.root", self.media, "--layout.slots", 1, "--show.dwell_seconds", 2, "--show.order", "name",
                                   "--show.motion_milliseconds", 200, *self.off_now(), films=False)
        heard = self.listen()
        script = self.folder / "touch"
        script.write_text("20 tap 160 90\n")  # the wall rests from then on
        follower = self.start_player(self.right, "lit", "--media.root", self.folder / "none", "--rehearse", script, "--duration", "24s")
        until("the wall of the others is saved", lambda: self.ctl(self.left, "layout", "save", "a").returncode == 0)
        self.assertEqual(follower.wait(PATIENCE), 0, (self.right.root / "lit.log").read_text())
        leader.send_signal(signal.SIGTERM)
        ended, log = leader.wait(PATIENCE), (self.left.root / "dark.log").read_text()
        self.assertEqual(ended, 0, log)
        self.assertIn("panels off", log)
        self.assertIn("panels on", log, "a touch on the other box lights them")
        self.assertGreater(len([topic for _, topic in heard if topic == "act"]), 2, "one after the other")
        self.assertTrue(any(max(picture) > BRIGHT for picture in small_pictures(self.folder / "lit.mp4")))

    def test_a_follower_goes_on_without_broker_and_leader_and_is_in_step_once_they_are_back(self):
        leader = self.start_leader("first")
        follower = self.start_player(self.right, "other", "--media.root", self.folder / "none")
        self.wait_until_in_step()
        time.sleep(1)
        begin = time.monotonic()
        self.broker.stop()
        time.sleep(2)
        self.broker.start()
        self.end(leader)
        time.sleep(3)
        alone = time.monotonic() - begin
        leader = self.start_leader("second")
        self.wait_until_in_step()
        time.sleep(5)
        end = time.monotonic()
        for player in (leader, follower):
            player.send_signal(signal.SIGTERM)
            self.assertEqual(player.wait(PATIENCE), 0)
        left, right = (small_pictures(self.folder / f"{name}.mp4") for name in ("second", "other"))
        first = next(k for k, picture in enumerate(right) if max(picture) > BRIGHT)
        for k, picture in enumerate(right[first:]):
            self.assertGreater(max(picture), BRIGHT, f"picture {first + k} of {len(right)} is dark")
        since = len(right) - round((end - begin) * RATE)
        for k in range(since, since + round(alone * RATE), RATE):
            moved = max(difference(right[k], right[k + later]) for later in range(RATE // 5, RATE, RATE // 5))
            self.assertGreater(moved, 0.5, "films stand still")
        apart, off = shift(left, right, len(right) - 3 * RATE, RATE)
        self.assertLess(off, SAME, f"{apart} pictures apart")


if __name__ == "__main__":
    run_tests()

#!/usr/bin/env python3
"""Prints what followers cost the player that leads a wall, and how soon a box that joins shows it.

    bench/followers.py BUILD_DIRECTORY [FOLLOWERS] [SECONDS]

Two players play the same folder off screen at the same time: one alone, one that leads. FOLLOWERS boxes (16) answer the leader over
the socket where vitrine-link would be: each tells of itself once a second and is ready for whatever is prepared. The CPU of both is
compared over SECONDS (60). Then a real player joins as a follower, three times. Nothing here passes or fails.

Build the target release_tests before: it makes the clock that the players use.
"""
import json
import os
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
FOLLOWERS = int(sys.argv[2]) if len(sys.argv) > 2 else 16
KEPT = {**os.environ, "LD_PRELOAD": str(BUILD / "tests" / "pipeline" / "libkept_clock.so")}  # the players take their clock for one that chrony keeps right
SECONDS = int(sys.argv[3]) if len(sys.argv) > 3 else 60
WARM_UP = 20  # seconds
TICKS = os.sysconf("SC_CLK_TCK")


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def draw_media(folder):
    folder.mkdir()
    for number in range(12):
        ffmpeg("-f", "lavfi", "-i", f"color=0x{20 * number:02x}6080:size=640x480,drawbox=x={20 * number}:y=100:w=200:h=200:c=white:t=fill",
               "-frames:v", 1, folder / f"{number}.png")
    for number in range(6):
        ffmpeg("-f", "lavfi", "-i", f"testsrc2=size=640x360:rate=25:duration={6 + number}", "-pix_fmt", "yuv420p", folder / f"{number}.mp4")


def cpu_of(process):
    fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def line(topic, payload, retain=False):
    return json.dumps({"topic": topic, "retain": retain, "payload": payload}).encode() + b"\n"


def lines_of(connection):
    begun = b""
    while piece := connection.recv(1 << 20):
        *whole, begun = (begun + piece).split(b"\n")
        yield from map(json.loads, whole)


def name_of(act):
    return {"run": act["run"], "generation": act["generation"]}


class Link:
    """The place of vitrine-link beside one player."""

    def __init__(self, path):
        self.server = socket.socket(socket.AF_UNIX)
        self.server.bind(str(path))
        self.server.listen()
        self.waiting = threading.Lock()

    def meet(self):
        self.connection, _ = self.server.accept()
        self.send(line("link", {"connected": True, "says": "connected"}))

    def send(self, text):
        with self.waiting:
            self.connection.sendall(text)


class LeadersLink(Link):
    """All followers' answers to the leader."""

    def __init__(self, path):
        super().__init__(path)
        self.kept, self.sizes = {}, []  # the last payload of each topic; bytes of each act

    def serve(self):
        self.meet()
        threading.Thread(target=self.tell, daemon=True).start()
        for message in lines_of(self.connection):
            topic, payload = message["topic"], message["payload"]
            self.kept[topic] = payload
            if topic == "act":
                self.sizes.append(len(json.dumps(payload)))
            if topic == "prepare":
                for number in range(FOLLOWERS):
                    self.send(line(f"ready/box-{number}", name_of(payload)))

    def tell(self):
        while True:
            shown = name_of(self.kept["act"]) if "act" in self.kept else None
            for number in range(FOLLOWERS):
                note = {"version": 1, "leads": False, "has_right_clock": True, "difference_us": number, "lacking": [],
                        "outputs": [{"name": "HDMI-A-1", "width": 1920, "height": 1080, "turned": 0}]}
                self.send(line(f"box/box-{number}", note | ({"shown": shown} if shown else {})))
            time.sleep(1)


def seconds_to_join(home, options, act):
    """From the start of a follower, and from the act's arrival, until it says that it shows an act."""
    path = home / "follower.sock"
    path.unlink(missing_ok=True)
    link = Link(path)
    began = time.monotonic()
    player = subprocess.Popen([PLAYER, *options, "--wall.role", "follow", "--wall.box", "late", "--wall.socket", path],
                              stderr=subprocess.DEVNULL, env=KEPT)
    try:
        link.meet()
        met = time.monotonic()
        link.send(line("act", act))
        for message in lines_of(link.connection):
            if message["topic"] == "box/late" and message["payload"].get("shown"):
                return time.monotonic() - began, time.monotonic() - met
    finally:
        player.kill()
        player.wait()
        link.server.close()


def main():
    with tempfile.TemporaryDirectory(prefix="vitrine-followers-") as folder:
        home = Path(folder)
        draw_media(home / "media")
        folders = ["--media.root", home / "media", "--state.directory", home / "state"]
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *folders, "--analyzer.saliency", "plain"],
                       check=True, stderr=subprocess.DEVNULL)
        options = [*folders, "--pace", "realtime", "--screen", "offscreen:1280x720", "--layout.slots", "6", "--show.dwell_seconds", "4"]
        link = LeadersLink(home / "leader.sock")
        threading.Thread(target=link.serve, daemon=True).start()
        players = [subprocess.Popen([PLAYER, *options, *more], stderr=subprocess.DEVNULL, env=KEPT)
                   for more in ([], ["--wall.role", "lead", "--wall.box", "lead", "--wall.socket", home / "leader.sock"])]
        try:
            time.sleep(WARM_UP)
            before, acts = [cpu_of(player) for player in players], len(link.sizes)
            time.sleep(SECONDS)
            alone, leads = (cpu_of(player) - begin for player, begin in zip(players, before))
            sizes = link.sizes[acts:]
            print(f"alone {alone:.2f} s of CPU in {SECONDS} s, leads {FOLLOWERS} followers {leads:.2f} s: {leads / alone:.3f} times; "
                  f"{len(sizes)} acts of {sum(sizes) / max(1, len(sizes)) / 1024:.1f} KiB")
            for _ in range(3):
                whole, met = seconds_to_join(home, options, link.kept["act"])
                print(f"a follower shows the wall {whole:.2f} s after its start, {met:.2f} s after it heard of it")
        finally:
            for player in players:
                player.kill()
                player.wait()


if __name__ == "__main__":
    main()

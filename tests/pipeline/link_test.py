#!/usr/bin/env python3
"""Links and broker of two boxes of a wall, in network namespaces of their own. See shared_boxes.py.

    link_test.py BUILD_DIRECTORY [unittest arguments]

A machine that lacks one of the daemons, or may not make namespaces, prints NOT RUN.
"""
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from shared_boxes import DAEMONS, LEADER, LINK, PATIENCE, Box, Broker, join_namespaces, run_tests, start_share, until

SILENCE = 1.5  # seconds in which what must not come would have come
ACT = {"version": 1, "generation": 7, "at": 0.1, "name": "Zürich"}


class Player:
    """The end of a player at the socket of its link."""

    def __init__(self, path):
        self.lines, self.begun = [], b""
        self.socket = socket.socket(socket.AF_UNIX)
        until(f"{path} listens", lambda: self.socket.connect_ex(str(path)) == 0)
        self.socket.setblocking(False)

    def send(self, topic, payload, retain=False):
        self.socket.sendall(json.dumps({"topic": topic, "retain": retain, "payload": payload}).encode() + b"\n")

    def read(self):
        try:
            while piece := self.socket.recv(65536):
                self.begun += piece
        except (BlockingIOError, ConnectionResetError):
            pass
        *lines, self.begun = self.begun.split(b"\n")
        self.lines += map(json.loads, lines)
        return self.lines

    def all(self, topic):
        return [line["payload"] for line in self.read() if line["topic"] == topic]

    def hears(self, topic, payload=None):
        until(f"{topic} {payload}", lambda: payload in self.all(topic) if payload is not None else self.all(topic))

    def is_connected(self):
        states = self.all("link")
        return bool(states) and states[-1]["connected"]

    def close(self):
        self.socket.close()


class TwoBoxes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="vitrine-link-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = temporary.name
        far, inside = join_namespaces()
        cls.addClassCleanup(far.wait)
        cls.addClassCleanup(far.kill)
        cls.left, cls.right = Box(cls.folder, "left"), Box(cls.folder, "right", inside)
        cls.late, cls.stranger = Box(cls.folder, "late", inside), Box(cls.folder, "stranger", inside)
        assert cls.left.wall("lead", "lobby").returncode == 0
        other = Path(cls.folder) / "other.key"
        other.write_text("5" * 64 + "\n")
        for box, key in ((cls.right, cls.left.key), (cls.late, cls.left.key), (cls.stranger, other)):
            said = box.wall("join", "lobby", str(key), LEADER)
            assert said.returncode == 0, said.stderr
        cls.broker = Broker(cls.left)

    def setUp(self):
        self.broker.start()
        self.addCleanup(self.broker.stop)
        self.players = []
        for box in (self.left, self.right, self.late, self.stranger):
            self.addCleanup(box.stop, signal.SIGKILL)

    def start(self, box):
        box.start()
        player = Player(box.socket())
        self.addCleanup(player.close)
        return player

    def start_both(self):
        players = self.start(self.left), self.start(self.right)
        for player in players:
            until("a connection", player.is_connected)
        return players

    def share(self):
        """Lets the follower fetch, which it has done once then."""
        share = start_share(self.left)
        self.addCleanup(share.wait)
        self.addCleanup(share.kill)
        until("a share", lambda: self.right.fetch().returncode == 0)

    def publish(self, topic, payload, key=None, identity="lobby"):
        """A stranger, or a box that has gone wrong. @return  true: the broker took the message"""
        said = subprocess.run([*self.right.inside, "mosquitto_pub", "-h", LEADER, "-p", "8883", "--psk", key or self.left.key.read_text().strip(),
                               "--psk-identity", identity, "-q", "1", "-r", "-t", topic, "-s"], input=payload, capture_output=True, timeout=PATIENCE)
        return said.returncode == 0

    def test_messages_travel_both_ways_and_a_late_box_gets_what_is_kept(self):
        left, right = self.start_both()
        left.send("act", ACT, retain=True)
        right.hears("act", ACT)
        right.send("ready/right", {"generation": 7})
        left.hears("ready/right", {"generation": 7})
        right.send("box/right", {"outputs": 1}, retain=True)
        left.hears("box/right", {"outputs": 1})
        began = time.monotonic()
        late = self.start(self.late)
        late.hears("act", ACT)
        late.hears("box/right", {"outputs": 1})
        print(f"a box that came late had the act after {time.monotonic() - began:.2f} s")
        again = Player(self.right.socket())  # a player that was restarted
        self.addCleanup(again.close)
        again.hears("act", ACT)
        self.assertTrue(again.is_connected())
        self.assertEqual(left.all("act"), [], "the leader hears no act")

    def test_a_box_that_dies_is_marked_as_gone_and_one_whose_player_dies_too(self):
        left, right = self.start_both()
        late = self.start(self.late)
        until("a connection", late.is_connected)
        right.send("box/right", {"outputs": 1}, retain=True)
        late.send("box/late", {"outputs": 2}, retain=True)
        left.hears("box/right", {"outputs": 1})
        left.hears("box/late", {"outputs": 2})
        self.right.stop(signal.SIGKILL)
        late.close()
        left.hears("box/right", {"gone": True})
        left.hears("box/late", {"gone": True})

    def test_a_broker_that_was_restarted_has_all_again(self):
        left, right = self.start_both()
        left.send("act", ACT, retain=True)
        right.hears("act", ACT)
        right.send("box/right", {"outputs": 1}, retain=True)
        left.hears("box/right", {"outputs": 1})
        self.broker.stop()
        until("both know", lambda: not left.is_connected() and not right.is_connected())
        left.send("act", {**ACT, "generation": 8}, retain=True)  # while nobody hears it
        right.send("ready/right", {"generation": 8})
        right.send("touch/right", {"x": 1})
        self.broker.start()
        right.hears("act", {**ACT, "generation": 8})
        left.hears("ready/right", {"generation": 8})
        late = self.start(self.late)
        late.hears("act", {**ACT, "generation": 8})
        late.hears("box/right", {"outputs": 1})
        self.assertEqual(left.all("touch/right"), [], "a touch of then moves nothing now")

    def test_a_box_without_the_key_gets_nothing_and_gives_nothing(self):
        left, right = self.start_both()
        left.send("act", ACT, retain=True)
        right.hears("act", ACT)
        stranger = self.start(self.stranger)
        stranger.send("box/stranger", {"outputs": 1}, retain=True)
        until("a sentence", lambda: any("no connection" in state["says"] for state in stranger.all("link")))
        self.assertFalse(self.publish("vitrine/lobby/act", b'{"version":1,"generation":66}', key="6" * 64))
        self.assertFalse(self.publish("vitrine/lobby/act", b'{"version":1,"generation":66}', identity="other"))
        plain = subprocess.run([*self.right.inside, "mosquitto_sub", "-h", LEADER, "-p", "8883", "-t", "#", "-W", "1"], capture_output=True)
        self.assertEqual(plain.stdout, b"")
        time.sleep(SILENCE)
        self.assertEqual(stranger.all("act"), [])
        self.assertEqual(left.all("box/stranger"), [])
        self.assertEqual(right.all("act"), [ACT])

    def test_a_message_of_another_version_or_of_no_sense_is_a_sentence_and_goes_no_further(self):
        _, right = self.start_both()
        self.publish("vitrine/lobby/act", b'{"version":2}')
        # The next message waits for this: while the link is slow, a newer act takes the place of one that it has not read.
        until("a sentence", lambda: any("version 2" in state["says"] for state in right.all("link")))
        for payload in (b"nonsense", b"[1]", b"{}", b"\xff\xfe", b"[" * 100000, b'{"version":1,"a":1e999}', b"x" * 1050000):
            self.publish("vitrine/lobby/act", payload)
        self.publish("vitrine/lobby/act", json.dumps(ACT).encode())
        right.hears("act", ACT)
        self.assertEqual(right.all("act"), [ACT])
        self.assertLessEqual(self.right.said().count("a message is refused"), 3, "the log is not flooded")

    def test_a_follower_that_sends_what_only_the_leader_may_is_let_go(self):
        left, right = self.start_both()
        right.send("act", ACT, retain=True)
        until("the end", lambda: "which is for the leader" in self.right.said())
        self.assertEqual(left.all("act"), [])

    def test_two_boxes_of_one_name_are_a_sentence(self):
        _, right = self.start_both()
        self.late.start("--wall.box", "right")
        late = Player(self.late.socket())
        self.addCleanup(late.close)
        until("a sentence", lambda: any("may be called 'right' too" in state["says"] for state in right.all("link") + late.all("link")))

    def test_a_prepare_wakes_the_fetching_of_files(self):
        left, right = self.start_both()
        wanted = self.right.root / "wanted"
        self.assertFalse(wanted.exists())
        left.send("prepare", {"version": 1, "files": []}, retain=True)
        right.hears("prepare")
        until("a file", wanted.exists)
        self.assertFalse((self.left.root / "wanted").exists())

    def test_a_stop_is_quick(self):
        self.start_both()
        began = time.monotonic()
        self.assertEqual(self.right.stop(), 0)
        self.assertLess(time.monotonic() - began, 10)

    def test_a_tapestry_wakes_it_once_each_time_that_more_is_woven(self):
        left, right = self.start_both()
        wanted = self.right.root / "wanted"
        for step, (levels, is_other) in enumerate(((0, True), (0, False), (2, True), (2, False), (None, False), (2, True))):
            wanted.unlink(missing_ok=True)
            told = {} if levels is None else {"tapestry": {"path": "a.mp4", "folder": "f", "levels": levels}}
            for number in (2 * step, 2 * step + 1):
                left.send("lifted", {"version": 1, "number": number, **told})
            right.hears("lifted", {"version": 1, "number": 2 * step + 1, **told})
            self.assertEqual(wanted.exists(), is_other, f"step {step}")

    def test_a_follower_fetches_catalogue_store_captions_and_tapestries_with_the_secret_alone(self):
        (self.left.state / "store" / "a.mp4").write_bytes(b"clip" * 1000)
        (self.left.state / "catalogue" / "1.json").write_text("{}")
        (self.right.state / "catalogue" / "old.json").write_text("{}")
        (self.left.state / "hints.json").write_text("{}")
        for box, files in ((self.left, ("words/new.png", "status.json", "tapestry/7/index.json", "tapestry/7/f2/0-0.png")),
                           (self.right, ("words/old.png", "status.json", "wall/own", "tapestry/7/index.json", "tapestry/7/f1/0-0.png", "tapestry/6/index.json"))):
            for file in files:
                (box.state / file).parent.mkdir(parents=True, exist_ok=True)
                (box.state / file).write_text(box.name)
        os.utime(self.left.state / "store" / "a.mp4", (1000000000, 1000000000))
        self.share()
        self.assertEqual((self.right.state / "store" / "a.mp4").read_bytes(), b"clip" * 1000)
        self.assertEqual((self.right.state / "store" / "a.mp4").stat().st_mtime, 1000000000)
        self.assertEqual([p.name for p in (self.right.state / "catalogue").glob("*.json")], ["1.json"])
        own = {str(file.relative_to(self.right.state)): file.read_text() for file in self.right.state.rglob("*")
               if file.is_file() and file.parent.name not in ("store", "catalogue")}
        self.assertEqual(own, {"hints.json": "{}", "words/new.png": "left", "status.json": "right", "wall/own": "right",
                               "tapestry/7/index.json": "left", "tapestry/7/f2/0-0.png": "left"})
        self.assertNotEqual(self.stranger.fetch().returncode, 0)
        self.assertEqual(list((self.stranger.state / "store").iterdir()), [])
        # Nothing can be written there, with the secret either.
        secret = self.right.root / "etc/vitrine/wall/fetch.secret"
        pushed = subprocess.run([*self.right.inside, "rsync", f"--password-file={secret}", "--port=8730", secret, f"vitrine@{LEADER}::store/b"],
                                capture_output=True)
        self.assertNotEqual(pushed.returncode, 0)
        self.assertFalse((self.left.state / "store" / "b").exists())

    def test_a_follower_whose_disk_is_full_makes_room_and_tells_if_that_is_not_enough(self):
        self.share()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", self.right.state], check=True)
        self.addCleanup(subprocess.run, ["umount", self.right.state], check=True)
        store = self.left.state / "store"

        def fetch(replaces, name, size):
            """The status of a fetch once a file has come in place of another, and why it failed."""
            (store / replaces).unlink(missing_ok=True)
            (store / name).write_bytes(bytes(1000 * size))
            code = self.right.fetch().returncode
            return code, self.right.fetch_fault.read_text() if self.right.fetch_fault.exists() else ""

        (self.right.state / "wanted").write_text("gone.mp4\nd.mp4\n")
        self.assertEqual(fetch("none", "a.mp4", 600), (0, ""))
        self.assertEqual(fetch("a.mp4", "b.mp4", 600), (0, ""), "the old film makes room")
        self.assertEqual([file.name for file in (self.right.state / "store").glob("*.mp4")], ["b.mp4"])
        code, why = fetch("none", "c.mp4", 900)
        self.assertEqual(code, 11)
        self.assertRegex(why, r"^rsync: .*No space left on device.*\n$")
        self.assertEqual(fetch("none", "d.mp4", 10)[0], 11)
        self.assertTrue((self.right.state / "store" / "d.mp4").exists(), "the wall waits for it, so that it comes first")
        self.assertEqual(fetch("c.mp4", "e.mp4", 10), (0, ""))

    def test_what_the_wall_wants_comes_as_soon_as_it_is_told(self):
        self.share()
        for number in range(1, 5):
            (self.left.state / "store" / f"{number}.mkv").write_text("film")
        # All files take for ever, twice. Meanwhile the wall wants a file, and then another one, and one that nobody has.
        tries = self.right.root / "tries"
        tools = self.right.root / "bin"
        tools.mkdir()
        (tools / "rsync").write_text(f"""#!/bin/sh
case "$*" in *--files-from*|*::[!s]*|*--delete*) exec {shutil.which("rsync")} "$@" ;; esac
echo $(cd {self.right.state}/store; ls [1-4].mkv 2>/dev/null) >>{tries}
try=$(wc -l <{tries})
[ $try = 4 ] && exec {shutil.which("rsync")} "$@"
[ $try = 3 ] && {{ echo "rsync: no route" >&2; exit 10; }}
printf "gone.mkv\n$((try + 1)).mkv\n" >{self.right.state}/wanted
trap 'kill $!; echo "rsync error: received SIGTERM" >&2; exit 20' TERM
sleep {PATIENCE} &
wait
""")
        (tools / "rsync").chmod(0o755)
        self.assertEqual(self.right.fetch(PATH=f"{tools}:{os.environ['PATH']}").returncode, 10)
        self.assertEqual(self.right.fetch_fault.read_text(), "rsync: no route\n", "not that it was stopped for another file")
        self.assertEqual(self.right.fetch(PATH=f"{tools}:{os.environ['PATH']}").returncode, 0)
        self.assertEqual(tries.read_text(), "\n2.mkv\n2.mkv 3.mkv\n2.mkv 3.mkv\n")
        self.assertEqual(len(list((self.right.state / "store").glob("[1-4].mkv"))), 4)

    def clock_settings(self, box):
        """Debian's own settings of chronyd, which include ours; no pools, and no files of this machine."""
        conf = box.root / "etc/chrony/chrony.conf"
        text = re.sub(r"^(pool|sourcedir|driftfile|ntsdumpdir|logdir|rtcsync|leapsectz).*\n", "", (DAEMONS / "usr/share/chrony/chrony.conf").read_text(), flags=re.M)
        conf.write_text(text.replace("/etc/chrony", str(conf.parent)) + f"pidfile {box.root}/chronyd.pid\nbindcmdaddress /\ncmdport 0\n")
        return conf

    def test_a_follower_asks_the_leader_for_the_time_with_the_key_alone(self):
        clock = subprocess.Popen(["chronyd", "-d", "-x", "-u", "root", "-f", self.clock_settings(self.left)],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(clock.wait)
        self.addCleanup(clock.kill)
        asked = {}
        for box in (self.right, self.stranger):  # -Q only tells the difference
            asked[box] = subprocess.Popen([*box.inside, "chronyd", "-Q", "-u", "root", "-t", "8", "-f", self.clock_settings(box)], text=True,
                                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        said = {box: process.communicate(timeout=PATIENCE)[0] for box, process in asked.items()}
        self.assertIn("System clock wrong by", said[self.right])
        self.assertNotIn("System clock wrong by", said[self.stranger])


class Roles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-wall-")
        self.addCleanup(folder.cleanup)
        self.box = Box(folder.name, "one")
        self.good = Path(folder.name) / "good.key"
        self.good.write_text("a" * 64 + "\n")

    def fails(self, *words):
        """One sentence, and nothing is written."""
        before = self.files()
        said = self.box.wall(*words)
        self.assertEqual(said.returncode, 1)
        self.assertEqual(len(said.stderr.splitlines()), 1, said.stderr)
        self.assertEqual(self.files(), before)
        return said.stderr

    def files(self):
        return {str(p.relative_to(self.box.root)): p.read_bytes() for p in self.box.root.rglob("*") if p.is_file()}

    def test_what_a_role_wrote_is_taken_back(self):
        keys = self.box.root / "etc/chrony/chrony.keys"
        keys.parent.mkdir()
        keys.write_text("# of the machine\n1 MD5 abc\n")
        for words in (("lead", "lobby"), ("join", "lobby", str(self.good), "10.0.0.1")):
            before = self.files()
            said = self.box.wall(*words)
            self.assertEqual(said.returncode, 0, said.stderr)
            for path in sorted(set(self.files()) - set(before)):
                if path not in ("etc/vitrine/wall.key", "etc/chrony/chrony.keys"):
                    self.assertIn(f"wrote /{path}", said.stdout)
                self.assertNotIn("@", self.files()[path].decode().replace("vitrine@", ""), path)
            role = "leads" if words[0] == "lead" else "follows"
            self.assertIn(f"this box {role}", self.box.wall("status").stdout)
            self.assertEqual(self.box.wall("leave").returncode, 0)
            self.assertEqual({**self.files(), "etc/vitrine/wall.key": b""}, {**before, "etc/vitrine/wall.key": b""})
            self.assertIn("no part of a wall", self.box.wall("status").stdout)

    def test_secrets_are_for_their_users_alone_and_tell_nothing_of_the_key(self):
        self.assertEqual(self.box.wall("lead", "lobby").returncode, 0)
        key = self.box.key.read_text().strip()
        self.assertEqual(self.box.key.stat().st_mode & 0o077, 0)
        for path, content in self.files().items():
            if not path.endswith((".key", "broker.psk")):
                self.assertNotIn(key, content.decode(), path)
        for name, mode in (("vitrine/wall/broker.psk", 0o640), ("chrony/chrony.keys", 0o640), ("vitrine/wall/share.secret", 0o400)):
            self.assertEqual((self.box.root / "etc" / name).stat().st_mode & 0o777, mode, name)

    def test_both_sides_of_a_wall_make_the_same_secrets_and_another_key_makes_others(self):
        self.assertEqual(self.box.wall("lead", "lobby").returncode, 0)
        shared = (self.box.root / "etc/vitrine/wall/share.secret").read_text().strip().split(":")[1]
        for key, same in ((self.box.key, self.assertEqual), (self.good, self.assertNotEqual)):
            other = Box(tempfile.mkdtemp(dir=self.good.parent), "two")
            self.assertEqual(other.wall("join", "lobby", str(key), "10.0.0.1").returncode, 0)
            same((other.root / "etc/vitrine/wall/fetch.secret").read_text().strip(), shared)

    def test_bad_words_are_one_sentence_and_change_nothing(self):
        bad = self.good.parent / "bad.key"
        for content in ("", "a" * 63, "a" * 65, "g" * 64, "a" * 64 + "\n" + "b" * 64, "\0" * 64):
            bad.write_text(content)
            self.assertIn("is no key of a wall", self.fails("join", "lobby", str(bad), "10.0.0.1"))
        self.assertIn("there is no key", self.fails("join", "lobby", "/nowhere", "10.0.0.1"))
        self.assertIn("the key is missing", self.fails("join", "lobby"))
        for name in ("", "a/b", "a b", "-a", "ä", "a;reboot", "a|b", "a\nb", "$(id)"):
            self.assertIn("is no name", self.fails("lead", name))
        self.assertIn("at most 63", self.fails("lead", "a" * 64))
        self.assertIn("is no address", self.fails("join", "lobby", str(self.good), "a b"))
        self.assertIn("is no network", self.fails("lead", "lobby", "--net", "all of them"))
        self.assertIn("is not understood", self.fails("lead", "lobby", "hall"))
        self.assertIn("no part of a wall", self.fails("leave"))
        self.assertIn("there is no command", self.fails("lend"))

    def test_a_box_has_one_role(self):
        self.assertEqual(self.box.wall("lead", "lobby").returncode, 0)
        self.assertIn("leads the wall 'lobby'", self.fails("join", "lobby", str(self.good), "10.0.0.1"))
        self.assertIn("leads the wall 'lobby'", self.fails("lead", "hall"))

    def test_a_network_that_is_given_is_the_only_one(self):
        self.assertEqual(self.box.wall("lead", "lobby", "--net", "10.0.7.0/24").returncode, 0)
        self.assertIn("hosts allow = 10.0.7.0/24\n", (self.box.root / "etc/vitrine/wall/rsyncd.conf").read_text())
        self.assertIn("allow 10.0.7.0/24\n", (self.box.root / "etc/chrony/conf.d/vitrine-wall.conf").read_text())

    def test_a_link_without_a_part_or_a_key_says_so_in_a_sentence(self):
        for options, sentence in (((), "no part of a wall"), (("--wall.role", "lead"), "wall.name is missing"),
                                  (("--wall.role", "follow", "--wall.name", "lobby"), "wall.leader is missing"),
                                  (("--wall.role", "lead", "--wall.name", "lobby", "--wall.key", "/nowhere"), "cannot be read"),
                                  (("--wall.role", "lead", "--wall.name", "lobby", "--wall.key", "/etc/hostname"), "is no key")):
            said = subprocess.run([LINK, "--config", self.box.settings, *options], text=True, capture_output=True, timeout=PATIENCE)
            self.assertEqual(said.returncode, 1)
            self.assertIn(sentence, said.stderr)
            self.assertEqual(len(said.stderr.splitlines()), 1, said.stderr)


if __name__ == "__main__":
    run_tests()

#!/usr/bin/env python3
"""vitrine-analyzer on a share that answers wrongly: it lives on, nothing good is lost, all files are ready in the end.

    hostile_share_test.py BUILD_DIRECTORY [--all] [unittest arguments]

Without --all a seeded sample of the errors is tried. Needs FUSE and python3-fusepy; ends with 77 where they are not.
"""
import contextlib
import errno
import os
import random
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from drawn_media import png
from mounted_share import MountedShare, can_mount
from watched_folder import ERRORS, PATIENCE, FaultyFolder

BUILD = Path(sys.argv[1]).resolve()
ALL = "--all" in sys.argv
SKIPPED = 77
PLACES = [("file", "open"), ("file", "read"), ("file", "stat"), ("folder", "stat"), ("folder", "list")]
STOP_PATIENCE = 10  # seconds; TimeoutStopSec= of the unit
OUTAGE = 6  # seconds; the analyzer looks at a new file of a share for the second time after two or three


class HostileShare(FaultyFolder):
    analyzer = BUILD / "analyzer" / "vitrine-analyzer"
    patience = 900 if ALL else PATIENCE  # a hundred files are analysed

    def setUp(self):
        super().setUp()
        self.backing = Path(self.folder.name) / "backing"
        self.backing.mkdir()
        self.share = MountedShare(self.backing, self.root, Path(self.folder.name) / "faults.json")
        self.addCleanup(self.share.unmount)

    def drop(self, name, colour=(200, 100, 50)):
        file = self.backing / name
        file.parent.mkdir(parents=True, exist_ok=True)
        png(file, 48, 32, lambda x, y: colour)

    def is_calling(self, watcher):
        """True if the analyzer waits for the server, or has a file of the share open, whose end it will wait for."""
        process = Path(f"/proc/{watcher.pid}")
        held = []
        for descriptor in process.glob("fd/*"):
            with contextlib.suppress(FileNotFoundError):  # closed meanwhile
                held.append(os.readlink(descriptor))
        return (process / "wchan").read_text() == "request_wait_answer" or any(name.endswith(".png") for name in held)

    def silence_server_between_calls(self, watcher):
        """The kernel lets no process end while the server has begun its call or is to close its file: SIGKILL waits."""
        for _ in range(100):
            self.share.process.send_signal(signal.SIGSTOP)
            if not self.is_calling(watcher):
                return
            self.share.process.send_signal(signal.SIGCONT)
            time.sleep(0.03)
        self.fail("the analyzer calls the server all the time")

    def test_errors_condemn_no_file_and_end_nothing(self):
        cases = [(name, level, call) for name in ERRORS for level, call in PLACES]
        if not ALL:
            cases = random.Random(15).sample(cases, 10)
        for number, _ in enumerate(cases):
            self.drop(f"{number}/before.png")
        watcher = self.start()
        files = {f"{number}/before.png" for number, _ in enumerate(cases)}
        self.until_all_ready(watcher, files)

        self.share.fail_with(*({"path": f"/{number}/*" if level == "file" else f"/{number}", "call": call, "errno": getattr(errno, name)}
                               for number, (name, level, call) in enumerate(cases)))
        for number, _ in enumerate(cases):
            self.drop(f"{number}/meanwhile.png", (20, 100, 50))
        time.sleep(OUTAGE)
        self.assertTrue(files <= set(self.records()), "a file was lost")
        self.share.fail_with()
        self.until_all_ready(watcher, files | {f"{number}/meanwhile.png" for number, _ in enumerate(cases)})

    def test_a_stop_while_the_server_is_silent_takes_seconds_and_is_no_failure(self):
        self.drop("a.png")
        watcher = self.start()
        self.until_all_ready(watcher, {"a.png"})
        self.addCleanup(self.share.process.send_signal, signal.SIGCONT)
        self.silence_server_between_calls(watcher)
        time.sleep(OUTAGE)  # until the analyzer waits for an answer
        begin = time.monotonic()
        watcher.terminate()
        self.assertEqual(watcher.wait(STOP_PATIENCE), 0)
        print(f"ended after {time.monotonic() - begin:.1f} s", file=sys.stderr)

    def test_a_root_that_fails_ends_nothing(self):
        errors = ERRORS if ALL else random.Random(15).sample(ERRORS, 3)
        self.drop("a.png")
        watcher = self.start()
        names = {"a.png"}
        self.until_all_ready(watcher, names)
        for name in errors:
            for call in ("stat", "list"):
                with self.subTest(error=name, call=call):
                    self.share.fail_with({"path": "/", "call": call, "errno": getattr(errno, name)})
                    time.sleep(1.5)
                    self.assertTrue(names <= set(self.records()), "a file was lost")
                    self.share.fail_with()
                    names.add(f"{name}-{call}.png")
                    self.drop(f"{name}-{call}.png")
                    self.until_all_ready(watcher, names)

    def test_an_error_at_the_start_is_no_end_and_one_while_a_photo_is_read_is_told_as_the_shares(self):
        self.drop("a.png")
        self.share.fail_with({"path": "/a.png", "call": "read", "errno": errno.EIO})
        watcher = self.start()
        record = self.until("a.png waits", lambda records: records.get("a.png", {}).get("state") == "waiting")["a.png"]
        self.assertEqual(record["fault"]["owner"], "transport")
        self.assertIn("Input/output error", record["reason"])
        watcher.kill()
        watcher.wait()
        self.share.fail_with()
        self.until_all_ready(self.start(), {"a.png"})

    def test_half_a_listing_loses_no_file_and_what_is_deleted_is_gone(self):
        names = {f"{number}.png" for number in range(6)}
        for name in names:
            self.drop(name)
        watcher = self.start()
        self.until_all_ready(watcher, names)
        self.share.fail_with({"path": "/", "call": "list", "half": True})
        time.sleep(OUTAGE)
        self.assertEqual(set(self.records()), names)
        self.assertNotIn("gone:", self.journal.read_text())
        self.share.fail_with({"path": "/private", "call": "list", "errno": errno.EACCES})
        (self.backing / "private").mkdir()
        (self.backing / "0.png").unlink()
        self.until("0.png is gone beside a folder that cannot be read", lambda records: "0.png" not in records)
        self.assertEqual(set(self.records()), names - {"0.png"})
        self.assertIsNone(watcher.poll())

    def test_a_share_that_dies_and_comes_back_loses_nothing(self):
        names = {"a.png", "b.png"}
        for name in names:
            self.drop(name)
        watcher = self.start()
        self.until_all_ready(watcher, names)
        self.share.kill()
        time.sleep(OUTAGE)
        self.assertIsNone(watcher.poll(), self.journal.read_text()[-2000:])
        self.assertEqual(set(self.records()), names)
        self.state, kept = Path(self.folder.name) / "other", self.state
        again = self.start()  # a start meanwhile
        self.state = kept
        time.sleep(OUTAGE)
        self.assertIsNone(again.poll(), self.journal.read_text()[-2000:])
        subprocess.run(["umount", "-l", self.root], check=True)
        self.drop("c.png")
        self.share.mount()
        self.until_all_ready(watcher, names | {"c.png"})

    def test_reads_that_are_short_give_the_same_pictures(self):
        self.drop("a.png")
        self.share.fail_with({"path": "/a.png", "call": "read", "short": 7})
        self.until_all_ready(self.start(), {"a.png"})


if __name__ == "__main__":
    if not can_mount():
        print("NOT RUN: a hostile share needs root, /dev/fuse and python3-fusepy", file=sys.stderr)
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], "-v", *(word for word in sys.argv[2:] if word != "--all")])

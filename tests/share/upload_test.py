#!/usr/bin/env python3
"""Operators' uploads, by a real smbclient into a real smbd, and what vitrine-analyzer watch makes of them.

    upload_test.py BUILD_DIRECTORY [unittest arguments]

Ends with 77 where no smbd can be had, saying why.
"""
import sys
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path += [str(Path(__file__).resolve().parents[1] / beside) for beside in ("pipeline", "appliance")]
from drawn_media import png
from image import NotHere
from share_client import ShareClient, enlarge
from share_server import ShareServer, unpacked
from watched_folder import WatchedFolder

SKIPPED = 77
BUILD = Path(sys.argv[1]).resolve()
SLOW = 5  # seconds that a slow upload takes, about
PASSWORD = "correct horse"


def photo(path, width):
    """A square on grey, whose width tells one from another."""
    png(path, width, 96, lambda x, y: (220, 210, 40) if abs(x - width // 2) < 20 and abs(y - 48) < 20 else (90, 90, 90))
    return path


class Upload(WatchedFolder):
    analyzer = BUILD / "analyzer" / "vitrine-analyzer"

    def setUp(self):
        super().setUp()
        server = ShareServer(self.root, PASSWORD)
        self.addCleanup(server.close)
        self.client = ShareClient(server.port, PASSWORD, server.user)
        self.start()

    def drawn(self, name, width):
        return photo(Path(self.folder.name) / name, width)

    def large_photo(self, name, width):
        file = self.drawn(name, width)
        enlarge(file)
        return file

    def width_of(self, name):
        """Of a file that is ready."""
        record = self.records().get(name, {"state": "none"})
        return record["width"] if record["state"] == "ready" else None

    def size(self, name):
        return (self.root / name).stat().st_size if (self.root / name).exists() else 0

    def test_only_who_knows_the_password_gets_in(self):
        self.assertFalse(self.client.is_refused())
        self.assertTrue(self.client.is_refused(guest=True))
        self.assertTrue(ShareClient(self.client.port, "wrong", self.client.user).is_refused())

    def test_a_slow_upload_is_not_ready_before_its_end(self):
        file, sizes = self.large_photo("slow.png", 200), set()

        def meanwhile():
            size = self.size("slow.png")
            sizes.add(size)
            if size < file.stat().st_size:
                self.assertIsNone(self.width_of("slow.png"), f"ready with {size} bytes of {file.stat().st_size}")
            time.sleep(0.02)

        self.client.put_slowly(file, file.stat().st_size // SLOW, meanwhile)
        self.assertTrue(sizes - {0, file.stat().st_size}, f"a part of it was never there: {sizes}")
        self.until_ready("slow.png", 200)

    def test_an_upload_that_is_cut_off_waits_and_is_taken_when_it_comes_anew(self):
        file = self.large_photo("aborted.png", 210)
        self.client.put_and_die(file, file.stat().st_size // SLOW, lambda: self.size("aborted.png"))
        self.until("it is looked at", lambda records: records.get("aborted.png", {"bytes": 0})["bytes"] == self.size("aborted.png"))
        self.assertTrue(0 < self.size("aborted.png") < file.stat().st_size, self.size("aborted.png"))
        self.assertEqual(self.records()["aborted.png"]["state"], "waiting", self.records())
        self.client.put(file)
        self.until_ready("aborted.png", 210)

    def test_what_is_overwritten_in_place_slowly_is_ready_as_the_old_or_the_new(self):
        self.client.put(self.drawn("old.png", 220), "photo.png")
        self.until_ready("photo.png", 220)
        file, sizes = self.large_photo("new.png", 230), set()

        def meanwhile():
            size = self.size("photo.png")
            sizes.add(size)
            if size < file.stat().st_size:
                self.assertIn(self.width_of("photo.png"), (220, None), f"ready with {size} bytes of {file.stat().st_size}")
            time.sleep(0.02)

        self.client.put_slowly(file, file.stat().st_size // SLOW, meanwhile, "photo.png")
        self.assertGreater(len(sizes - {0, file.stat().st_size}), 1, f"a part of the new one was never there: {sizes}")
        self.until_ready("photo.png", 230)

    def test_folders_names_and_deletions_come_through_the_share(self):
        file = self.drawn("one.png", 240)
        self.client.put(file)
        self.client.say(f'mkdir "Frühling"; put "{file}" "Frühling/two.png"')
        self.until_ready("one.png", 240)
        self.until_ready("Frühling/two.png", 240)
        self.client.say('rename one.png "drei (3).png"; del "Frühling\\two.png"')
        self.until("what was renamed and deleted", lambda records: set(records) == {"drei (3).png"})
        self.until_ready("drei (3).png", 240)


def main():
    try:
        unpacked()
    except NotHere as why:
        line = "#" * 100
        print(f"{line}\n# UPLOADS ARE NOT RUN, nothing is known of real shares: {why}\n{line}", flush=True)
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""The units are as systemd wants them, and leave strangers' files little to get at.

    units_test.py DIRECTORY   the units as they are installed
"""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77
UNITS = Path(sys.argv.pop(1))
PROGRAMS = ("vitrine-analyzer.service", "vitrine-player.service")
# of 10, which is a service without a sandbox; those of a wall speak to the network
MOST = {"vitrine-analyzer.service": 1.0, "vitrine-player.service": 2.0, "vitrine-link.service": 1.3,
        "vitrine-wall-share.service": 1.3, "vitrine-wall-fetch.service": 1.3}
OTHERS = ("vitrine.target", "vitrine-wall-fetch.path", "vitrine-wall-fetch.timer")


def run(*command):
    return subprocess.run(command, text=True, capture_output=True)


def assignments(unit):
    """[(name, value)] of a unit's file."""
    lines = (UNITS / unit).read_text().splitlines()
    return [tuple(line.split("=", 1)) for line in lines if "=" in line and not line.startswith("#")]


class Units(unittest.TestCase):
    def test_a_service_is_exposed_no_more_than_is_needed(self):
        for unit, most in MOST.items():
            said = run("systemd-analyze", "security", "--offline=true", "--no-pager", str(UNITS / unit))
            exposure = float(re.search(r"Overall exposure level for \S+: ([\d.]+)", said.stdout)[1])
            print(f"{unit}: {exposure}")
            self.assertLessEqual(exposure, most, unit)

    def test_every_line_is_known_to_systemd(self):
        with tempfile.TemporaryDirectory() as folder:
            for unit in (*MOST, *OTHERS):
                text = re.sub(r"^(ExecStart)=.*", r"\1=/bin/true", (UNITS / unit).read_text(), flags=re.M)
                text = re.sub(r"^Documentation=.*\n", "", text, flags=re.M)  # installed with the programs
                (Path(folder) / unit).write_text(text)
            for unit in (*MOST, *OTHERS):
                said = run("systemd-analyze", "verify", "--man=no", "--recursive-errors=no", str(Path(folder) / unit))
                ours = [line for line in said.stderr.splitlines() if "vitrine" in line]
                self.assertEqual(ours, [])

    def test_the_screen_and_the_media_folder_are_never_given_up(self):
        player = dict(assignments("vitrine-player.service"))
        self.assertEqual((player["Restart"], player["StartLimitIntervalSec"]), ("always", "0"))
        self.assertEqual(dict(assignments("vitrine-analyzer.service"))["StartLimitIntervalSec"], "0")  # a server comes back
        self.assertEqual(player["FileDescriptorStoreMax"], "1")  # of the card, with the last picture

    def test_what_speaks_to_the_network_has_a_user_of_its_own_and_opens_no_port(self):
        link = dict(assignments("vitrine-link.service"))
        self.assertEqual((link["User"], link["SocketBindDeny"]), ("vitrine-link", "any"))
        self.assertIn("/var/lib/vitrine", link["InaccessiblePaths"])
        for unit in PROGRAMS:
            self.assertEqual(dict(assignments(unit))["IPAddressDeny"], "any")

    def test_both_are_watched_and_told_when_settings_change(self):
        for unit in PROGRAMS:
            service = dict(assignments(unit))
            self.assertEqual(service["Type"], "notify")
            self.assertIn("WatchdogSec", service)
            self.assertIn("-HUP", service["ExecReload"])
            self.assertEqual(service["User"], "vitrine")


if __name__ == "__main__":
    if not shutil.which("systemd-analyze"):
        print("systemd-analyze is not here: THE UNITS ARE NOT TESTED")
        sys.exit(SKIPPED)
    unittest.main()

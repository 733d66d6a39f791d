#!/usr/bin/env python3
"""The Debian packages of this build hold what they should, and their scripts start nothing.

    packages_test.py BUILD OUTDIR   a build of preset release; where the packages are left, for the rig to install
"""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SKIPPED = 77
GIT = ["git", "-c", "safe.directory=*", "-C", ROOT]
BUILD, OUT = (Path(word) for word in sys.argv[1:])
NAMES = ("vitrine", "vitrine-analyzer", "vitrine-player", "vitrine-wall")
# One of each kind, in the package that has to have it; what is in none of them fails the build (dh_missing).
HELD = {
    "vitrine-analyzer": ["usr/bin/vitrine-analyzer", "etc/vitrine/vitrine.toml", "lib/systemd/system/vitrine-analyzer.service",
                         "usr/lib/sysusers.d/vitrine.conf", "usr/lib/tmpfiles.d/vitrine.conf",
                         "usr/share/man/man1/vitrine-analyzer.1.gz", "usr/share/man/man5/vitrine.toml.5.gz",
                         "usr/share/doc/vitrine/operator.md", "usr/share/doc/vitrine/technician.md",
                         "usr/share/doc/vitrine/appliance.md", "usr/share/doc/vitrine/wall.md", "usr/share/doc/vitrine/catalogue.md",
                         "usr/share/doc/vitrine/images/status.jpg", "usr/share/vitrine/face_detection_yunet.onnx",
                         "usr/share/vitrine/student.onnx", "usr/share/vitrine/text_detection.onnx",
                         "usr/share/vitrine/u2netp.onnx"],
    "vitrine-player": ["usr/bin/vitrine-player", "lib/systemd/system/vitrine-player.service",
                       "lib/systemd/system/vitrine.target", "usr/share/man/man1/vitrine-player.1.gz"],
    "vitrine-wall": ["usr/bin/vitrine-link", "lib/systemd/system/vitrine-link.service", "lib/systemd/system/vitrine-wall-fetch.path",
                     "usr/lib/sysusers.d/vitrine-wall.conf", "usr/lib/vitrine-wall/wall", "usr/lib/vitrine-wall/templates/mosquitto.conf",
                     "usr/share/man/man1/vitrine-link.1.gz"],
    "vitrine": ["usr/share/doc/vitrine/examples/smb.conf", "usr/share/doc/vitrine/README.Debian"]}
# Of the tags that lintian may have for packages whose binaries were not compiled with Debian's flags.
OF_BUILT = {"hardening-no-fortify-functions", "hardening-no-bindnow", "hardening-no-relro", "hardening-no-pie",
            "file-references-package-build-path"}


def run(*command):
    return subprocess.run([str(word) for word in command], text=True, capture_output=True, check=True).stdout


def package(name):
    return next(OUT.glob(f"{name}_*.deb"))


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(OUT, ignore_errors=True)
        before = run(*GIT, "status", "--porcelain")
        run(ROOT / "packaging/build-packages", "--built", BUILD, OUT)
        assert run(*GIT, "status", "--porcelain") == before, "the source tree is not as it was"

    def test_each_file_is_in_its_package(self):
        for name, files in HELD.items():
            listed = {line.split()[5].removeprefix("./") for line in run("dpkg-deb", "--contents", package(name)).splitlines()}
            self.assertEqual([file for file in files if file not in listed], [], name)

    def test_the_version_is_that_of_the_project(self):
        version = re.search(r"project\(vitrine VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        for name in NAMES:
            self.assertTrue(run("dpkg-deb", "-f", package(name), "Version").startswith(version))

    def test_settings_are_a_conffile(self):
        self.assertEqual(run("dpkg-deb", "-I", package("vitrine-analyzer"), "conffiles").split(), ["/etc/vitrine/vitrine.toml"])

    def test_nothing_is_started_but_what_runs_already(self):
        for name in NAMES:
            for script in ("postinst", "preinst"):
                said = subprocess.run(["dpkg-deb", "-I", package(name), script], text=True, capture_output=True).stdout
                self.assertNotRegex(said, r"deb-systemd-invoke (?!try-restart)|systemctl [^\n]*start")

    def test_what_plays_is_depended_on(self):
        for name in ("vitrine-analyzer", "vitrine-player"):
            depends = run("dpkg-deb", "-f", package(name), "Depends")
            for needed in ("gstreamer1.0-libav", "gstreamer1.0-plugins-good", "gstreamer1.0-plugins-bad", "libgstreamer1.0-0"):
                self.assertIn(needed, depends)

    @unittest.skipUnless(shutil.which("lintian"), "lintian is not installed")
    def test_lintian_finds_no_error_and_no_warning(self):
        said = subprocess.run(["lintian", "--allow-root", "--no-cfg", "-L", ">=warning", *(str(package(name)) for name in NAMES)],
                              text=True, capture_output=True).stdout
        tags = [line for line in said.splitlines() if re.match("[EW]:", line) and line.split()[2] not in OF_BUILT]
        self.assertEqual(tags, [])


if __name__ == "__main__":
    if not shutil.which("dh") or not shutil.which("dpkg-buildpackage"):
        print("debhelper is not installed (packaging/dependencies): the packages are NOT built")
        sys.exit(SKIPPED)
    if subprocess.run([*GIT, "rev-parse"], capture_output=True).returncode != 0:
        print("the tree is no clone: the packages, named after its commit, are NOT built")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)

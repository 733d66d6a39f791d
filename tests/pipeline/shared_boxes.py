"""Boxes of one wall and their broker, in network namespaces of their own on made-up addresses.

`vitrinectl wall` writes the settings of each box below a folder of the test; mosquitto, rsync and chrony are Debian's.
The daemons are unpacked, not installed: whoever tests shall not find a broker running afterwards, nor another clock.
"""
import os
import pwd
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).resolve().parents[1] / folder) for folder in (".", "share", "appliance")]
from image import NotHere  # noqa: E402
from share_server import unpack  # noqa: E402

SKIPPED = 77
PACKAGES = ("mosquitto", "mosquitto-clients", "chrony", "libmosquitto1", "libcjson1", "libdlt2", "libwrap0", "libedit2", "libseccomp2")
BUILD = Path(sys.argv[1]).resolve()
SOURCE = Path(__file__).resolve().parents[2]
LINK, WALL, FETCH = BUILD / "link" / "vitrine-link", SOURCE / "link" / "wall" / "wall", SOURCE / "link" / "wall" / "fetch"
INSIDE = "VITRINE_LINK_TEST"
DAEMONS = Path(os.environ.get(INSIDE, "/"))  # where Debian's packages are unpacked
PATIENCE = 60  # seconds until what must come is given up
LEADER, FOLLOWER = "10.77.0.1", "10.77.0.2"


def require_this_machine():
    """Throws NotHere, which says what this machine lacks."""
    for name in ("rsync", "ip", "unshare", "nsenter"):
        if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin"):
            raise NotHere(f"not installed: {name}")
    if os.getuid() != 0 or subprocess.run(["unshare", "--net", "true"], capture_output=True).returncode != 0:
        raise NotHere("no right to make a network namespace")


def run_tests():
    """Runs the tests of the script that is started, in a network of its own. Where that cannot be, prints NOT RUN."""
    if INSIDE not in os.environ:
        try:
            require_this_machine()
            os.environ[INSIDE] = str(unpack("wall-daemons", *PACKAGES))
        except NotHere as reason:
            print(f"NOT RUN: {reason}")
            sys.exit(SKIPPED)
        os.execvp("unshare", ["unshare", "--net", sys.executable, *sys.argv])
    os.environ["PATH"] = f"{DAEMONS}/usr/sbin:{DAEMONS}/usr/bin:{os.environ['PATH']}:/usr/sbin:/sbin"
    os.environ["LD_LIBRARY_PATH"] = f"{DAEMONS}/usr/lib/{os.uname().machine}-linux-gnu"
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)


def until(what, holds):
    end = time.monotonic() + PATIENCE
    while not (found := holds()):
        if time.monotonic() > end:
            raise AssertionError(f"not within {PATIENCE} s: {what}")
        time.sleep(0.02)
    return found


class Box:
    """The files of one box, as `vitrinectl wall` writes them."""

    def __init__(self, folder, name, inside=()):
        self.root, self.name, self.inside = Path(folder) / name, name, list(inside)
        self.settings = self.root / "etc/vitrine/vitrine.toml"
        self.settings.parent.mkdir(parents=True)
        self.fetch_fault = self.root / "fetch_fault"
        self.state = self.root / "state"
        for part in ("catalogue", "store"):
            (self.state / part).mkdir(parents=True)
        self.settings.write_text(f'[state]\ndirectory = "{self.state}"\n\n[wall]\n# a comment\n#role = "alone"\nbox = "{name}"\n'
                                 f'fetch_fault = "{self.fetch_fault}"\n')
        self.key = self.root / "etc/vitrine/wall.key"
        self.link = None

    def environment(self):
        return {**os.environ, "VITRINE_WALL_ROOT": str(self.root), "VITRINE_LINK": f"{LINK} --config {self.settings}"}

    def wall(self, *words):
        return subprocess.run([WALL, *words], text=True, capture_output=True, env=self.environment(), timeout=PATIENCE)

    def fetch(self, **environment):
        return subprocess.run([*self.inside, FETCH], text=True, capture_output=True, env={**self.environment(), **environment}, timeout=PATIENCE)

    def written(self, name):
        """A file that was written, with the paths of this test in place of the machine's."""
        path = self.root / name
        text = path.read_text()
        if f"{self.root}/etc/" not in text:
            path.write_text(text.replace("/etc/vitrine/wall/", f"{self.root}/etc/vitrine/wall/"))
        return path

    def socket(self):
        return self.root / "link.sock"

    def start(self, *options):
        """Starts the link."""
        self.socket().unlink(missing_ok=True)
        self.log = open(self.root / "log", "a")
        self.link = subprocess.Popen([*self.inside, LINK, "--config", self.settings, "--wall.key", self.key, "--wall.socket", self.socket(), *options],
                                     stderr=self.log)

    def said(self):
        return (self.root / "log").read_text()

    def stop(self, number=signal.SIGTERM):
        """Ends the link, if it runs; its exit status."""
        if self.link:
            self.link.send_signal(number)
            code = self.link.wait(PATIENCE)
            self.log.close()
            self.link = None
            return code


def join_namespaces():
    """Makes the namespace of the followers and joins it to this one by a cable. @return its process, and how to run inside"""
    far = subprocess.Popen(["unshare", "--net", "sleep", "3600"])
    inside = ["nsenter", "--net", "--target", str(far.pid)]
    until("a namespace", lambda: os.readlink(f"/proc/{far.pid}/ns/net") != os.readlink("/proc/self/ns/net"))
    for command in (["ip", "link", "set", "lo", "up"], ["ip", "link", "add", "near", "type", "veth", "peer", "name", "far"],
                    ["ip", "link", "set", "far", "netns", str(far.pid)], ["ip", "address", "add", f"{LEADER}/24", "dev", "near"],
                    ["ip", "link", "set", "near", "up"], [*inside, "ip", "address", "add", f"{FOLLOWER}/24", "dev", "far"],
                    [*inside, "ip", "link", "set", "far", "up"]):
        subprocess.run(command, check=True)
    return far, inside


class Broker:
    """Debian's mosquitto with Debian's own settings, which include those of the box that leads."""

    def __init__(self, leader):
        leader.written("etc/mosquitto/conf.d/vitrine-wall.conf")
        conf = re.sub(r"^(pid_file|persistence_location|log_dest) .*\n", "", (DAEMONS / "etc/mosquitto/mosquitto.conf").read_text(), flags=re.M)
        self.conf = leader.root / "etc/mosquitto/mosquitto.conf"
        self.conf.write_text(conf.replace("/etc/mosquitto", str(self.conf.parent)))
        if "mosquitto" in [user.pw_name for user in pwd.getpwall()]:
            shutil.chown(leader.root / "etc/vitrine/wall/broker.psk", "root", "mosquitto")
        else:
            with open(self.conf, "a") as conf:
                conf.write("user root\n")
        leader.root.parent.chmod(0o755)
        self.process = None

    def start(self):
        self.process = subprocess.Popen(["mosquitto", "-c", self.conf], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def stop(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process = None


def start_share(leader):
    """Starts the rsync from which followers fetch; its process."""
    conf = leader.written("etc/vitrine/wall/rsyncd.conf")
    return subprocess.Popen(["rsync", "--daemon", "--no-detach", f"--config={conf}", "--dparam=uid=root"],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

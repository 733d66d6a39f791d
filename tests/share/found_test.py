#!/usr/bin/env python3
"""Finds the appliance's share from another machine of the network, as Windows, macOS and Linux do.

    found_test.py [unittest arguments]

Two machines are network namespaces with a cable between them. In one run avahi-daemon and wsdd with what the image
gives them, in the other real clients of both protocols: avahi-browse, and wsdd that looks for others. The daemons are
unpacked, not installed. Ends with 77 where they or namespaces cannot be had, saying why.
"""
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[1] / "appliance"))
from image import NotHere
from share_server import unpack

SKIPPED = 77
IMAGE = Path(__file__).resolve().parents[2] / "packaging/image/root"
PACKAGES = ("avahi-daemon", "avahi-utils", "libavahi-client3", "libavahi-common3", "libavahi-core7", "libdaemon0", "wsdd")
PATIENCE = 30  # seconds; told is how long it took
WANTED = 5  # seconds
BUS = """<busconfig><type>system</type><listen>unix:path=/run/dbus/system_bus_socket</listen><auth>EXTERNAL</auth>
<policy context="default"><allow own="*"/><allow send_destination="*"/><allow receive_sender="*"/><allow user="*"/>
</policy></busconfig>"""


class Machine:
    """A machine of the network: a namespace with a name, an address, its own /run and /etc, a bus and avahi-daemon."""

    def __init__(self, folder, root, name, address):
        self.root, self.name, self.address, self.running = root, name, address, []
        self.etc = folder / name
        self.etc.mkdir()
        for file in ("passwd", "group", "nsswitch.conf", "ld.so.cache"):
            shutil.copy(Path("/etc") / file, self.etc)
        for file, user in (("passwd", "avahi:x:0:0::/:/bin/false"), ("group", "avahi:x:0:"), ("group", "netdev:x:0:")):
            (self.etc / file).write_text((self.etc / file).read_text() + user + "\n")
        shutil.copytree(root / "etc/avahi", self.etc / "avahi")
        (self.etc / "bus.conf").write_text(BUS)
        self.holder = subprocess.Popen(["unshare", "-n", "-m", "-u", "sh", "-c", f"hostname {name} && mount --bind {self.etc} /etc && "
                                        "mount -t tmpfs none /run && mkdir -p /run/dbus /run/avahi-daemon /run/wsdd && "
                                        "ip link set lo up && echo ready && exec sleep 1000"], stdout=subprocess.PIPE, text=True)
        if self.holder.stdout.readline() != "ready\n":
            raise NotHere("a network namespace cannot be had")

    def command(self, *words):
        return ["nsenter", "-n", "-m", "-u", "-t", str(self.holder.pid), "env", f"LD_LIBRARY_PATH={self.root}/usr/lib/{MULTIARCH}",
                *(str(word) for word in words)]

    def start(self, *words, log=subprocess.DEVNULL):
        self.running.append(subprocess.Popen(self.command(*words), stdout=log, stderr=subprocess.STDOUT))

    def ask(self, *words):
        return subprocess.run(self.command(*words), capture_output=True, text=True, timeout=PATIENCE).stdout

    def plug(self, cable):
        subprocess.run(["ip", "link", "set", cable, "netns", str(self.holder.pid)], check=True)
        for words in (("addr", "add", f"{self.address}/24", "dev", cable), ("link", "set", cable, "up")):
            subprocess.run(self.command("ip", *words), check=True)

    def start_avahi(self):
        self.start("dbus-daemon", "--config-file=/etc/bus.conf", "--nofork")
        until(lambda: "there" in self.ask("sh", "-c", "test -S /run/dbus/system_bus_socket && echo there"))
        self.start(self.root / "usr/sbin/avahi-daemon", "--no-drop-root", "--no-rlimits", "--no-chroot")

    def close(self):
        for process in [*self.running, self.holder]:
            process.kill()
            process.wait()
        self.holder.stdout.close()


def until(is_true):
    """Waits until it is true. @return the seconds"""
    began = time.monotonic()
    while not is_true():
        if time.monotonic() - began > PATIENCE:
            raise AssertionError(f"not within {PATIENCE} s")
        time.sleep(0.1)
    return time.monotonic() - began


class Found(unittest.TestCase):
    def setUp(self):
        folder = Path(tempfile.mkdtemp(prefix="vitrine-found-"))
        self.addCleanup(shutil.rmtree, folder)
        subprocess.run(["ip", "link", "add", "cable0", "type", "veth", "peer", "name", "cable1"], check=True)
        self.box = self.machine(folder, "vitrine", "10.77.0.2", "cable0")
        self.visitor = self.machine(folder, "visitor", "10.77.0.3", "cable1")
        for service in (IMAGE / "etc/avahi/services").iterdir():
            shutil.copy(service, self.box.etc / "avahi/services")

    def machine(self, folder, name, address, cable):
        machine = Machine(folder, ROOT, name, address)
        self.addCleanup(machine.close)
        machine.plug(cable)
        return machine

    def tell(self, what, seconds):
        print(f"{what}: {seconds:.1f} s after the daemon's start, wanted {WANTED}", file=sys.stderr)

    def test_macos_and_linux_find_the_share_and_the_name(self):
        self.visitor.start_avahi()
        self.box.start_avahi()

        def is_listed():
            lines = self.visitor.ask(ROOT / "usr/bin/avahi-browse", "-prt", "_smb._tcp").splitlines()
            return any(line.split(";")[6:9] == ["vitrine.local", "10.77.0.2", "445"] for line in lines if line.startswith("="))

        self.tell("avahi-browse", until(is_listed))
        self.assertIn("10.77.0.2", self.visitor.ask(ROOT / "usr/bin/avahi-resolve", "-4", "-n", "vitrine.local"))

    def test_windows_finds_the_machine(self):
        said = self.visitor.etc / "wsdd.log"
        with said.open("w") as log:
            self.visitor.start(ROOT / "usr/sbin/wsdd", "-v", "--shortlog", "-4", "-o", "-D", log=log)
        self.box.start(ROOT / "usr/sbin/wsdd", "--shortlog", "--chroot=/run/wsdd")
        self.tell("wsdd", until(lambda: "discovered VITRINE in Workgroup:WORKGROUP on 10.77.0.2" in said.read_text()))


if __name__ == "__main__":
    MULTIARCH = f"{os.uname().machine}-linux-gnu"
    if "VITRINE_FOUND" not in os.environ:
        try:
            ROOT = unpack("share-finders", *PACKAGES)
        except NotHere as reason:
            print(f"NOT RUN: {reason}", file=sys.stderr)
            sys.exit(SKIPPED)
        rights = [] if os.getuid() == 0 else ["-U", "-r"]
        os.execvpe("unshare", ["unshare", *rights, "-n", "-m", sys.executable, *sys.argv], os.environ | {"VITRINE_FOUND": str(ROOT)})
    ROOT = Path(os.environ["VITRINE_FOUND"])
    unittest.main(verbosity=2)

"""A real smbd of this machine's Debian, with the example that the packages bring, on a port of its own.

Samba is unpacked, not installed: whoever tests shall not find a file server running afterwards.
"""
import os
import pwd
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from image import NotHere, cache_directory, run

EXAMPLE = Path(__file__).resolve().parents[2] / "packaging/debian/smb.conf"
PATIENCE = 60  # seconds


def unpack(name, *packages):
    """The folder `name` of the cache with what Debian's packages hold. Raises NotHere where they cannot be had."""
    cache = cache_directory()
    kept = cache / name.replace(":", "_")
    try:
        if kept.exists():
            return kept
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache, prefix="making-") as made:
            run("apt-get", "-q", "download", *packages, cwd=made)
            for package in Path(made).glob("*.deb"):
                run("dpkg", "-x", package, Path(made) / "root")
            if not kept.exists():  # by another checkout, meanwhile
                (Path(made) / "root").rename(kept)
        return kept
    except FileNotFoundError as error:
        raise NotHere(f"not installed: {error.filename}") from error
    except subprocess.CalledProcessError as error:
        raise NotHere(f"{' '.join(packages)}: not on Debian's mirror: {error.stderr.strip()[-600:]}") from error


def unpacked():
    """The folder with Debian's smbd; it is kept. Raises NotHere where none can be had."""
    try:
        libraries = run("dpkg-query", "-W", "-f", "${Version}", "samba-libs")
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        raise NotHere("not installed: samba-libs") from error
    return unpack(f"samba-{libraries}", f"samba={libraries}", f"samba-common-bin={libraries}")


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


class ShareServer:
    """Serves a folder as the share `media` to the one who runs this, until close()."""

    def __init__(self, media, password):
        programs = unpacked()
        self.user, self.port = pwd.getpwuid(os.getuid()).pw_name, free_port()
        self.folder = Path(tempfile.mkdtemp(prefix="vitrine-smbd-"))
        settings = self.folder / "smb.conf"
        settings.write_text(self.settings(media))
        run(programs / "usr/bin/pdbedit", "-s", settings, "-a", "-t", "-u", self.user, input=f"{password}\n{password}\n")
        self.log = (self.folder / "smbd.log").open("w")
        self.smbd = subprocess.Popen([programs / "usr/sbin/smbd", "-F", "-s", settings, "--no-process-group"], stdin=subprocess.DEVNULL,
                                     stdout=self.log, stderr=subprocess.STDOUT)
        self.wait_until_listening()

    def settings(self, media):
        """The example's, for another folder, user and port, and with all that smbd writes in a folder of its own."""
        places = ("private dir", "lock directory", "state directory", "cache directory", "pid directory", "ncalrpc dir")
        own = [f"{place} = {self.folder / 'run'}" for place in places]
        (self.folder / "run").mkdir()
        own += [f"log file = {self.folder / 'log'}", f"passdb backend = tdbsam:{self.folder / 'passdb.tdb'}", "interfaces = 127.0.0.1", "bind interfaces only = yes"]
        lines = EXAMPLE.read_text().splitlines()
        changed = {"smb ports": self.port, "path": media, "valid users": self.user, "force user": None, "force group": None}
        for name, value in changed.items():
            at = next(i for i, line in enumerate(lines) if line.startswith(f"{name} ="))
            lines[at] = "" if value is None else f"{name} = {value}"
        lines[lines.index("[global]") + 1:lines.index("[global]") + 1] = own
        return "\n".join(lines) + "\n"

    def wait_until_listening(self):
        end = time.monotonic() + PATIENCE
        while True:
            try:
                return socket.create_connection(("127.0.0.1", self.port)).close()
            except OSError:
                if self.smbd.poll() is not None or time.monotonic() > end:
                    said = (self.folder / "smbd.log").read_text()
                    self.close()
                    raise AssertionError(f"smbd does not serve: {said}") from None
            time.sleep(0.1)

    def close(self):
        self.smbd.kill()
        self.smbd.wait()
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)

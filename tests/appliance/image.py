"""The rig's guest: a Debian with its own kernel, and what the programs need, as a disk.

Made by mmdebstrap from the host's Debian mirror and kept outside the source tree, under a name that says what it
was made of, so that it is made once a machine and not once a clone.
"""
import hashlib
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
SUITE = "bookworm"
PACKAGES = """systemd systemd-sysv udev dbus polkitd kmod procps zstd linux-image-amd64 initramfs-tools qemu-guest-agent bindfs
libegl1 libegl-mesa0 libgles2 libgl1-mesa-dri libgbm1 opencv-data
gstreamer1.0-plugins-base gstreamer1.0-plugins-good gstreamer1.0-plugins-bad gstreamer1.0-plugins-ugly gstreamer1.0-libav""".split()
DRIVERS_LEFT_OUT = "net media infiniband scsi staging iio hwmon isdn mtd nvme md ata firewire platform bluetooth crypto".split()
HOST_PROGRAMS = ("qemu-system-x86_64 qemu-img mmdebstrap mke2fs zstd dbus-daemon gdbus ffmpeg setpriv "
                 "apt-get apt-config dpkg-query readelf ldd").split()


MAX_AGE = 30  # days, then the guest is made anew: it has the packages of the day it was made


class NotHere(Exception):
    """The rig cannot be had on this machine; says why."""


def run(*command, **more):
    return subprocess.run([str(word) for word in command], check=True, text=True, capture_output=True, **more).stdout


def cache_directory():
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "vitrine" / "rig"


def check_host():
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    missing = [name for name in HOST_PROGRAMS if not shutil.which(name, path=path)]
    if os.uname().machine != "x86_64":
        raise NotHere(f"it emulates an x86_64 machine and this is {os.uname().machine}")
    if missing:
        raise NotHere(f"not installed: {', '.join(missing)} (see packaging/dependencies)")


def packages_of(programs):
    """The packages of the libraries that programs are linked to."""
    libraries = set()
    for program in programs:
        needed = set(re.findall(r"\(NEEDED\).*\[(.+)\]", run("readelf", "-d", program)))
        found = dict(re.findall(r"(\S+) => (/\S+)", run("ldd", program)))
        libraries |= {os.path.realpath(found[name]) for name in needed if name in found}
    owners = run("dpkg-query", "-S", *("*" + str(path).removeprefix("/usr") for path in sorted(libraries)))
    return sorted({line.split(":")[0] for line in owners.splitlines()})


def sources():
    """The mirror that this host installs from, as lines of a sources.list."""
    listed = run("apt-get", "indextargets", "--format", "$(SITE) $(CODENAME)", "Created-By: Packages", "Origin: Debian")
    lines = {f"deb {line} main" for line in listed.splitlines() if line.split()[1].startswith(SUITE)}
    if not lines:  # nothing was ever loaded from them
        named = re.findall(rf"'(\S+/debian(?:-security)?)/dists/({SUITE}[\w-]*)/InRelease'", run("apt-get", "update", "--print-uris"))
        lines = {f"deb {site} {suite} main" for site, suite in named}
    if not lines:
        raise NotHere(f"apt here knows no mirror of Debian {SUITE}")
    return "\n".join(sorted(lines))


def proxies():
    """How apt here reaches its mirror, as options of apt's; mmdebstrap does not read this host's settings."""
    said = run("apt-config", "dump", "--format", '%f "%v";%n', "Acquire::http::Proxy", "Acquire::https::Proxy")
    return [f"--aptopt={line.rstrip(';')}" for line in said.splitlines() if '""' not in line]


def key(*parts):
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]


def recipe(packages):
    """What mmdebstrap is told of the guest."""
    leaves = [f"path-exclude=/lib/modules/*/kernel/drivers/{name}/*" for name in DRIVERS_LEFT_OUT]
    leaves += [f"path-exclude=/usr/share/{name}/*" for name in ("man", "doc", "locale", "info")]
    leaves += ["path-exclude=/lib/modules/*/kernel/sound/*", "force-unsafe-io"]
    return ["--variant=minbase", '--aptopt=APT::Install-Recommends "false"', *(f"--dpkgopt={one}" for one in leaves),
            f"--include={','.join(packages)}", SUITE]


def build(packages, out):
    hook = HERE / "guest.sh"
    run("mmdebstrap", "--format=null", f'--essential-hook={hook} early "$1"', f'--customize-hook={hook} late "$1" {out}',
        *recipe(packages), *proxies(), "-", "-", input=sources())


def ensure(programs):
    """The directory with vmlinuz, initrd, kernel-release and base.raw for these programs.

    Raises NotHere where neither a kept one nor the mirror is there.
    """
    check_host()
    try:
        return made_for(PACKAGES + packages_of(programs))
    except subprocess.CalledProcessError as error:
        raise NotHere(f"no image of Debian's mirror: {error.cmd[0]}: {error.stderr[-1500:]}") from error
    except OSError as error:
        raise NotHere(f"no image of Debian's mirror: {error}") from error


def age_in_days(image):
    return (time.time() - (image / "base.raw").stat().st_mtime) / 86400


def made_for(packages):
    """The directory of the image with these packages. It is made where none is kept, and where the newest one is old."""
    name = key(recipe(packages), (HERE / "guest.sh").read_text())
    images = sorted((one for one in cache_directory().glob(f"{name}*") if (one / "base.raw").exists()), key=age_in_days)
    if images and age_in_days(images[0]) <= MAX_AGE:
        return images[0]
    try:
        made = make(packages, cache_directory() / f"{name}-{time.strftime('%Y%m%d')}")
    except (OSError, subprocess.CalledProcessError):
        if not images:
            raise
        print(f"{images[0]} is {age_in_days(images[0]):.0f} days old, but no newer one can be made", flush=True)
        return images[0]
    for image in images:
        if age_in_days(image) > 2 * MAX_AGE:  # no machine of another checkout runs from it any more
            shutil.rmtree(image, ignore_errors=True)
    return made


def make(packages, kept):
    """Makes an image as the directory `kept`; that."""
    kept.parent.mkdir(parents=True, exist_ok=True)
    made = Path(tempfile.mkdtemp(dir=kept.parent, prefix="making-"))
    made.chmod(0o777)
    print(f"making {kept} of Debian's mirror: some minutes, once", flush=True)
    try:
        build(packages, made)
        made.chmod(0o755)
        if not (kept / "base.raw").exists():  # by another checkout, meanwhile
            made.rename(kept)
    finally:
        shutil.rmtree(made, ignore_errors=True)
    return kept

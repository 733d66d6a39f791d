"""The packages in the machine: installing starts nothing, an upgrade keeps settings and the show, purging leaves only media."""
import os
import shutil
from pathlib import Path

from appliance import EDITABLE, FILM, MEDIA, STILLS
from image import NotHere
from machine import wait_for

DPKG = "DEBIAN_FRONTEND=noninteractive dpkg --force-depends"  # the rig has the libraries, not all that is wished for
DEBS = "/host/packages/*.deb"
UNITS = "vitrine-analyzer vitrine-player vitrine.target"


def carry(box):
    """Puts what packaging.packages has built where the machine can read it."""
    built = [file for file in Path(os.environ["VITRINE_PACKAGES"]).glob("vitrine*.deb") if "dbgsym" not in file.name]
    if not built:
        raise NotHere("no packages were built")
    (box.machine.share / "packages").mkdir()
    for file in built:
        shutil.copy(file, box.machine.share / "packages")
    box.machine.mount_share()


def run(box):
    # A machine without Vitrine, but with media, and with records of them, which saves an emulated machine minutes.
    box.sh(f"systemctl kill -s KILL {UNITS}; systemctl stop {UNITS}; rm -rf /etc/vitrine /usr/bin/vitrine-* /usr/lib/systemd/system/vitrine* "
           "/usr/lib/sysusers.d/vitrine.conf /usr/lib/tmpfiles.d/vitrine.conf /usr/share/doc/vitrine; systemctl daemon-reload; systemctl reset-failed", fails=True)
    carry(box)

    box.sh(f"{DPKG} -i {DEBS} </dev/null")
    states = box.sh(f"systemctl is-active {UNITS}; systemctl is-enabled {UNITS}", fails=True).split()
    assert set(states) == {"inactive", "disabled"}, f"installing has started or enabled something: {states}"

    box.set()
    box.sh("systemctl enable --now --quiet vitrine.target")
    box.wait_for_wall("the wall of the packages")
    settings, pid = box.sh(f"cat {EDITABLE}"), box.pid()

    box.sh(f"{DPKG} -i {DEBS} </dev/null")
    assert box.sh(f"cat {EDITABLE}") == settings, "the upgrade has changed the settings"
    wait_for("the upgraded player", lambda: box.sh("systemctl show -p MainPID --value vitrine-player") not in ("0", str(pid)))
    box.wait_for_wall("the wall after the upgrade")

    box.sh(f"{DPKG} --purge vitrine vitrine-player vitrine-analyzer")
    assert box.sh("pgrep '^vitrine-' || echo none") == "none", "something still runs"
    left = box.sh("find / -xdev -iname '*vitrine*' -not -path '/proc/*' -not -path '/run/*' -not -path '/tmp/*' -not -path '/var/tmp/*'").split()
    assert left == ["/srv/vitrine"], f"purging leaves {left}"
    media = set(box.sh(f"ls {MEDIA}").split())
    assert media == {f"{name}.png" for name in STILLS} | {f"{name}.mp4" for name in FILM}, f"the media are the operators', the answer is not: {media}"
    assert box.sh("getent passwd vitrine"), "the user went before its files"

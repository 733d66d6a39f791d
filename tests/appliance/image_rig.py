#!/usr/bin/env python3
"""The appliance's own disk in the rig: built, booted by its firmware and its loader, filled through its share, and cut off.

    image_rig.py make PACKAGES WORK   builds the disk of Debian's and Vitrine's packages
    image_rig.py first_boot WORK      what the first boot does; leaves a running appliance as a snapshot
    image_rig.py uefi WORK            a new disk booted by UEFI's firmware instead of the BIOS
    image_rig.py share WORK           uploads by smbclient: at once, slowly, cut off, over what is there
    image_rig.py power_cut WORK       kills the machine while files arrive, VITRINE_RIG_CUTS times (2)

Ends with 77 where the machine cannot be had here, saying why. docs/testing.md says what is asked.
"""
import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[1] / "share"))
import appliance
import power
from appliance import MEDIA, toml
from disk_machine import DiskMachine
from image import NotHere, check_host, key, run
from machine import wait_for
from rig import SNAPSHOT, guarded, skip, told
from share_client import ShareClient, enlarge

DISK_SIZE = "6G"
PASSWORD = "correct horse"
BOOT_AT = "@@2M"  # the boot partition in the disk, for mtools
SETUP = "/run/setup"
FIRMWARE = [Path("/usr/share/ovmf/OVMF.fd"), Path("/usr/share/OVMF/OVMF_CODE.fd")]
BUILDER = Path(__file__).resolve().parents[2] / "packaging/build-image"


def made_from(packages):
    """What decides how the disk is, Debian's packages apart."""
    files = [BUILDER, *BUILDER.with_name("image").rglob("*"), *packages.glob("vitrine*.deb")]
    return sorted(file for file in files if file.is_file() and "dbgsym" not in file.name)


def make(packages, work):
    check_host()
    missing = [name for name in ("mkfs.fat", "mcopy", "sfdisk", "smbclient")
               if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")]
    if missing:
        raise NotHere(f"not installed: {', '.join(missing)} (see packaging/dependencies)")
    made_of = key([(file.name, file.read_bytes()) for file in made_from(packages)], appliance.SETTINGS)
    if (work / "made-of").exists() and (work / "made-of").read_text() == made_of:
        print(f"{work / 'appliance.img'} is there, made of the same")
        return
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    begin = time.monotonic()
    lists = sorted(os.listdir("/var/lib/apt/lists"))
    # The guest's agent is how the rig looks into it; the console is for whoever looks for what went wrong.
    done = subprocess.run([BUILDER, "--packages", packages, "--include", "qemu-guest-agent", "--append", "console=ttyS0",
                           work / "appliance.img"], text=True, capture_output=True)
    if done.returncode != 0:
        raise AssertionError(f"no image: {done.stdout}{done.stderr}")
    assert sorted(os.listdir("/var/lib/apt/lists")) == lists, "building has emptied what apt knows on this machine"
    settings = work / "vitrine.toml"
    settings.write_text(toml(appliance.SETTINGS))
    run("mcopy", "-o", "-i", f"{work / 'appliance.img'}{BOOT_AT}", settings, "::/vitrine.toml")
    print(done.stdout, end="")
    (work / "made-of").write_text(made_of)
    told("image", begin)


def leave(box, name, text):
    """A file on the boot partition, as a technician would leave it with another computer."""
    box.sh(f"mkdir -p {SETUP}; mount /dev/disk/by-partlabel/vitrine-boot {SETUP}; printf '%s' '{text}' >{SETUP}/{name}; umount {SETUP}")


def seconds_of(box, unit, what="ActiveEnterTimestampMonotonic"):
    return int(box.sh(f"systemctl show -p {what} --value {unit}")) / 1e6


def check_system(box):
    """Read only, with a data partition, and with nothing open."""
    assert "ro" in box.sh("findmnt -n -o OPTIONS /").split(","), "the root can be written"
    assert box.sh("touch /usr/x 2>&1 || echo refused").endswith("refused")
    for place in (MEDIA, "/var/lib/vitrine", "/etc/vitrine", "/var/lib/samba"):
        assert box.sh(f"findmnt -n -o SOURCE {place}").startswith("/dev/vda4["), f"{place} is not on the data partition"
    mebibytes = int(box.sh("findmnt -n -b -o SIZE /data")) >> 20
    assert mebibytes > 2000, f"the data partition has {mebibytes} MiB of a disk of {DISK_SIZE}"
    listening = box.sh("cat /proc/net/tcp /proc/net/tcp6 | awk '$4 == \"0A\" {print $2}'")
    assert not listening, f"a port is open: {listening}"
    failed = box.sh("systemctl --failed --no-legend --plain | cut -d' ' -f1")
    assert not failed, f"failed: {failed}"
    assert box.sh("systemctl is-active getty@tty1 || true") == "inactive"
    assert box.sh("test -e /usr/sbin/policy-rc.d && echo there", fails=True) == "", "an upgraded package would not restart its service"
    assert box.sh("passwd -S root").split()[1] == "L", "root has a password"


def new_disk(work, name):
    """One that has never been booted."""
    disk = work / f"{name}.qcow2"
    disk.unlink(missing_ok=True)
    run("qemu-img", "create", "-q", "-f", "qcow2", "-F", "raw", "-b", work / "appliance.img", disk, DISK_SIZE)
    return disk


def first_boot(work):
    """The snapshot has a share with a password and a wall of all files; nothing of it was there when the disk was new."""
    disk = new_disk(work, "running")

    def look(box):
        box.wait_until_active("vitrine-player")
        box.wait_for_word("first picture on")
        box.look("nothing to show")
        check_system(box)
        leave(box, "share-password.txt", PASSWORD)
        box.reboot()

        for daemon in ("smbd", "avahi-daemon", "wsdd"):
            box.wait_until_active(daemon)
        check_password_is_taken(box)
        client = ShareClient(box.machine.share_port, PASSWORD)
        fill(box, client)
        box.wait_for_wall("the wall of the share", size=(640, 360))
        box.reboot()
        tell_boot(box)
        box.machine.save(SNAPSHOT)

    guarded(DiskMachine(disk), work / "first_boot", look)


def uefi(work):
    firmware = next((file for file in FIRMWARE if file.exists()), None)
    if not firmware:
        raise NotHere("not installed: ovmf")
    disk = new_disk(work, "uefi")

    def look(box):
        assert box.sh("test -d /sys/firmware/efi && echo yes", fails=True) == "yes", "it was not booted by UEFI"
        box.wait_until_active("vitrine-player")
        box.wait_for_word("first picture on")
        box.look("booted by UEFI")

    try:
        guarded(DiskMachine(disk, firmware=firmware), work / "uefi", look)
    finally:
        disk.unlink()


def check_password_is_taken(box):
    assert "share-password.txt" not in box.sh(f"mkdir -p {SETUP}; mount -o ro /dev/disk/by-partlabel/vitrine-boot {SETUP}; ls {SETUP}; umount {SETUP}")
    port = box.machine.share_port
    assert ShareClient(port, PASSWORD).is_refused(guest=True), "guests are let in"
    assert ShareClient(port, "wrong").is_refused(), "any password is let in"


def fill(box, client):
    folder = box.machine.share / "media"
    folder.mkdir(exist_ok=True)
    appliance.draw_media(folder)
    for file in sorted(folder.iterdir()):
        client.put(file)


def tell_boot(box):
    """The time to the first picture of the wall, as a ratio to that of the system."""
    box.wait_for_wall("the wall after a boot", size=(640, 360))
    box.wait_until_active("multi-user.target")
    picture = next(at for at, line in box.journal() if "first picture on" in line)
    system = seconds_of(box, "multi-user.target")
    print(f"boot: first picture after {picture:.1f} s, multi-user.target after {system:.1f} s: a ratio of {picture / system:.2f}")


def share(work):
    disk = work / "share.qcow2"
    shutil.copy(work / "running.qcow2", disk)

    def look(box):
        client = ShareClient(box.machine.share_port, PASSWORD)
        box.wait_for_wall("the wall", size=(640, 360))
        slow(box, client, work)
        aborted(box, client, work)
        overwritten(box, client, work)

    try:
        guarded(DiskMachine(disk, SNAPSHOT), work / "share", look)
    finally:
        disk.unlink()


def large(folder, name, colour):
    """A photo of one colour that comes in several parts."""
    file = folder / name
    run("ffmpeg", "-v", "error", "-y", "-f", "lavfi", "-i",
        f"color=0x{bytes(colour).hex()}:size=640x360,drawbox=240:100:160:160:white:fill", "-frames:v", 1, file)
    enlarge(file)
    return file


def shows(box, colour):
    return box.machine.picture().share_of(colour) > appliance.MIN_SHARE


ORANGE, TEAL, OLIVE = (255, 120, 0), (0, 110, 110), (110, 110, 0)


def slow(box, client, work):
    file = large(work, "slow.png", ORANGE)

    def unseen():
        assert not shows(box, ORANGE), "a part of a file is on the wall"
        assert "slow.png" not in ready_files(box), "a part of a file is said to be ready"

    client.put_slowly(file, file.stat().st_size // 20, unseen)
    wait_for("the file that came slowly", lambda: shows(box, ORANGE))
    box.look("a file that came slowly")


def aborted(box, client, work):
    file = large(work, "aborted.png", TEAL)
    client.put_and_die(file, file.stat().st_size // 20, lambda: int(box.sh(f"stat -c %s {MEDIA}/aborted.png 2>/dev/null || echo 0")))
    size = int(box.sh(f"stat -c %s {MEDIA}/aborted.png"))
    assert 0 < size < file.stat().st_size, f"{size} bytes came of {file.stat().st_size}"
    box.sh("sleep 30")  # quiet, and looked at more than once
    assert not shows(box, TEAL), "a part of a file is on the wall"
    assert "aborted.png" not in ready_files(box)
    box.look("without a file that was cut off")
    client.put(file)
    wait_for("the file that was cut off, sent anew", lambda: shows(box, TEAL))


def overwritten(box, client, work):
    client.put(large(work, "other.png", OLIVE), "slow.png")
    wait_for("what the file was replaced with", lambda: shows(box, OLIVE) and not shows(box, ORANGE))
    box.look("a file that was replaced")


def ready_files(box):
    return power.records(box, "ready")


def power_cut(work):
    cuts, seed = int(os.environ.get("VITRINE_RIG_CUTS", 2)), int(os.environ.get("VITRINE_RIG_SEED", time.time()))
    print(f"{cuts} cuts, VITRINE_RIG_SEED={seed}")
    for number in range(cuts):
        disk = work / "cut.qcow2"
        shutil.copy(work / "running.qcow2", disk)
        begin = time.monotonic()
        try:
            power.cut_once(disk, SNAPSHOT, random.Random(seed + number), work / f"cut-{number}", guarded)
        finally:
            disk.unlink()
        told(f"cut {number}", begin)


def main():
    try:
        if sys.argv[1] == "make":
            make(Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve())
            return
        work = Path(sys.argv[2]).resolve()
        if not (work / "appliance.img").exists():
            skip("no image was built")
        {"first_boot": first_boot, "uefi": uefi, "share": share, "power_cut": power_cut}[sys.argv[1]](work)
    except NotHere as why:
        skip(why)


main()

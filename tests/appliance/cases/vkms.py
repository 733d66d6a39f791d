"""A second card that flips at 60 Hz: it is played on when it is named, never more than one flip a refresh, all on the refreshes."""
import re
import shutil

import vkms

PERIOD = 1 / 60  # s
TRACE = "/sys/kernel/tracing"


def refreshes(box):
    """Of the flips in some seconds: the number of the refresh that each was on."""
    box.sh(f"cd {TRACE}; echo >trace; echo 1 >events/drm/drm_vblank_event_delivered/enable; sleep 12; "
           "echo 0 >events/drm/drm_vblank_event_delivered/enable")
    lines = box.sh(f"cat {TRACE}/trace | grep drm_vblank_event_delivered", fails=True)
    return [int(number) for number in re.findall(r"seq=(\d+)", lines)]


def period(box):
    """Between refreshes, in seconds, as the card's own time stamps have it."""
    box.sh(f"cd {TRACE}; echo >trace; echo 1 >events/drm/drm_vblank_event/enable; sleep 3; echo 0 >events/drm/drm_vblank_event/enable")
    lines = box.sh(f"cat {TRACE}/trace | grep drm_vblank_event:")
    found = [(int(number), int(time)) for number, time in re.findall(r"seq=(\d+), time=(\d+)", lines)]
    (first, begin), (last, end) = found[0], found[-1]
    return (end - begin) / (last - first) / 1e9


def run(box):
    shutil.copy(vkms.ensure(box.machine.image), box.machine.share / "vkms.ko")
    box.machine.mount_share()
    box.sh("insmod /host/vkms.ko; umount /host; udevadm settle; ls /dev/dri/card1")

    box.restart(output__screen="kms:/dev/dri/card1", output__frame_rate=60, output__mode="640x480")
    box.wait_for_word("first picture on Virtual-")
    box.wait_for_word("wall of")

    flips = refreshes(box)
    seconds = period(box)
    print(f"{len(flips)} flips in 12 s, on refreshes {seconds * 1000:.2f} ms apart")
    assert len(flips) > 5, "it is played"
    assert abs(seconds - PERIOD) < PERIOD / 20, "the card's own refresh"
    assert all(a < b for a, b in zip(flips, flips[1:])), "at most one flip a refresh"

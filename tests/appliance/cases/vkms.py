"""A second card that flips at 60 Hz: it is played on when it is named, never more than one flip a refresh, all on the refreshes."""
import re
import shutil

import vkms
from machine import wait_for

PERIOD = 1 / 60  # s
FLIPS = 10
TRACE = "/sys/kernel/tracing"


def refreshes(trace):
    """{number: time in s} of the card's refreshes, by its own time stamps."""
    return {int(number): int(time) / 1e9 for number, time in re.findall(r"drm_vblank_event:.* seq=(\d+), time=(\d+)", trace)}


def flips(trace):
    """The number of the refresh that each flip was on."""
    return [int(number) for number in re.findall(r"drm_vblank_event_delivered:.* seq=(\d+)", trace)]


def traced(box):
    """The kernel's trace of the card, once there are enough flips in it."""
    box.sh(f"cd {TRACE}; for event in drm_vblank_event drm_vblank_event_delivered; do echo 1 >events/drm/$event/enable; done")
    read = lambda: box.sh(f"grep -h drm_vblank_event {TRACE}/trace", fails=True)
    return wait_for(f"{FLIPS} flips", lambda: (trace := read()) and len(flips(trace)) >= FLIPS and trace, pause=2)


def run(box):
    shutil.copy(vkms.ensure(box.machine.image), box.machine.share / "vkms.ko")
    box.machine.mount_share()
    box.sh("insmod /host/vkms.ko; umount /host; udevadm settle; ls /dev/dri/card1")

    begin = box.now()
    box.restart(output__screen="kms:/dev/dri/card1", output__frame_rate=60, output__mode="640x480")
    box.wait_for_word("first picture on Virtual-", begin)
    trace = traced(box)

    on, times = flips(trace), refreshes(trace)
    seconds = (max(times.values()) - min(times.values())) / (max(times) - min(times))
    print(f"{len(on)} flips, on refreshes {seconds * 1000:.2f} ms apart")
    assert abs(seconds - PERIOD) < PERIOD / 20, "the card's own refresh"
    assert all(a < b for a, b in zip(on, on[1:])), "at most one flip a refresh"

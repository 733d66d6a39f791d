"""The settings of outputs, one after the other in one machine: a second panel, rotation, margins, the legacy calls, modes,
folders. VITRINE_RIG_STEPS="rotation mode" runs these steps alone; VITRINE_RIG_ROTATIONS=3 turns the panel by every right angle.
"""
import os
import random
import time

from appliance import MEDIA
from machine import wait_for

LEFT, TOP, RIGHT, BOTTOM = 48, 27, 16, 9  # px of margin; the rest has the panel's shape
UP = {0: (0, -1), 90: (-1, 0), 180: (0, 1), 270: (1, 0)}  # the panel's own edge that is up once it is hung turned clockwise
ROTATIONS = int(os.environ.get("VITRINE_RIG_ROTATIONS", 1))
FOLDERS = {"hall": ["blue.png", "magenta.mp4"], "lobby": ["red.png", "green.png"]}


def second_panel(box):
    """A second panel comes: it shows the wall too, in its own mode, and the first goes on; then each goes without the other."""
    pid = box.pid()

    box.panel(512, 288, head=1)
    box.wait_for_wall("the wall on the second panel", head=1, size=(512, 288))
    box.wait_for_wall("the wall on the first still", size=(640, 360))
    box.wait_for_motion("the film to move on the second", head=1)
    box.wait_for_motion("the film to move on the first")

    begin = box.now()
    box.unplug()
    box.wait_for_word("panel gone from Virtual-1", begin)
    box.wait_for_motion("the film to move on the second alone", head=1)
    box.panel()
    box.wait_for_wall("the wall on the first again", size=(640, 360))

    begin = box.now()
    box.unplug(head=1)
    box.wait_for_word("panel gone from Virtual-2", begin)
    box.wait_for_motion("the film to move on the first alone")
    assert box.pid() == pid, "it is the same process"


def check_up(box, picture, degrees):
    (ux, uy), (lx, ly) = (picture.middle_of(colour) for colour in (box.UPPER, box.LOWER))
    right, down = ux - lx, uy - ly
    print(f"{degrees} degrees: the upper half is {right:.0f} px to the right of the lower one and {down:.0f} px down")
    x, y = UP[degrees]
    assert x * right + y * down > 5 * abs(y * right + x * down), "what is up in the picture"


def rotation(box):
    """A panel hung on its side: the wall fills the panel's own mode and is upright for who looks at it."""
    check_up(box, box.wait_for_wall("the wall as it is", size=(640, 360)), 0)
    for degrees in sorted(random.sample((90, 180, 270), ROTATIONS)):
        box.restart(output__rotation=degrees)
        check_up(box, box.wait_for_wall(f"the wall turned by {degrees} degrees", size=(640, 360)), degrees)


def margins(box):
    """A television set hides the edges: they are black, and the whole wall is within them."""
    box.restart(output__margins=f"{LEFT},{TOP},{RIGHT},{BOTTOM}")

    part = LEFT, TOP, 640 - RIGHT, 360 - BOTTOM
    picture = box.wait_for_wall("the wall within its margins", size=(640, 360), part=part)

    edges = {"left": (0, 0, LEFT, 360), "top": (0, 0, 640, TOP), "right": (640 - RIGHT, 0, 640, 360),
             "bottom": (0, 360 - BOTTOM, 640, 360)}
    for name, edge in edges.items():
        assert max(picture.part(*edge).pixels) == 0, f"something is to be seen at the {name}"


def legacy(box):
    """A driver without atomic requests: the wall, and another panel, through the older calls."""
    box.restart(output__api="legacy")
    pid = box.pid()

    box.wait_for_word(r"\(legacy\)", pid=pid)
    box.wait_for_wall("the wall by older calls", size=(640, 360))
    box.wait_for_motion("the film to move")
    box.pull()
    box.panel(560, 336)
    box.wait_for_wall("the wall on another panel", size=(560, 336))
    assert box.pid() == pid, "it is the same process"


def mode(box):
    """The operator asks for modes that panels do not prefer, for one of them and for all, and for one that a panel lacks."""
    box.panel(512, 384)  # all of one shape, as panels that show the same wall each show all of it
    box.panel(560, 420, head=1)
    box.restart(output__mode="Virtual-1=640x480")
    box.wait_for_wall("the wall in the mode asked for", size=(640, 480))
    box.wait_for_wall("the wall in the mode that the other panel prefers", head=1, size=(560, 420))

    box.restart(output__mode="1600x901, Virtual-2=640x480")
    box.wait_for_wall("the wall in the preferred mode for want of the one asked for", size=(512, 384))
    box.wait_for_wall("the wall in the mode asked of the other panel", head=1, size=(640, 480))


def folders(box):
    """Two panels, each with the wall of a folder of its own. It moves the media, so it comes last."""
    for folder, files in FOLDERS.items():
        box.sh(f"cd {MEDIA}; install -d -o vitrine -g vitrine {folder}; mv {' '.join(files)} {folder}")
    box.panel()
    box.panel(512, 288, head=1)
    box.restart(output__folders="Virtual-1=hall, Virtual-2=lobby")

    for head, (folder, files) in enumerate(FOLDERS.items()):
        names = {file.split(".")[0] for file in files}
        # Until its own first picture a panel shows what it showed before: the wall of all files.
        wait_for(f"the {folder} alone", lambda: box.files_in(box.machine.picture(head)) == names)
        box.wait_for_wall(f"the wall of the {folder}", head=head, files=names)
    box.wait_for_motion("the film to move in the hall")


STEPS = (second_panel, rotation, margins, legacy, mode, folders)


def run(box):
    wanted = os.environ.get("VITRINE_RIG_STEPS", "").split()
    if unknown := set(wanted) - {step.__name__ for step in STEPS}:
        raise AssertionError(f"there are no steps {', '.join(sorted(unknown))}")
    for step in STEPS:
        if not wanted or step.__name__ in wanted:
            begin = time.monotonic()
            step(box)
            print(f"{step.__name__}: {time.monotonic() - begin:.1f} s", flush=True)

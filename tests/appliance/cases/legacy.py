"""A driver without atomic requests: the wall, and another panel, through the calls of before."""


def run(box):
    box.restart(output__api="legacy")
    pid = box.pid()

    box.wait_for_word(r"\(legacy\)")
    box.wait_for_wall("the wall", size=(640, 360))
    box.wait_for_motion("the film to move")
    box.pull()
    box.panel(800, 480)
    box.wait_for_wall("the wall on another panel", size=(800, 480))
    assert box.pid() == pid, "it is the same process"

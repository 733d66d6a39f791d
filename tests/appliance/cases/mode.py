"""The operator asks for modes that panels do not prefer, of one of them and of all, and for one that a panel does not have."""


def run(box):
    box.panel(800, 450, head=1)
    box.restart(output__mode="Virtual-1=1024x768")
    box.wait_for_wall("the wall in the mode asked for", size=(1024, 768))
    box.wait_for_wall("the wall in the mode that the other panel prefers", head=1, size=(800, 450))

    box.restart(output__mode="1600x901, Virtual-2=640x480")
    box.wait_for_wall("the wall in the preferred mode for want of the one asked for", size=(640, 360))
    box.wait_for_wall("the wall in the mode asked of the other panel", head=1, size=(640, 480))

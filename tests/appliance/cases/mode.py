"""The operator asks for a mode that the panel does not prefer, and for one that it does not have."""


def run(box):
    box.restart(output__mode="1024x768")
    box.wait_for_wall("the wall in the mode asked for", size=(1024, 768))

    box.restart(output__mode="1600x901")
    box.wait_for_wall("the wall in the preferred mode for want of the one asked for", size=(640, 360))

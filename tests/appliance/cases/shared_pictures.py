"""What a decoder leaves in memory of the card is drawn from there, and looks as if it had been uploaded."""


def run(box):
    print(box.run_test("shared_pictures", "/dev/dri/card0"))

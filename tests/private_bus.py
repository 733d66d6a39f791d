"""A D-Bus daemon of a test's own."""
import subprocess


def start_bus(socket, before=(), **options):
    """Starts a bus at the path SOCKET and returns its process once it takes connections; it writes its address then.

    before: words of the command before dbus-daemon. options: subprocess.Popen's.
    """
    bus = subprocess.Popen([*before, "dbus-daemon", "--session", "--nofork", "--nopidfile", "--print-address", f"--address=unix:path={socket}"],
                           stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, **options)
    with bus.stdout as output:
        if not output.readline():
            raise RuntimeError(f"dbus-daemon ended with {bus.wait()}")
    return bus

"""Files into a share by a real smbclient, at once, slowly or cut off in the midst."""
import random
import socket
import struct
import subprocess
import threading
import time
import zlib

CHUNK = 4 << 20  # bytes
END_OF_PNG = 12  # bytes of its last chunk


def enlarge(file):
    """Makes a PNG three times as large as what a client of SMB writes at once, with chunks that nobody reads."""
    png, name_and_data = file.read_bytes(), b"viTr" + random.randbytes(CHUNK)
    chunk = struct.pack(">I", CHUNK) + name_and_data + struct.pack(">I", zlib.crc32(name_and_data))
    file.write_bytes(png[:-END_OF_PNG] + 6 * chunk + png[-END_OF_PNG:])


class Throttle:
    """A port that hands on to another, so many bytes a second towards it, until it is closed."""

    def __init__(self, port, bytes_per_second):
        self.port_behind, self.rate = port, bytes_per_second
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.sockets = [self.listener]
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        try:
            while True:
                near, _ = self.listener.accept()
                far = socket.create_connection(("127.0.0.1", self.port_behind))
                self.sockets += [near, far]
                for pair in ((near, far, self.rate), (far, near, None)):
                    threading.Thread(target=self.pump, args=pair, daemon=True).start()
        except OSError:
            pass  # closed

    @staticmethod
    def pump(source, target, rate):
        step = 65536 if rate is None else max(1, rate // 10)
        try:
            while data := source.recv(step):
                target.sendall(data)
                if rate is not None:
                    time.sleep(len(data) / rate)
            target.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # closed, or the client was killed

    def close(self):
        for one in self.sockets:
            one.close()


class ShareClient:
    def __init__(self, port, password, user="vitrine"):
        self.port, self.password, self.user = port, password, user

    def command(self, words, port=None, guest=False):
        who = ["-N"] if guest else ["-U", f"{self.user}%{self.password}"]
        return ["smbclient", "//127.0.0.1/media", "-p", str(port or self.port), *who, "-m", "SMB3", "-t", "300", "-c", words]

    def say(self, words):
        return subprocess.run(self.command(words), check=True, text=True, capture_output=True).stdout

    def put(self, file, name=None):
        self.say(f'put "{file}" "{name or file.name}"')

    def is_refused(self, **how):
        return subprocess.run(self.command("ls", **how), capture_output=True).returncode != 0

    def put_slowly(self, file, bytes_per_second, meanwhile, name=None):
        """Calls meanwhile() again and again until it is there."""
        throttle = Throttle(self.port, bytes_per_second)
        client = subprocess.Popen(self.command(f'put "{file}" "{name or file.name}"', throttle.port), stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            while client.poll() is None:
                meanwhile()
            assert client.returncode == 0, client.stdout.read().decode()
        finally:
            client.kill()
            client.communicate()
            throttle.close()

    def put_and_die(self, file, bytes_per_second, bytes_there):
        """Killed once the share has so many bytes; bytes_there() says how many."""
        throttle = Throttle(self.port, bytes_per_second)
        client = subprocess.Popen(self.command(f'put "{file}" "{file.name}"', throttle.port), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            half = file.stat().st_size // 2
            while bytes_there() < half:
                assert client.poll() is None, "it was faster than it should be"
                time.sleep(0.3)
        finally:
            client.kill()
            client.wait()
            throttle.close()

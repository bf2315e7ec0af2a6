"""Stopping a run: by its progress, by a token, by Ctrl-C."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import loosefit
from cases import SOURCE, tank_top

# A shirt fine enough to take many seconds; it tells when it begins to settle, and what it raised.
LONG_RUN = """
import sys, loosefit
shirt = {"simulation": {"edge_length": 0.012}, "body": {"posture": "a-pose"}}
told = set()
def tell(stage, fraction):
    if stage not in told:
        told.add(stage)
        print(stage, flush=True)
try:
    loosefit.run(shirt, out=sys.argv[1], progress=tell)
except BaseException as error:
    print(type(error).__name__, flush=True)
"""


class Cancelling(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def nothing_left(self):
        self.assertEqual(list(self.root.iterdir()), [])

    def test_progress_that_returns_false(self):
        def until_dress(stage, fraction):
            return stage != "dress"

        with self.assertRaises(loosefit.Cancelled):
            loosefit.run(tank_top(), out=self.root / "out", progress=until_dress)
        self.nothing_left()

    def test_progress_that_raises(self):
        def broken(stage, fraction):
            raise ZeroDivisionError(stage)

        with self.assertRaises(ZeroDivisionError):
            loosefit.run(tank_top(), out=self.root / "out", progress=broken)
        self.nothing_left()

    def test_progress_comes_from_the_calling_thread(self):
        threads = set()
        with self.assertRaises(loosefit.Cancelled):
            loosefit.run(tank_top(), progress=lambda stage, _: threads.add(
                threading.get_ident()) or stage != "settle")
        self.assertEqual(threads, {threading.get_ident()})

    def test_token_from_another_thread(self):
        token = loosefit.CancelToken()
        raised = []

        def run():
            try:
                loosefit.run({"simulation": {"edge_length": 0.012}}, out=self.root / "out",
                             cancel=token)
            except loosefit.Cancelled as error:
                raised.append(error)

        thread = threading.Thread(target=run)
        thread.start()
        time.sleep(1)  # the GIL is free meanwhile, or this would not come back
        self.assertFalse(token.cancelled)
        token.cancel()
        thread.join(60)
        self.assertFalse(thread.is_alive())
        self.assertEqual(len(raised), 1)
        self.nothing_left()

    def test_interrupt(self):
        """Ctrl-C, as a terminal or a notebook sends it."""
        process = subprocess.Popen([sys.executable, "-c", LONG_RUN, self.root / "out"],
                                   stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        for line in process.stdout:
            if line.strip() == "settle":
                break
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        sent = time.monotonic()
        self.assertEqual(process.stdout.read().split()[-1:], ["KeyboardInterrupt"])
        took = time.monotonic() - sent
        process.wait()
        print(f"interrupted after {took:.2f} s")
        self.assertLess(took, 20)  # a second on a machine that is not busy with other tests
        self.nothing_left()


class Memory(unittest.TestCase):
    def test_ten_runs_do_not_grow(self):
        """Of results that are let go, nothing stays."""
        code = """
import ctypes, gc, loosefit, numpy, os, re, tempfile
from cases import unsettled
libc = ctypes.CDLL(None, use_errno=True)
libc.fdopen.restype = ctypes.c_void_p
libc.malloc_info.argtypes = [ctypes.c_int, ctypes.c_void_p]
libc.fclose.argtypes = [ctypes.c_void_p]
def in_use():
    # Bytes asked for and not given back, over all arenas: what the allocator keeps for later, which
    # depends on how threads met, is not counted.
    with tempfile.TemporaryFile() as file:
        stream = libc.fdopen(os.dup(file.fileno()), b"w")
        assert libc.malloc_info(0, stream) == 0
        libc.fclose(stream)
        file.seek(0)
        whole = file.read().decode().rsplit("</heap>", 1)[1]
    def size(pattern):
        return int(re.search(pattern + r'.* size="(\\d+)"', whole).group(1))
    return (size('system type="current"') - size('total type="fast"') - size('total type="rest"')
            + size('total type="mmap"')) / 1e6
after = []
for _ in range(10):
    result = loosefit.run(unsettled(), allow_unsettled=True)
    assert numpy.isfinite(result.vertices).all() and len(result.maps) > 3
    result.normals, result.body.normals, result.summary, result.sites
    held = in_use()
    del result
    gc.collect()
    after.append(in_use())
print(after[2], after[9], held - after[9])
"""
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                              cwd=SOURCE / "tests" / "python", env=dict(os.environ))
        self.assertEqual(done.returncode, 0, done.stderr)
        third, tenth, one = map(float, done.stdout.split())
        print(f"in use after run 3: {third:.1f} MB, after run 10: {tenth:.1f} MB; "
              f"held by one result: {one:.1f} MB")
        self.assertGreater(one, 5)  # or a leak of it would not be seen
        self.assertLess(tenth, third + 0.5 * one)  # seven that leak would be 7 times one


if __name__ == "__main__":
    unittest.main()

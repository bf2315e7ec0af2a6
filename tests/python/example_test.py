"""The example makes its figure."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image
import numpy as np

from cases import SOURCE


class Notebook(unittest.TestCase):
    def test_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "figure.png"
            done = subprocess.run(
                [sys.executable, SOURCE / "examples" / "notebook_reference_shirt.py", "--output",
                 picture, "--edge-length", "0.04"],
                capture_output=True, text=True, env={**os.environ, "MPLBACKEND": "Agg"})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("settled and worn", done.stdout)
            self.assertIn("deg off the body", done.stdout)
            pixels = matplotlib.image.imread(picture)[..., :3]
        self.assertGreater(min(pixels.shape[:2]), 800)
        # Six shirts in colours, in two rows and three columns; those of small strains are pale.
        saturation = pixels.max(axis=2) - pixels.min(axis=2)
        for row in np.array_split(saturation[:int(0.88 * len(saturation))], 2, axis=0):
            for cell in np.array_split(row, 3, axis=1):
                self.assertGreater((cell > 0.05).mean(), 0.03)


if __name__ == "__main__":
    unittest.main()

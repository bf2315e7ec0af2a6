"""The cases whose drapes are frozen: name and scenario text. `{body}` is a mesh of the woman."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from bench_cases import BODIES, REFERENCE_FIT, all_fits, scenario  # noqa: E402

WOMAN = BODIES["woman"]
TEE = "pattern = \"t-shirt\"\nfit = { chest = 0.12, hip = 0.10, sleeve = 0.15 }"
UNDER = """[[under]]
pattern = "t-shirt"
fit = { chest = 0.05, hip = 0.05, sleeve = 0.12 }
friction = 0.3
[under.material]
name = "cotton-jersey"
"""
BOARD = """[[site]]
name = "back box"
landmark = "upper_back"
footprint = { size = [0.05, 0.03] }
board = { mass = 0.030 }
[[site]]
name = "chest"
landmark = "sternum"
"""
POSTURES = """[postures]
list = ["standing", "arms-forward", "forward-bend-30", "sitting"]
[ranking]
modality = "imu-inclination"
"""
DONNINGS = "[donning]\nrepeats = 3\nshift = 0.010\ntwist_deg = 10\n"
OTHER_STARTS = 2


def cases():
    """Name and scenario text of each."""
    scan = scenario(REFERENCE_FIT, edge_mm=14.0)
    start = scan.index("[garment]")
    scan = '[body]\nfile = "{body}"\nunits = "m"\nup = "z"\n' + scan[start:]
    return {
        "reference-10mm": scenario(REFERENCE_FIT, edge_mm=10.0),
        "loose-14mm": scenario(all_fits(0.35), edge_mm=14.0),
        "tight-knit-14mm": scenario(all_fits(-0.05), edge_mm=14.0, material="compression-knit"),
        "child-heavy-14mm": scenario(all_fits(0.15), body="child-heavy", edge_mm=14.0),
        "child-slim-tee-14mm": scenario(TEE, body="child-slim", edge_mm=14.0,
                                        material="cotton-jersey"),
        "size-142-child-14mm": scenario('size = "child-142"', body="child-slim", edge_mm=14.0),
        "man-stiff-14mm": scenario(REFERENCE_FIT, body="man", edge_mm=14.0, material="denim"),
        "limp-14mm": scenario(REFERENCE_FIT, edge_mm=14.0, material="silk"),
        "curves-14mm": scenario(REFERENCE_FIT, edge_mm=14.0, material="wool-measured"),
        "layers-16mm": scenario(all_fits(0.20), edge_mm=16.0, extra=UNDER),
        "scan-14mm": scan,
        "pattern-file-14mm": scenario('pattern = "{patterns}/long-sleeve-shirt-women-38.json"',
                                      edge_mm=14.0),
        "board-14mm": scenario(REFERENCE_FIT, edge_mm=14.0, extra=BOARD),
        "postures-20mm": scenario(REFERENCE_FIT, edge_mm=20.0, posture="", extra=POSTURES),
        "donnings-20mm": scenario(REFERENCE_FIT, edge_mm=20.0, extra=DONNINGS),
        "repeats-20mm": scenario(REFERENCE_FIT, edge_mm=20.0)
        .replace("threads = 0", f"threads = 0\nrepeats = {OTHER_STARTS}"),
    }

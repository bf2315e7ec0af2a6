"""Small cases that several tests share."""
import os
import pathlib
import subprocess

SOURCE = pathlib.Path(os.environ["LOOSEFIT_SOURCE_DIR"])
BINARY = os.environ["LOOSEFIT_BINARY"]


def tank_top(**simulation):
    """A tank top of 50 mm edges on a woman with her arms apart: two seconds of one core."""
    return {
        "body": {"posture": "a-pose"},
        "garment": {"pattern": "tank-top"},
        "simulation": {"edge_length": 0.05, **simulation},
        "donning": {"movements": []},
        "ranking": {"modality": "ecg", "partial": True},
    }


TANK_TOP_TOML = """
[body]
posture = "a-pose"
[garment]
pattern = "tank-top"
[simulation]
edge_length = 0.05
[donning]
movements = []
[ranking]
modality = "ecg"
partial = true
"""


def small_study(name, rest):
    """Text of a study of the tank top; `rest`: sites of its scenario and axes."""
    return f"""
[study]
name = "{name}"
modalities = ["imu-uncalibrated"]

[scenario.body]
posture = "a-pose"
[scenario.garment]
pattern = "tank-top"
[scenario.donning]
movements = []
[scenario.simulation]
edge_length = 0.05
{rest}"""


# A sensor at two drawn places beside one that stays: the same drape twice.
PLACE_STUDY = small_study("two places", """
[[scenario.site]]
name = "still"
landmark = "mid_back"
[[scenario.site]]
name = "moved"
landmark = "mid_back"

[[axis]]
name = "place"
place = { site = 1, shift = 0.020, count = 2 }
""")


def run_study(base, text, *options):
    """Folder of a study that has run in the folder `base`."""
    (base / "study.toml").write_text(text)
    command_line("study", "run", base / "study.toml", "-o", base / "out", "--quiet", *options)
    return base / "out"


def unsettled(iterations=1):
    """The same, given up at once: half a second."""
    return tank_top(max_iterations=iterations)


def command_line(*arguments, expected=0):
    """Standard output of the program."""
    done = subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == expected, done.stderr
    return done.stdout

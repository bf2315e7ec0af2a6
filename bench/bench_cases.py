"""The cases of the suite: name, groups, scenario text. Edit here to add one."""
import pairs

# Two adults and the two children of the study: stature, chest, waist, hip in metres.
BODIES = {
    "woman": dict(sex=0.0, age=30, height=1.68, chest=0.88, waist=0.72, hip=0.97),
    "man": dict(sex=1.0, age=30, height=1.80, chest=1.00, waist=0.86, hip=1.02),
    "child-slim": dict(sex=0.4, age=10, height=1.40, chest=0.63, waist=0.55, hip=0.68),
    "child-heavy": dict(sex=0.4, age=10, height=1.40, chest=0.75, waist=0.72, hip=0.80),
}
CHEST_FITS = (-0.05, 0.05, 0.15, 0.30, 0.45)
REFERENCE_FIT = "fit = { chest = 0.10, hip = 0.08, sleeve = 0.25, wrist = 0.25, sleeve_follow = 0, bust_dart = 0.5 }"
# Edge length in mm and time budget in seconds; sizes well above the goals, so that a slow case
# still ends in a figure.
SHIRTS = {"20": 600, "14": 600, "10": 600, "7": 900, "5": 1800, "3.5": 3600}

POSTURES = """[postures]
list = ["standing", "arms-forward", "arms-overhead", "forward-bend-15", "forward-bend-30",
        "forward-bend-45", "sitting", "slouch"]
"""


# Seven angles of the elbow, and the stretch sensor that is to tell them.
SWEEP = """[postures]
sweep = { joint = "elbow-flexion", from = 0, to = 120, step = 20 }
[[site]]
name = "elbow"
from = "forearm_L"
to = "upper_arm_L"
over = "back"
height = 0.001
"""
STIFF_LINE = "stiffness = 60\nwidth = 0.010\npre_stretch = 0.05\n"


class Case:
    """One scenario. `cores`: processor cores it may use, None = all. `missing`: why it cannot run. `files`: texts by name that
    have to lie beside the scenario."""

    def __init__(self, name, groups, scenario="", cores=None, missing=None, files=None):
        self.name, self.groups, self.scenario = name, groups, scenario
        self.cores, self.missing, self.files = cores, missing, files or {}


def scenario(garment, body="woman", edge_mm=10.0, budget=600, posture='posture = "standing"',
             material="paper-cotton", threads=0, extra=""):
    b = BODIES[body]
    return f"""[body]
sex = {b["sex"]}
age = {b["age"]}
height = {b["height"]}
measurements = {{ chest = {b["chest"]}, waist = {b["waist"]}, hip = {b["hip"]} }}
{posture}
[garment]
{garment}
[material]
name = "{material}"
[simulation]
edge_length = {edge_mm / 1000:g}
time_budget = {budget}
threads = {threads}
{extra}"""


def all_fits(share):
    """The whole shirt scales with the chest fit, as in the paper."""
    return f"fit = {{ chest = {share}, hip = {share}, sleeve = {share}, wrist = {share} }}"


def cases():
    found = []
    for mm, budget in SHIRTS.items():
        groups = ["shirt"] + (["quick"] if mm in ("20", "14") else [])
        found.append(Case(f"shirt-{mm}mm", groups,
                          scenario(REFERENCE_FIT, edge_mm=float(mm), budget=budget)))
    found.append(Case("shirt-14mm-one-core", ["shirt"],
                      scenario(REFERENCE_FIT, edge_mm=14, threads=1), cores=1))
    for body in BODIES:
        for fit in CHEST_FITS:
            found.append(Case(f"fit-{body}{round(100 * fit):+03d}", ["fits"],
                              scenario(all_fits(fit), body)))
    for body in ("child-slim", "child-heavy"):
        found.append(Case(f"paper-{body}", ["children"], scenario('size = "child-142"', body)))
    found += [
        Case("tight", ["extremes"], scenario(all_fits(-0.30), material="compression-knit")),
        Case("loose", ["extremes"], scenario(all_fits(1.0))),
        Case("stiff", ["extremes"], scenario(REFERENCE_FIT, material="paper-cotton-literal")),
        Case("limp", ["extremes"], scenario(REFERENCE_FIT, material="silk")),
        # Dressed upright, then carried along to the posture of the maps.
        Case("posture-change", ["posture"], scenario(
            REFERENCE_FIT, posture='dress_posture = "standing"\nposture = "forward-bend"')),
        # Worn in every named posture after the first drape, each followed from there.
        Case("postures", ["posture"], scenario(
            REFERENCE_FIT, edge_mm=14, posture="", extra=POSTURES)),
        # The same with nothing beside it: every share is one of processor time.
        Case("postures-one-core", ["posture"], scenario(
            REFERENCE_FIT, edge_mm=14, posture="", threads=1, extra=POSTURES), cores=1),
        Case("postures-child", ["posture"], scenario(
            'size = "child-142"', "child-slim", edge_mm=14, posture="", extra=POSTURES)),
        # What a stretch sensor over the elbow sees; then one that pulls on the sleeve itself.
        Case("sweep", ["lines"], scenario(
            'pattern = "long-sleeve-shirt"\nfit = { sleeve = 0.05, wrist = 0.05 }', edge_mm=14,
            posture="", material="cotton-jersey", extra=SWEEP)),
        Case("sweep-stiff", ["lines"], scenario(
            'pattern = "long-sleeve-shirt"\nfit = { sleeve = 0.05, wrist = 0.05 }', edge_mm=14,
            posture="", material="cotton-jersey", extra=SWEEP + STIFF_LINE)),
        Case("two-layer", ["layers"], scenario(
            "fit = { chest = 0.20, hip = 0.15, sleeve = 0.30, wrist = 0.30 }", edge_mm=14) + """[[under]]
pattern = "t-shirt"
fit = { chest = 0.05, hip = 0.05, sleeve = 0.12 }
friction = 0.3
[under.material]
name = "cotton-jersey"
"""),
    ]
    found += [Case(name, ["pairs"], text, files=files) for name, (text, files) in pairs.scenarios().items()]
    return found


def select(wanted):
    """Cases whose name or group is in the list, in the order of the suite; KeyError if none is."""
    every = cases()
    for word in wanted:
        if not any(word == c.name or word in c.groups for c in every):
            raise KeyError(word)
    return [c for c in every if not wanted or any(w == c.name or w in c.groups for w in wanted)]

"""Cases that are compared within one run, with the most that one may take of the other's time.

Both of a pair wear the same body at the same edge length on one thread, without movements of the wearer, and are run in turn, so that
what else the machine does meets both alike.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "corpus"))
import garments  # noqa: E402
import people  # noqa: E402

WEARER = people.PEOPLE["woman"]


class Pair:
    """`slower` may take `most` times the seconds of `base`; both are names of cases."""

    def __init__(self, name, slower, base, most):
        self.name, self.slower, self.base, self.most = name, slower, base, most

    def ratio(self, entries, median):
        """What a record keeps: ratios of the medians of processor and wall seconds, and whether the claim holds; None unless both
        are in `entries` and settled."""
        both = [entries.get(name, {}).get("runs") for name in (self.slower, self.base)]
        if not all(both) or not all(run["settled"] for runs in both for run in runs):
            return None
        found = {key: round(median([run[key] for run in both[0]]) / median([run[key] for run in both[1]]), 3)
                 for key in ("cpu_seconds", "wall_seconds")}
        return {"slower": self.slower, "base": self.base, "most": self.most, **found, "holds": found["cpu_seconds"] <= self.most}


PAIRS = [Pair("long-sleeve-top-over-shirt", "garmentcode-long-sleeve", "drafted-shirt", 2.0)]


def scenario(garment):
    return f"""[body]
{WEARER["body"]}
[garment]
{garment}
[material]
name = "paper-cotton"
[simulation]
edge_length = 0.014
time_budget = 600
threads = 1
[donning]
movements = []
"""


def scenarios():
    """name → (scenario, files beside it: name → text)."""
    top = garments.build(WEARER["make"])["top_long"][1]
    return {"drafted-shirt": (scenario('pattern = "long-sleeve-shirt"'), {}),
            "garmentcode-long-sleeve": (scenario('pattern = "top_long_specification.json"'), {"top_long_specification.json": top})}


def print_ratios(ratios):
    for name, found in ratios.items():
        print(f"{name:28} {found['cpu_seconds']:5.2f} times the processor seconds, {found['wall_seconds']:5.2f} times the wall seconds "
              f"of {found['base']}; at most {found['most']:g}: {'holds' if found['holds'] else 'DOES NOT HOLD'}", flush=True)


def turns(cases):
    """The cases in groups that are run in turn: those of a pair together, every other one by itself."""
    groups, place = [], {}
    for case in cases:
        pair = next((p for p in PAIRS if case.name in (p.slower, p.base)), None)
        if pair and pair.name in place:
            groups[place[pair.name]].append(case)
            continue
        if pair:
            place[pair.name] = len(groups)
        groups.append([case])
    return groups

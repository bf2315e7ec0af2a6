"""Tables and the page of a record of corpus.py."""
import collections
import pathlib
import statistics

WEIGHTS = 50  # a garment that hangs presses with a few of its weights, one that is squeezed under the arms with some tens

# Words of warnings of the program which say that a garment is cut too tight for its wearer.
OF_CUT = ("of ease where", "was asked to be loose", "above the waist", "too narrow for this body", "has ridden up")


def is_of_cut(warning):
    return any(words in warning for words in OF_CUT)


def why_not_as_cut(row):
    """In a few words; empty for what is worn as cut."""
    if row["worn_as_cut"] or not row["certified"]:
        return ""
    told = [w.split(": ", 1)[-1] for w in row.get("warnings", []) if is_of_cut(w)]
    if not row["stretched"] and (row.get("force_over_weight") or 0) > WEIGHTS:
        squeezed = row.get("squeezed_over_weight") or 0
        told.append(f"presses with {row['force_over_weight']:.0f} times its weight" +
                    (f", {squeezed:.0f} of it between arms and trunk" if squeezed >= 1 else ""))
    return "; ".join(told)


def classes(rows):
    by_class = collections.defaultdict(list)
    for row in rows.values():
        by_class[row["class"]].append(row)
    return sorted(by_class.items()) + [("all", list(rows.values()))]


def median(values):
    return statistics.median(values) if values else float("nan")


def cells(kind, of):
    """Of a class: name, runs, worn, settled, certified, worn as cut, median force over weight, beyond the cloth's range, CPU seconds."""
    n = len(of)
    certified = sum(r["certified"] for r in of)
    as_cut = sum(r.get("worn_as_cut", False) for r in of)
    force = [r["force_over_weight"] for r in of if r["certified"] and r.get("force_over_weight") is not None]
    share = lambda k: f"{k}, {100 * k / max(1, n):.0f} %"
    return [kind, n, sum(r["worn"] for r in of), sum(r["settled"] for r in of), share(certified), share(as_cut), f"{median(force):.0f}" if force else "-",
            sum(r.get("beyond_range", 0) > 0 for r in of), f"{median([r['cpu_seconds'] for r in of]):.0f}"]


HEAD = ["class", "runs", "worn", "settled", "certified", "worn as cut", "median force / weight", "strained beyond range", "median core s"]


def table(rows):
    """For the terminal."""
    lines = [HEAD] + [cells(kind, of) for kind, of in classes(rows)]
    widths = [max(len(str(line[i])) for line in lines) for i in range(len(HEAD))]
    return "\n".join("  ".join(str(c).ljust(w) if i == 0 else str(c).rjust(w) for i, (c, w) in enumerate(zip(line, widths))) for line in lines)


def markdown(head, lines):
    return "\n".join("| " + " | ".join(str(c).replace("|", "/") for c in line) + " |" for line in [head, ["---"] * len(head), *lines])


def section(name, record):
    rows = record["runs"]
    made = collections.Counter((r.get("program", "unknown"), r.get("date", "unknown"), r.get("edge", record.get("edge"))) for r in rows.values())
    garments, persons = ({key.split("@")[i] for key in rows} for i in (0, 1))
    asked = record.get("asked", len(rows))
    text = [f"## {pathlib.Path(name).stem}", "",
            f"{len(rows)} " + (f"of {asked} runs, an unfinished record," if len(rows) < asked else "runs") +
            f" of {len(garments)} garments on {len(persons)} people" +
            (f", {record['sample']} drawn for each garment (seed {record['seed']})" if record.get("sample") else "") + ".", "",
            markdown(["program", "date", "edge m", "runs"], [[*key, count] for key, count in sorted(made.items(), key=str)]), ""]
    if len({key[0] for key in made}) > 1:
        text += ["**These runs are of several programs: the shares below are of none of them.**", ""]
    text += [markdown(HEAD, [cells(kind, of) for kind, of in classes(rows)]), ""]
    bad = [[key, r["class"], r["reason"] or "no reason told"] for key, r in sorted(rows.items()) if not r["certified"]]
    if bad:
        text += [f"Not certified ({len(bad)}):", "", markdown(["run", "class", "reason"], bad), ""]
    cut = [[key, r.get("force_over_weight", "-"), f"{100 * r.get('beyond_range', 0):.1f} %", r.get("held_off", "-"), why_not_as_cut(r)]
           for key, r in sorted(rows.items()) if r["certified"] and not r.get("worn_as_cut")]
    if cut:
        text += [f"Certified, but not worn as cut ({len(cut)}):", "",
                 markdown(["run", "force / weight", "beyond range by", "held-off triangles", "why"], cut), ""]
    first = collections.Counter(kind for r in rows.values() for kind in {w.split(":")[0] for w in r.get("warnings", [])})
    if first:
        text += ["Warnings, by what they are of: " + ", ".join(f"{kind} in {count} runs" for kind, count in first.most_common()) + ".", ""]
    return text


def page(records):
    """records: (file name, record)."""
    text = ["# Many garments on many people", "",
            "Written by `bench/corpus.py --json FILE --report bench/reports/corpus.md`; not to be changed by hand.", "",
            "Certified is settled and worn. Worn as cut is certified, without a warning that the garment is cut too tight or that its waist has risen, and",
            f"presses with at most {WEIGHTS} times its weight unless it is meant to be stretched (ribs, waistbands shorter than the waist, leggings).",
            "The median of force over weight is that of the certified. Strained beyond range: warp or weft beyond the elongation up to which the cloth's",
            "constants were measured.", ""]
    for name, record in records:
        text += section(name, record)
    return "\n".join(text).rstrip() + "\n"

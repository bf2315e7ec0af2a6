#!/usr/bin/env python3
"""Fail on a reference that leads nowhere: a document, a section, a source, a link, a name.

usage: check_references.py [ROOT]    exit 0 good, 1 something leads nowhere, 2 nothing to check

Reads code, data, tests and documents, comments and strings alike. It reports
  * a Markdown file, with or without folders, that is no document of the repository;
  * a section after it, as in "PAGE 3.1" or "PAGE section 3", of which it has no heading;
  * the name of a page of docs/theory with a number but without its path;
  * the path of a file of code, `maps/gap.h`, that is not there;
  * `decision 9` without docs/decisions/0009-*.md, and a decision of more than a page;
  * a `cite` key or an author with a year ("Li et al. 2020", "Clyde, Teran, Tamstorf 2017") that is not in
    docs/references.bib, where keys are the first author's surname and the year: Li2020, Li2020b;
  * a relative link of a Markdown file that leads to no file, or to no heading of it;
  * a term in the first or a name in the third column of the vocabulary (docs) that no file of src has.
"""
import pathlib
import re
import sys
import unicodedata

FOLDERS = ("src", "apps", "data", "tests", "bench", "tools", "validation", "examples", "docs")
SUFFIXES = (".h", ".cpp", ".py", ".toml", ".md", ".sh", ".cmake", ".bib")
PAGE = 60  # lines of a decision
# Words before a year or a number that are no authors: conferences, journals, months.
NO_AUTHORS = set("""codata membrane sensors ubicomp january february march april may june july august september october november
    december since in from of issue version iso debian vtk python anno copyright""".split())

DOCUMENT = re.compile(r"(?<![\w/.-])((?:[\w.-]+/)*[\w.-]+\.md)\b")
NUMBER = r"\d+(?:\.\d+)*"
SECTIONS = re.compile(rf",?\s+(?:sections?\s+)?({NUMBER}(?:(?:,\s*|\s+and\s+|\s+to\s+){NUMBER})*)"
                      r"(?![\w%°])")
HEADING = re.compile(rf"^#+\s+({NUMBER})\.?\s", re.M)
DECISION = re.compile(r"\b[Dd]ecisions?(?:\s+|/)(\d{1,4}(?:(?:,\s*|\s+and\s+|\s+to\s+)\d{1,2})*)\b(?!\.\d)")
CITE = re.compile(r"\\cite\{?\s*([\w:,-]+)")
NAME = r"(?:(?:[Vv]an der |[Vv]an |[Dd]e )?[^\W\d_a-z](?:[^\W\d_]|['’])+(?:-[^\W\d_]+)*)"
AUTHORS = re.compile(rf"(?<![\w.-])({NAME})"
                     rf"((?:,\s+{NAME})*(?:,?\s+(?:and|&)\s+{NAME}|,?\s+et al\.?|\s+and co-authors)?)"
                     r",?\s+\(?((?:1[89]|20)\d\d)(?![\d-])")
SOURCE_FILE = re.compile(r"(?<![\w/.*{}-])((?:\.\./)*(?:[a-z]\w*/)+[a-z_0-9]+\.(?:h|cpp|py|toml))\b")
BIB_ENTRY = re.compile(r"@\w+\{\s*([^,\s]+)\s*,")
LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)")


def files_of(root):
    for path in sorted(root.glob("*.md")):
        yield path
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            wanted = path.suffix in SUFFIXES or path.name == "CMakeLists.txt"
            if wanted and path.name != "check_references_test.py":  # full of broken ones
                yield path


def flat(text, suffix):
    """The text with comment marks blanked and lines joined; every character keeps its place."""
    def blank(match):
        return " " * len(match.group())
    if suffix in (".h", ".cpp"):
        text = re.sub(r'"[ \t]*\n[ \t]*"', blank, text)  # a string over two lines
        text = re.sub(r"\n[ \t]*//[/!]?<?", blank, text)
    elif suffix != ".md":
        text = re.sub(r"\n[ \t]*#", blank, text)
    return text.replace("\n", " ") if suffix != ".md" else re.sub(r"\n(?=\S)", " ", text)


def plain(name):
    """Surname as in a key: no accents, no spaces, lower case."""
    decomposed = unicodedata.normalize("NFD", name.lower().replace("æ", "ae").replace("ø", "o"))
    return re.sub(r"[^a-z]", "", decomposed)


def headings(text):
    return set(HEADING.findall(text))


def anchors(text):
    """Link targets of the headings as GitHub makes them."""
    found = set()
    for title in re.findall(r"^#+\s+(.*)$", text, re.M):
        title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title).strip().lower()
        found.add(re.sub(r"[^\w\- ]", "", title).replace(" ", "-"))
    return found


class Checker:
    def __init__(self, root):
        self.root = root
        self.problems = []
        self.documents = {p.relative_to(root).as_posix(): p.read_text(errors="replace")
                          for p in files_of(root) if p.suffix == ".md"}
        self.keys = set()
        self.raw_keys = set()
        for key in BIB_ENTRY.findall((root / "docs" / "references.bib").read_text()):
            self.raw_keys.add(key)
            match = re.fullmatch(r"(.*?)(\d{4})[a-z]?", key)
            if match:
                self.keys.add((plain(match.group(1)), match.group(2)))

    def report(self, path, text, place, what):
        line = text.count("\n", 0, place) + 1
        self.problems.append(f"{path.relative_to(self.root)}:{line}: {what}")

    def document(self, path, name):
        """Text of the document that a file means by a name, or nothing."""
        here = path.parent.relative_to(self.root).as_posix()
        for candidate in (name, f"{here}/{name}"):
            parts = []
            for part in candidate.split("/"):
                if part == ".." and parts:
                    parts.pop()
                elif part not in (".", ".."):
                    parts.append(part)
            if "/".join(parts) in self.documents:
                return self.documents["/".join(parts)]
        return None

    def check_documents(self, path, text, joined):
        for match in DOCUMENT.finditer(joined):
            if joined[:match.start()].endswith('/ "'):  # the end of a path in Python
                continue
            found = self.document(path, match.group(1))
            if found is None:
                self.report(path, text, match.start(), f"no document {match.group(1)}")
                continue
            sections = SECTIONS.match(joined, match.end())
            for number in re.findall(NUMBER, sections.group(1)) if sections else []:
                if number not in headings(found):
                    self.report(path, text, match.start(),
                                f"{match.group(1)} has no section {number}")
        for match in re.finditer(rf"\b([a-z]+(?:[-_][a-z]+)+),?\s+(?:sections?\s+)?{NUMBER}", joined):
            stem = match.group(1).replace("-", "_")
            if f"docs/theory/{stem}.md" in self.documents:
                self.report(path, text, match.start(),
                            f"\"{match.group()}\": write docs/theory/{stem}.md and the section")
        for match in DECISION.finditer(joined):
            for number in re.findall(r"\d+", match.group(1)):
                if not any(d.startswith(f"docs/decisions/{int(number):04d}-") for d in self.documents):
                    self.report(path, text, match.start(), f"no decision {number}")

    def check_files(self, path, text):
        """Files of code by their path, in documents and comments; reports and the change log tell history."""
        if path.relative_to(self.root).as_posix().startswith(("bench/reports/", "CHANGELOG")):
            return
        if path.suffix in (".h", ".cpp"):
            text = re.sub(r"^(?:(?!//).)*", lambda m: " " * len(m.group()), text, flags=re.M)
        elif path.suffix != ".md":
            return
        places = (self.root, self.root / "src", self.root / "src" / "loosefit", self.root / "tests",
                  path.parent)
        for match in SOURCE_FILE.finditer(text):
            if not any((place / match.group(1)).exists() for place in places):
                self.report(path, text, match.start(), f"no file {match.group(1)}")

    def check_sources(self, path, text, joined):
        for match in CITE.finditer(joined):
            for key in match.group(1).split(","):
                if key.strip() not in self.raw_keys:
                    self.report(path, text, match.start(), f"{key} is not in docs/references.bib")
        for match in AUTHORS.finditer(joined):
            first, year = match.group(1), match.group(3)
            names = re.findall(NAME, match.group(1) + match.group(2))
            if first.lower() in NO_AUTHORS or any((plain(n), year) in self.keys for n in names):
                continue
            self.report(path, text, match.start(),
                        f"\"{' '.join(match.group().split())}\" is not in docs/references.bib "
                        f"(key {first.replace(' ', '')}{year})")

    def check_links(self, path, text):
        for match in LINK.finditer(re.sub(r"`[^`\n]*`", lambda m: " " * len(m.group()), text)):
            target, _, anchor = match.group(1).partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            leads_to = (path.parent / target).resolve() if target else path
            if not leads_to.exists():
                self.report(path, text, match.start(), f"link to {match.group(1)} leads nowhere")
            elif anchor and leads_to.suffix == ".md":
                if anchor not in anchors(leads_to.read_text(errors="replace")):
                    self.report(path, text, match.start(), f"no heading #{anchor} in {target or path.name}")

    def check_vocabulary(self):
        """Rows | term, term | meaning | `name` |: who greps for the word or the name must find it. In a table
        with another heading than "term", of this project's own notions, only the names are looked for."""
        path = self.root / "docs" / "vocabulary.md"
        if not path.exists():
            return
        source = " ".join(flat(p.read_text(errors="replace"), p.suffix)
                          for p in sorted((self.root / "src").rglob("*")) if p.suffix in (".h", ".cpp"))
        words = set(re.findall(r"\w+", source))
        source = re.sub(r"\s+", " ", source.lower())
        text, greppable = path.read_text(), True
        for line in re.finditer(r"^\|(.*)\|$", text, re.M):
            cells = [cell.strip() for cell in line.group(1).split("|")]
            if len(cells) != 3 or set(cells[0]) <= set("-: "):
                continue
            if cells[2] == "name in code":
                greppable = cells[0] == "term"
                continue
            for term in re.split(r",\s+", cells[0]):
                if greppable and term.lower() not in source:
                    self.report(path, text, line.start(), f"no file of src speaks of \"{term}\"")
            for name in re.findall(r"`([^`]+)`", cells[2]):
                known = (self.root / "src" / "loosefit" / name).exists() if "/" in name else \
                    all(word in words for word in re.findall(r"\w+", name))
                if not known:
                    self.report(path, text, line.start(), f"`{name}` is not in src")

    def run(self):
        count = 0
        for path in files_of(self.root):
            text = path.read_text(errors="replace")
            joined = flat(text, path.suffix)
            count += 1
            if path.suffix != ".bib":
                self.check_documents(path, text, joined)
                self.check_sources(path, text, joined)
                self.check_files(path, text)
            if path.suffix == ".md":
                self.check_links(path, text)
            if path.parent.name == "decisions" and text.count("\n") > PAGE:
                self.report(path, text, len(text), f"a decision is at most a page of {PAGE} lines; "
                            "tables and trials go into bench/reports")
        self.check_vocabulary()
        return count


def main(argv):
    root = pathlib.Path(argv[1] if len(argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    try:
        checker = Checker(root)
    except OSError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    count = checker.run()
    for problem in checker.problems:
        print(f"error: {problem}")
    print(f"{count} files, {len(checker.documents)} documents, {len(checker.raw_keys)} sources, "
          f"{len(checker.problems)} problems")
    return 1 if checker.problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))

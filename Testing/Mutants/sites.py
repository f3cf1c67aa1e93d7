# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small changes to a source: the named ones of named.json, and those that a seed draws."""

import dataclasses
import hashlib
import json
import re


class NoSuchSource(Exception):
    """A mutant names text that the sources do not hold, or hold more than once."""


@dataclasses.dataclass(frozen=True)
class Mutant:
    """A change of the characters begin to end of a file."""

    name: str
    kind: str
    file: str  # below vtkTemporalCoherence/
    line: int
    begin: int
    end: int
    put: str
    find: str
    context: str  # the line as it is; with `find` and `put` it tells what was judged

    def apply(self, text):
        return text[:self.begin] + self.put + text[self.end:]

    def change(self):
        """The change in a few words."""
        shorten = lambda text: " ".join(text.split()) or "nothing"
        return f"{shorten(self.find)} -> {shorten(self.put)}"


def line_at(text, place):
    return text.count("\n", 0, place) + 1


def text_of_line_at(text, place):
    return text[text.rfind("\n", 0, place) + 1:(text + "\n").find("\n", place)].strip()


def read_named(path, read):
    """The mutants of a table. `read` gives the text of a source."""
    mutants = []
    groups = json.loads(path.read_text(encoding="utf-8"))["groups"]
    for entry in (mutant for group in groups for mutant in group["mutants"]):
        text, find = read(entry["file"]), entry["find"]
        if text.count(find) != 1:
            raise NoSuchSource(
                f"{path.name}: {entry['name']}: {entry['file']} holds this {text.count(find)} times,"
                f" not once:\n{find}\nThe source has changed: describe the mutant anew.")
        begin = text.index(find)
        mutants.append(Mutant(
            entry["name"], "named", entry["file"], line_at(text, begin), begin, begin + len(find),
            entry["put"], find, text_of_line_at(text, begin)))
    return mutants


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


# What is no code to change: comments, texts, what the preprocessor reads, assertions.
NO_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
    r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|\b(?:static_)?assert\([^;]*;", re.DOTALL | re.MULTILINE)

# An array that is declared, whose size is no index.
DECLARATION = re.compile(r"^\s*(?:const |constexpr |static )*[\w:]+(?:<.*>)?[ *&]+\w+$")

SWAPPED = {
    "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
    "min": "max", "max": "min", "Min": "Max", "Max": "Min", "+": "-", "-": "+",
}


def swap(group):
    return lambda code, match: [(match.span(group), SWAPPED[match.group(group)])]


def negate_condition(code, match):
    depth, place = 1, match.end()
    while depth > 0 and place < len(code):
        depth += {"(": 1, ")": -1}.get(code[place], 0)
        place += 1
    inner = (match.end(), place - 1)
    return [(inner, f"!({code[slice(*inner)]})")]


def shift_index(code, match):
    before = code[code.rfind("\n", 0, match.start()) + 1:match.start()]
    if DECLARATION.match(before):
        return []
    return [(match.span(1), f"{match.group(1)} + 1"), (match.span(1), f"{match.group(1)} - 1")]


def scale_constant(code, match):
    number = match.group(1)
    if float(number.rstrip("f")) == 0.0:
        return [(match.span(1), "1.0f" if number.endswith("f") else "1.0")]
    two = "2.0f" if number.endswith("f") else "2.0"
    return [(match.span(1), f"({two} * {number})"), (match.span(1), f"({number} / {two})")]


def drop_margin(code, match):
    if not re.search(r"\d", match.group(1)):
        return []
    return [(match.span(1), f"0.0 * ({match.group(1)})"), (match.span(1), f"8.0 * ({match.group(1)})")]


# How often a kind is drawn beside the others, what it looks for, and what it makes of it. The
# formatting of the sources tells an operator, which has spaces, from a template's bracket.
KINDS = {
    "comparison": (3, r"(?<= )([<>]=?)(?=\s)", swap(1)),
    "margin": (2, r"\bconstexpr (?:double|float) \w+ = ([^;{]+)(?=;)", drop_margin),
    "offset": (2, r"(?<= )([-+])(?= 1\b(?![.\w]))", swap(1)),
    "index": (2, r"(?<=[\w\])])\[([^\[\]{}=&\n]+)\]", shift_index),
    "equality": (1, r"(?<= )([!=]=)(?=\s)", swap(1)),
    "constant": (1, r"(?<![\w.])(\d+\.\d+(?:e[-+]?\d+)?f?)(?![\w.])", scale_constant),
    "logic": (1, r"(?<= )(&&|\|\|)(?=\s)", swap(1)),
    "condition": (1, r"\bif \(", negate_condition),
    "extreme": (1, r"\b(?:(?:std|glm)::(min|max)\b(?=[(<])|hn::(Min|Max)(?=\())",
                lambda code, match: swap(match.lastindex)(code, match)),
}


def find_sites(file, text):
    """All changes that could be made to a source, each with a name that stays the same while its
    line does."""
    code = NO_CODE.sub(blank, text)
    seen = {}
    for kind, (_, pattern, changes) in KINDS.items():
        for match in re.finditer(pattern, code):
            for (begin, end), put in changes(code, match):
                context = text_of_line_at(text, begin)
                key = f"{file}|{kind}|{context}|{text[begin:end]}|{put}"
                seen[key] = seen.get(key, 0) + 1
                digest = hashlib.sha256(f"{key}|{seen[key]}".encode()).hexdigest()
                stem = file.rsplit("/", 1)[-1].replace(".cxx", "").replace(".h", "-h")
                yield Mutant(
                    f"{stem}-{digest[:6]}", kind, file, line_at(text, begin), begin, end, put,
                    text[begin:end], context)


def draw(mutants, count, seed):
    """As many mutants of each kind as there are, up to `count` in all. Which are drawn depends on
    their own lines alone, so that a change of the sources elsewhere does not draw others."""
    rank = lambda mutant: hashlib.sha256(f"{seed}|{mutant.name}".encode()).hexdigest()
    hats = {kind: sorted((m for m in mutants if m.kind == kind), key=rank) for kind in KINDS}
    drawn = []
    while len(drawn) < count and any(hats.values()):
        for kind, hat in hats.items():
            share = min(KINDS[kind][0], count - len(drawn))
            drawn += hat[:share]
            del hat[:share]
    return sorted(drawn, key=lambda mutant: (mutant.file, mutant.line, mutant.name))

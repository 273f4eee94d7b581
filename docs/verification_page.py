"""Write `verification.md` from what the tests in `tests/verification` say of themselves.

`python docs/verification_page.py` writes it; a test holds it to be what this makes.
"""

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CASES = ROOT / "tests" / "verification"
PAGE = ROOT / "docs" / "verification.md"

NEAR = r"\b(within|asked|allowed|tolerance|must be|at most|less than|below \d|agree to|asserted)\b"
HEAD = """# Verification

Forces and solvers are compared with exact or published answers. Tolerances are derived where a comparison is described,
rates of convergence are asserted where there are any, and nearly every comparison has a wrong variant that must fail.
`python docs/verification_page.py` makes this page from the docstrings of the tests, and
`python -m pytest tests/verification` runs them all. Two comparisons have pages of their own:
[cables](studies/bending-2020.md) and [the seabed](studies/seabed-2022.md).

The table has of each case one sentence on how near the two must be; formulas, sources and reasons for tolerances stand
below it.

"""


def cases() -> list[tuple[str, str]]:
    """Return the names of the tests' files, and what they say."""
    return [
        (path.name, ast.get_docstring(ast.parse(path.read_text("utf-8"))) or "")
        for path in sorted(CASES.glob("test_*.py"))
    ]


def parts(text: str) -> tuple[str, str, list[str]]:
    """Return the first sentence, what it verifies, and the paragraphs after that."""
    paragraphs = text.split("\n\n")
    verified = next((p for p in paragraphs if p.startswith("Verifies:")), "")
    rest = [p for p in paragraphs[1:] if p != verified]
    return " ".join(paragraphs[0].split()), verified.removeprefix("Verifies:").strip(), rest


def near(rest: list[str]) -> str:
    """Return the first sentence that says how near the two must be, if a sentence alone does."""
    prose = [" ".join(p.split()) for p in rest if not p.startswith("    ")]
    sentences = [s for p in prose for s in re.split(r"(?<=[.:;])\s+(?=[A-Z])", p)]
    return next((s for s in sentences if re.search(NEAR, s) and re.search(r"\d", s)), "")


def page() -> str:
    """Return the page."""
    rows, sections = [], []
    for name, text in cases():
        what, verified, rest = parts(text)
        how_near = near(rest)
        title = name.removeprefix("test_").removesuffix(".py").replace("_", " ")
        rows.append(f"| [{title}](#{title.replace(' ', '-')}) | {cell(what)} | {verified} | {cell(how_near)} |")
        body = "\n\n".join(map(shown, rest))
        sections.append(
            f"## {title}\n\n{shown(what)}\n\n" + (f"{body}\n\n" if body else "") + f"Test: `tests/verification/{name}`."
        )
    table = "| case | what is compared | part | how near |\n|---|---|---|---|\n" + "\n".join(rows)
    return HEAD + table + "\n\n" + "\n\n".join(sections) + "\n"


def cell(text: str) -> str:
    """Return a sentence for a table."""
    return escaped(text).replace("|", "\\|")


def shown(paragraph: str) -> str:
    """Return a paragraph as Markdown: what is set in stays as it is, the rest has no marks by accident."""
    lines = paragraph.splitlines()
    if all(not line or line.startswith("    ") for line in lines):
        return "\n".join(lines)
    return "\n".join(escaped(line) for line in lines)


def escaped(text: str) -> str:
    """Return text whose asterisks, underscores, brackets and angles outside of code are no marks."""
    pieces = text.split("`")
    return "`".join(re.sub(r"([*_\[\]<])", r"\\\1", p) if k % 2 == 0 else p for k, p in enumerate(pieces))


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")

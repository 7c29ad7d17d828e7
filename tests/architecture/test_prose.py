"""A page says one thing per sentence, and the finder of sentences finds them."""

from __future__ import annotations

from pathlib import Path

from tests.architecture.sentences import Sentence, sentences_of
from tests.architecture.source_tree import ROOT, project_files

LONGEST_SENTENCE = 30
"""Words. Sentences aim at 25; the rest is room for one list of names."""

PAGES = {
    Path(name)
    for name in (
        "README.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "docs/studies/README.md",
        "scenes/README.md",
        "tracer/README.md",
    )
}
FOLDERS = {Path("docs"), Path("docs/decisions")}
GENERATED = {Path("docs/agreement.md")}

EXAMPLE = """# A heading is no sentence.

Glass bends light, by `n = 1.5 at 589 nm`. The [law of
refraction](https://example.org/a.b) says how: It is Snell's law, e.g. for air.

    a code block. Of two sentences.

* An item
  on two lines
* **Another.** It has two - really.

| a cell | another. And a second |
```
fenced. Code.
```
"""


def test_the_finder_finds_sentences_and_their_words() -> None:
    found = [(sentence.line, sentence.words, sentence.text.split()[0]) for sentence in sentences_of(EXAMPLE)]
    assert found == [
        (3, 5, "Glass"),
        (3, 6, "The"),
        (3, 7, "It"),
        (8, 5, "An"),
        (10, 1, "**Another."),
        (10, 4, "It"),
        (12, 2, "a"),
        (12, 1, "another."),
        (12, 3, "And"),
    ]


def long_sentences(page: str) -> list[Sentence]:
    return [sentence for sentence in sentences_of(page) if sentence.words > LONGEST_SENTENCE]


def test_a_sentence_of_the_pages_says_one_thing() -> None:
    pages = [path for path in project_files() if path.suffix == ".md" and (path in PAGES or path.parent in FOLDERS)]
    assert set(pages) >= PAGES | GENERATED, "a page has moved; correct the list"
    long, found = [], 0
    for path in sorted(set(pages) - GENERATED):
        page = (ROOT / path).read_text(encoding="utf-8")
        found += sum(1 for _ in sentences_of(page))
        long += [f"{path}:{each.line}: {each.words} words: {each.text}" for each in long_sentences(page)]
    assert found > 1500, "the finder no longer finds the sentences of the pages"
    assert not long, "say one thing per sentence:\n" + "\n".join(long)

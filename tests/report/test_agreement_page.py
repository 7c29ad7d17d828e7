"""A page of agreement keeps what people wrote, and its tables say what the record says."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.synthetic import write_run
from vitrail.judge.records import Results
from vitrail.report.agreement_page import BEGIN, END, agreement_tables, count_line, write_agreement_page
from vitrail.study.agreement import agreement


@pytest.fixture
def results(tmp_path: Path) -> Results:
    return write_run(tmp_path)


def test_only_the_tables_of_a_page_are_written(results: Results, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(f"# Mine\n\nBefore.\n\n{BEGIN}\nold\n{END}\n\nAfter.\n")
    found = agreement([results])
    write_agreement_page(page, found)
    write_agreement_page(page, found)
    text = page.read_text()
    assert text.startswith("# Mine\n\nBefore.\n") and text.endswith(f"{END}\n\nAfter.\n") and "old" not in text
    assert agreement_tables(found) in text


def test_a_page_that_is_not_there_is_begun(results: Results, tmp_path: Path) -> None:
    found = agreement([results])
    write_agreement_page(tmp_path / "new.md", found)
    text = (tmp_path / "new.md").read_text()
    assert text.startswith("# Agreement of the engines\n") and text.endswith(f"{END}\n")
    assert count_line(found) in text
    # Markdown is not escaped, and every row of the record is a line of the last table of rows.
    assert "&#" not in text and "&amp;" not in text
    rows = text.partition("## Scene by scene")[2].partition("## How each")[0]
    assert rows.count("| caustic |") == len(found.rows) > 0

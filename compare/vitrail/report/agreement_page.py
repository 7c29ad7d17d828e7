"""The agreement of the engines as tables in Markdown; every number comes from ``agreement.json.gz``."""

from __future__ import annotations

from pathlib import Path

from vitrail.base.whole_file import write_whole
from vitrail.report.environment import text
from vitrail.study.agreement import Agreement

BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"
"""What stands between these lines of a page is written by the program, everything else by people."""


def write_agreement_page(page: Path, found: Agreement) -> None:
    """Replace the tables of a page, or begin one."""
    before, after = "# Agreement of the engines\n\n", ""
    if page.is_file():
        whole = page.read_text(encoding="utf-8")
        before, _, rest = whole.partition(BEGIN)
        after = rest.partition(END)[2].lstrip("\n")
    write_whole(page, f"{before}{BEGIN}\n\n{agreement_tables(found)}{END}\n" + (f"\n{after}" if after else ""))


def agreement_tables(found: Agreement) -> str:
    """All tables: a count, the largest difference of each number, what lies beyond the certificate, every row."""
    return text("agreement.md", found=found)


def count_line(found: Agreement) -> str:
    """The whole result in one sentence."""
    return text("agreement_count.md", found=found).rstrip("\n")

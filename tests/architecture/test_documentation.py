"""What a user can write or type is documented: scene keys, commands, make targets, formula tags."""

from __future__ import annotations

import re

import typer.main

from tests.architecture.source_tree import ROOT, project_files
from vitrail.check.check import check_text
from vitrail.commands.app import app
from vitrail.scene.field_types import part_types
from vitrail.scene.model import Scene


def backquoted(text: str) -> set[str]:
    """Every word inside backquotes or a code block."""
    code = "\n".join(re.findall(r"```.*?```|`[^`\n]+`", text, re.DOTALL))
    return set(re.findall(r"[A-Za-z_][A-Za-z0-9_]*", code))


def test_every_scene_key_is_documented() -> None:
    documented = backquoted((ROOT / "scenes" / "README.md").read_text(encoding="utf-8"))
    keys = [(part.__name__, key) for part in part_types(Scene) for key in part.file_keys()]
    missing = sorted(f"{part}.{key}" for part, key in keys if key not in documented)
    assert not missing, f"scenes/README.md says nothing about {missing}"


def test_every_command_and_option_is_documented() -> None:
    page = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    group = typer.main.get_command(app)
    missing = []
    for name, command in group.commands.items():  # type: ignore[attr-defined]
        if f"vitrail {name}" not in page:
            missing.append(name)
        for parameter in command.params:
            for option in parameter.opts:
                if option.startswith("--") and option not in ("--help",) and option not in page:
                    missing.append(f"{name} {option}")
    assert not missing, f"docs/commands.md says nothing about {missing}"


def test_every_documented_command_exists() -> None:
    group = typer.main.get_command(app)
    for name in ("README.md", "docs/commands.md", "CONTRIBUTING.md", "scenes/README.md"):
        text = (ROOT / name).read_text(encoding="utf-8")
        mentioned = set(re.findall(r"(?:^    |`|bin/)vitrail ([a-z]+)", text, re.MULTILINE))
        unknown = mentioned - set(group.commands)  # type: ignore[attr-defined]
        assert not unknown, f"{name} speaks of commands that do not exist: {sorted(unknown)}"


def test_every_make_target_is_in_the_help() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    phony = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)
    assert phony is not None
    help_text = makefile.split("help:", 1)[1].split("\n\n", 1)[0]
    missing = [t for t in phony.group(1).split() if t not in ("help", "build") and f"make {t}" not in help_text]
    assert not missing


TAG = re.compile(r"\[(S|O|P|J96|W07)((?:\s[^\]\n]{1,40})?)\]")


PAGES = {"O": "docs/errata.md", "P": "docs/povray.md"}


def numbered_places(page: str) -> set[str]:
    """Every place of a page that a tag can name: sections, and row or list item n of section s as s.n."""
    known, section = set(), ""
    for line in (ROOT / page).read_text(encoding="utf-8").splitlines():
        if heading := re.match(r"#+ (?:Part )?(\d+(?:\.\d+)?)", line):
            section = heading.group(1)
            known.add(section)
        elif item := re.match(r"(?:\| )?(\d+)(?: \||\. )", line):
            known.add(f"{section}.{item.group(1)}")
    return known


def test_every_formula_tag_is_explained() -> None:
    """[O 1.1] names a section of docs/errata.md, [P 2.4] one of docs/povray.md; docs/sources.md explains the rest."""
    sources = (ROOT / "docs" / "sources.md").read_text(encoding="utf-8")
    known = {letter: numbered_places(page) for letter, page in PAGES.items()}
    unknown = []
    for path in project_files():
        if path.suffix not in {".py", ".h", ".cc", ".cpp", ".yaml", ".md"}:
            continue
        for letter, place in TAG.findall((ROOT / path).read_text(encoding="utf-8")):
            number = re.match(r"\s(\d+(?:\.\d+)*)", place)
            leads_nowhere = letter in PAGES and number is not None and number.group(1) not in known[letter]
            if leads_nowhere or f"[{letter}" not in sources:
                unknown.append(f"{path}: [{letter}{place}]")
    assert not unknown, "\n".join(unknown)


def test_every_link_between_pages_leads_somewhere() -> None:
    broken = []
    for path in project_files():
        # A template links from where its page will stand; the page itself is checked there.
        if path.suffix != ".md" or "templates" in path.parts:
            continue
        text = (ROOT / path).read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
            if "://" not in target and not ((ROOT / path).parent / target).exists():
                broken.append(f"{path}: {target}")
    assert not broken, "\n".join(broken)


def test_the_scene_of_the_readme_is_a_good_one() -> None:
    (text,) = re.findall(r"```yaml\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    found = check_text(text)
    assert not found.diagnostics, found.diagnostics

"""What of a scene's names reaches a readable file: identifiers that POV-Ray takes, and comments of one line."""

from __future__ import annotations

import re

import pytest

from tests.lower.povray.real_povray import scene
from vitrail.lower.povray import ReadableScene, lower_readable
from vitrail.lower.povray.readable.identifiers import Identifiers, file_stem
from vitrail.lower.povray.text.printer import IDENTIFIER, comment_text, printed
from vitrail.lower.povray.text.sdl import Comment, SdlFile
from vitrail.pipeline.job import prepare

HOSTILE = [
    'x*/ } #include "/etc/passwd" //',
    'a\n#fopen Out "stolen" write\n#write (Out, 1)\n//',
    "a\r#error 1",
    "a\u2028#error 1",
    "/* never closed",
    "*/",
    "#declare Pi = 3;",
    "sphere",
    "M_Clear",
    "été 玻璃",
    "../../x",
    "9",
    "\\",
]
PATCH = "{center: [0, 0, 0], u: [0.1, 0, 0], v: [0, 0, -0.1]}"


def readable_of(name: str, file: str = "scene.yaml") -> ReadableScene:
    """A scene whose every name is ``name``."""
    quoted = '"' + "".join(f"\\U{ord(each):08x}" for each in name) + '"'
    loaded = scene(
        f"{quoted}: {{diffuse: 0.5}}",
        f"- {{name: {quoted}, plane: {{point: [0, 0, 0], normal: [0, 1, 0]}}, material: {quoted}}}",
        f"- {{name: {quoted}, directional: {{direction: [0, -1, 0], irradiance: 1}}}}",
        more=f"title: {quoted}\nobserve: [{{name: {quoted}, phenomenon: diffusion, patch: {PATCH}}}]",
    )
    job = prepare(loaded)
    return lower_readable(job.world, job.plan, job.settings, file)


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_name_changes_comments_and_identifiers_alone(name: str) -> None:
    """[P 8.5] Without its comments and identifiers the file is that of a harmless name."""
    assert _bare(readable_of(name).text) == _bare(readable_of("harmless").text)


def _bare(text: str) -> list[str]:
    """The tokens of a file that are neither comments nor identifiers."""
    code = [line for line in text.splitlines() if not line.lstrip().startswith("//")]
    assert all(ord(each) < 127 for each in text)
    return re.sub(r"\b[A-Z][A-Za-z0-9_]*", "NAME", "\n".join(code)).split()


@pytest.mark.parametrize("file", ["x.yaml", "a b;rm -rf.yaml", "-D.yaml", "\n.yaml", ".yaml"])
def test_the_command_in_the_first_lines_names_a_plain_file(file: str) -> None:
    made = readable_of("ball", file=file)
    (name, *_), command = made.files, re.search(r"^// povray (.*)$", made.text, re.MULTILINE)
    assert re.fullmatch(r"\w+\.pov", name)
    assert command is not None
    assert re.fullmatch(r"[\w.+ -]+", command[1])
    assert f"+I{name} " in command[1]


@pytest.mark.parametrize("name", HOSTILE)
def test_identifiers_are_those_that_the_printer_takes_and_all_different(name: str) -> None:
    identifiers = Identifiers()
    found = [identifiers.new(name, prefix=prefix).name for prefix in ("", "", "M_", "M_")]
    assert len(set(found)) == 4
    assert all(IDENTIFIER.fullmatch(each) for each in found)


def test_long_names_stay_within_what_povray_reads() -> None:
    identifiers = Identifiers()
    names = {identifiers.new("x" * 400, prefix="Mesh_", suffix="_Irradiance").name for _ in range(120)}
    assert len(names) == 120
    assert all(IDENTIFIER.fullmatch(name) for name in names)


@pytest.mark.parametrize("text", HOSTILE)
def test_a_comment_is_one_line_that_opens_and_closes_nothing(text: str) -> None:
    (line,) = printed(SdlFile((Comment(text),))).splitlines()
    assert line.startswith("// ")
    assert line.isascii() and line.isprintable()
    assert "*/" not in comment_text(text) and "/*" not in comment_text(text)


@pytest.mark.parametrize("name", [*HOSTILE, "ball"])
def test_file_names_are_words(name: str) -> None:
    assert re.fullmatch(r"[A-Za-z0-9_]+", file_stem(name))

"""Say what is wrong with a field in the words of the scene language, with the place where it was written."""

from __future__ import annotations

from typing import Any

from pydantic import ValidationError

from vitrail.base.fault import Fault
from vitrail.base.suggestion import nearest, suggestion
from vitrail.scene.colours import colour_keys
from vitrail.scene.diagnostic import Diagnostic
from vitrail.scene.field_types import example_at, known_keys, part_types
from vitrail.scene.model import Part, Scene
from vitrail.scene.yaml_tree import Path, Places


def field_diagnostics(
    error: ValidationError, data: Any, top: type[Part], places: Places, file: str
) -> list[Diagnostic]:
    """One Diagnostic for each thing that is wrong; alternatives that the author did not mean are left out."""
    found: dict[tuple[int, int, str], Diagnostic] = {}
    errors = [(each, *walked) for each in error.errors(include_url=False) if (walked := _walk(each["loc"], data))]
    misspelt = _misspelt(errors, data, top)
    for each, path, value in errors:
        # A key without a value is reported where the file is read, a misspelt one where it is written.
        absent = each["type"] in ("missing", "extra_forbidden")
        incomplete = each["type"] == "value_error" and isinstance(value, dict) and None in value.values()
        if value is None and not absent or incomplete or each["type"] == "missing" and path in misspelt:
            continue
        what, remedy, at_key = _explain(each, path, value, data, top)
        line, col = places.of_key(*path) if at_key else places.of(*path)
        found.setdefault((line, col, what), Diagnostic(file, line, col, what, remedy))
    return list(found.values())


def _misspelt(errors: list[tuple[Any, Path, Any]], data: Any, top: type[Part]) -> set[Path]:
    """The paths that unknown keys were probably meant for."""
    unknown = [path for each, path, _ in errors if each["type"] == "extra_forbidden"]
    return {(*path[:-1], nearest(str(path[-1]), known_keys(path[:-1], data, top)) or "") for path in unknown}


def _walk(loc: tuple[int | str, ...], data: Any) -> tuple[Path, Any] | None:
    """The path in the file that a pydantic location means, and the value there; None for an alternative not meant.

    A location also holds the names of the alternatives of a union, which are no keys of the file. Where the author
    wrote a mapping only the alternatives that are mappings are meant, elsewhere only the others.
    """
    path: Path = ()
    value = data
    for index, step in enumerate(loc):
        is_last = index == len(loc) - 1
        if isinstance(value, dict) and isinstance(step, str) and step in value:
            path, value = (*path, step), value[step]
        elif isinstance(value, list) and isinstance(step, int) and step < len(value):
            path, value = (*path, step), value[step]
        elif isinstance(step, int):
            break
        elif _is_alternative(step):
            if isinstance(value, dict) != _is_mapping_alternative(step):
                return None
        elif is_last:
            return (*path, step), None
    return path, value


def _is_mapping_alternative(step: str) -> bool:
    """Whether an alternative is a mapping; pydantic names it by its class."""
    return step in {part.__name__ for part in part_types(Scene)}


def _is_alternative(step: str) -> bool:
    return (
        _is_mapping_alternative(step) or any(mark in step for mark in "[(-") or step in ("float", "int", "str", "bool")
    )


# --- what to say ----------------------------------------------------------------------------------------------------


def _explain(error: Any, path: Path, value: Any, data: Any, top: type[Part]) -> tuple[str, str, bool]:
    """(what, remedy, whether the key rather than the value is the place)."""
    kind, context, name = error["type"], error.get("ctx") or {}, _label(path)
    if kind == "value_error":
        fault = context["error"]
        assert isinstance(fault, Fault), fault
        return fault.what, fault.remedy, isinstance(value, dict)
    if kind == "extra_forbidden":
        known = known_keys(path[:-1], data, top)
        return f"unknown key `{path[-1]}`{_inside(path)}", suggestion(str(path[-1]), known, "key"), True
    if kind == "missing" and path and isinstance(path[-1], str) and not isinstance(value, list):
        example = example_at(path, data, top)
        written = example if example[0] in "{[" or example.isdigit() else f"<{example}>"
        return f"`{path[-1]}` is missing{_inside(path)}", f"add `{path[-1]}: {written}`", True
    if kind in ("greater_than", "greater_than_equal", "less_than", "less_than_equal"):
        word, limit = _LIMITS[kind], next(iter(context.values()))
        return f"{name} is {_shown(value)} and must be {word} {limit:g}", f"give a number {word} {limit:g}", False
    if kind == "finite_number":
        return f"{name} is not a finite number", "give a number such as 1.5", False
    if kind in ("literal_error", "enum"):
        return _explain_choice(name, value, context, MAPPINGS.get(str(path[-1]) if path else ""))
    return _explain_type(kind, name, value, path, data, top)


_LIMITS = {
    "greater_than": "above",
    "greater_than_equal": "at least",
    "less_than": "below",
    "less_than_equal": "at most",
}


MAPPINGS = {"bands": "{spectral: 8}", "indirect": "{ambient: 0.5}"}
"""Keys that take one of a few words or a mapping, with an example of it."""


def _explain_choice(name: str, value: Any, context: Any, mapping: str | None) -> tuple[str, str, bool]:
    """A word that is none of the words allowed there."""
    expected = context.get("expected", "").replace(" or ", ", ")
    choices = [choice.strip().strip("'") for choice in expected.split(",")] + ([mapping] if mapping else [])
    close = nearest(value, choices) if isinstance(value, str) else None
    if close is not None:
        return f"{name} is {_shown(value)}, which is none of its choices", f"did you mean `{close}`?", False
    return f"{name} is {_shown(value)}", f"the choices are {', '.join(choices)}", False


def _explain_type(kind: str, name: str, value: Any, path: Path, data: Any, top: type[Part]) -> tuple[str, str, bool]:
    """A value of another kind than the field takes."""
    wanted = _WANTED.get(kind)
    if kind == "tuple_type" and path and path[-1] in colour_keys():
        return f"{name} must be a colour, found {_shown(value)}", "write a number, or [red, green, blue]", False
    if isinstance(value, list) and kind in ("missing", "too_long", "too_short"):
        return f"{name} has {len(value)} entries", f"give {example_at(path, data, top)}", False
    if wanted is None:
        wanted = "something else"
    if kind == "tuple_type" and name in ("`objects`", "`lights`", "`observe`"):
        wanted = "a list, each entry after a dash"
    return f"{name} must be {wanted}, found {_shown(value)}", f"write {example_at(path, data, top)}", False


_WANTED = {
    "float_type": "a number",
    "float_parsing": "a number",
    "int_type": "a whole number",
    "int_parsing": "a whole number",
    "int_from_float": "a whole number",
    "int_parsing_size": "a smaller whole number",
    "bool_type": "true or false",
    "bool_parsing": "true or false",
    "string_type": "text",
    "tuple_type": "a list of numbers",
    "dict_type": "a mapping `name: {...}`",
    "model_type": "a mapping `{key: value, ...}`",
    "model_attributes_type": "a mapping `{key: value, ...}`",
}


def _label(path: Path) -> str:
    """The field as its author knows it: the last key, with the indices after it."""
    names = [index for index, step in enumerate(path) if isinstance(step, str)]
    if not names:
        return "the scene"
    last = names[-1]
    return "`" + str(path[last]) + "".join(f"[{step}]" for step in path[last + 1 :]) + "`"


def _inside(path: Path) -> str:
    outer = _label(path[:-1]) if len(path) > 1 else ""
    return f" in {outer}" if outer and outer != "the scene" else ""


def _shown(value: Any) -> str:
    """A value as found in the file, short enough for a message."""
    match value:
        case None:
            return "nothing"
        case bool():
            return "true" if value else "false"
        case str():
            return f"the text '{value if len(value) <= 40 else value[:37] + '...'}'"
        case dict():
            return "a mapping"
        case list():
            return f"a list of {len(value)}"
        case _:
            return f"{value:g}" if isinstance(value, float) else str(value)

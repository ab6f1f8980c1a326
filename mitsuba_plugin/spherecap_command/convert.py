"""Rewrites the sphere lights of a scene file to `spherecap`, and leaves every other byte as it is.

What has to change is known from Mitsuba's parser (`scene.py`). Here are the edits: of a start tag or of the
default that it reads, of includes with lights in them (which are written as files of their own beside the
result), and of the search path if the result lies in another folder.
"""

import html
import os
import re
import xml.parsers.expat
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from spherecap_command.errors import UserError
from spherecap_command.scene import BUILT_IN, OURS, Light, ParsedScene

_ATTRIBUTE = re.compile(rb"""\s+([\w:.-]+)\s*=\s*("[^"]*"|'[^']*')""")


@dataclass
class Element:
    """A start tag: where its `<` is, its attributes' values, and where these are between their quotes."""

    tag: str
    start: int
    values: dict[str, str] = field(default_factory=dict)
    spans: dict[str, tuple[int, int]] = field(default_factory=dict)
    end: int = 0


@dataclass
class Conversion:
    """Files to be written, as bytes, the main one last; and the lights that were changed."""

    files: dict[Path, bytes]
    changed: list[Light]


def elements(data: bytes) -> list[Element]:
    """Return all start tags of a file in order."""
    found = []
    parser = xml.parsers.expat.ParserCreate()

    def start(tag: str, values: dict[str, str]) -> None:
        element = Element(tag, parser.CurrentByteIndex, values)
        position = element.start + 1 + len(tag.encode())
        while match := _ATTRIBUTE.match(data, position):
            element.spans[match[1].decode()] = (match.start(2) + 1, match.end(2) - 1)
            position = match.end()
        element.end = data.index(b">", position) + 1
        found.append(element)

    parser.StartElementHandler = start
    parser.Parse(data, True)
    return found


class _File:
    """One file of the scene, with the edits that it needs."""

    def __init__(self, path: Path):
        self.path = path
        self.data = path.read_bytes()
        try:
            self.data.decode()
        except UnicodeDecodeError as error:
            raise UserError(f"'{path}' is not encoded in UTF-8: save it so, and try again") from error
        try:
            self.elements = elements(self.data)
        except xml.parsers.expat.ExpatError as error:  # Mitsuba's parser lets some mistakes pass
            raise UserError(f"'{path}' is not correct XML: {error}") from error
        self.by_start = {element.start: element for element in self.elements}
        self._edits: list[tuple[int, int, bytes]] = []

    def set(self, element: Element, attribute: str, value: str) -> None:
        """Replace the value of an attribute."""
        self._edits.append((*element.spans[attribute], html.escape(value).encode()))

    def insert_after(self, element: Element, text: str) -> None:
        """Insert text on a line of its own after a start tag."""
        rest = re.match(rb"\s*?\n([ \t]*)", self.data[element.end :])
        indent = rest[1].decode() if rest else "    "
        self._edits.append((element.end, element.end, f"\n{indent}{text}".encode()))

    def edited(self) -> bytes:
        """Return the file's new content."""
        data = self.data
        for start, end, new in sorted(set(self._edits), reverse=True):
            data = data[:start] + new + data[end:]
        return data

    @property
    def is_edited(self) -> bool:
        """Is there anything to change?"""
        return bool(self._edits)


def convert(scene: ParsedScene, result: Path, parameters: dict[str, str]) -> Conversion:
    """Return what the converted scene and its included files are to contain. Nothing is written."""
    changed = [light for light in scene.convertible if light.emitter == BUILT_IN]
    if not changed:
        if scene.convertible:
            raise UserError(f"nothing to do: the sphere lights of '{scene.path}' are spherecaps already")
        raise UserError(scene.explain_no_lights())
    files = [_File(path) for path in scene.files]
    variables = _variables(files, parameters)
    tags = defaultdict(list)
    for light in changed:
        node = scene.state.nodes[light.node]
        file = files[node.file_index]
        tags[node.file_index].append(file.by_start[node.offset - 1])  # it counts from behind the <
    for index, lights in tags.items():
        _change_emitters(files[index], lights, variables, alone=len(files) == 1)
    return Conversion(_place(scene, files, result, variables), changed)


def _variables(files: list[_File], parameters: dict[str, str]) -> dict[str, str]:
    """Return what `$name` stands for."""
    defaults = [e.values for file in files for e in file.elements if e.tag == "default"]
    return {one["name"]: one["value"] for one in reversed(defaults)} | parameters


def _substitute(text: str, variables: dict[str, str]) -> str:
    return re.sub(r"\$(\w+)", lambda match: variables.get(match[1], match[0]), text)


def _change_emitters(file: _File, lights: list[Element], variables: dict[str, str], alone: bool) -> None:
    """Change `type="area"` in place; of `type="$name"` change the default, if these lights alone read it."""
    for light in lights:
        name = light.values["type"].removeprefix("$")
        users = [e for e in file.elements if any(f"${name}" in value for value in e.values.values())]
        defaults = [e for e in file.elements if e.tag == "default" and e.values["name"] == name]
        shared = [user for user in users if user not in lights]
        theirs = alone and not shared and [e.values["value"] for e in defaults] == [BUILT_IN]
        if light.values["type"] == f"${name}" and theirs:
            file.set(defaults[0], "value", OURS)
        else:
            file.set(light, "type", OURS)


def _place(
    scene: ParsedScene, files: list[_File], result: Path, variables: dict[str, str]
) -> dict[Path, bytes]:
    """Name the files to be written, and make them find each other and what they refer to."""
    by_path = {file.path: file for file in files}
    names = {files[0].path: result}
    # From the innermost include outwards: a file that includes a changed one changes itself.
    for file in reversed(files):
        for element in file.elements:
            if element.tag != "include":
                continue
            included = by_path.get(scene.resolve(_substitute(element.values["filename"], variables)))
            if included is not None and included.is_edited:
                number = files.index(included)  # as two of them may have the same name, in different folders
                names[included.path] = result.with_name(f"{result.stem}-{number}-{included.path.name}")
                file.set(element, "filename", names[included.path].name)
    here, there = files[0].path.parent, result.resolve().parent
    if here != there:
        root = files[0].elements[0]
        back = os.path.relpath(here, there)
        for element in files[0].elements:
            value = element.values.get("value", "")
            if element.tag == "path" and not os.path.isabs(value) and "$" not in value:
                files[0].set(element, "value", os.path.join(back, value))
        files[0].insert_after(root, f'<path value="{html.escape(back)}"/>')
    return {names[file.path]: file.edited() for file in reversed(files) if file.path in names}


def write(conversion: Conversion) -> None:
    """Write all files or, if one of them exists or cannot be written, none."""
    written = []
    try:
        for path, data in conversion.files.items():
            with path.open("xb") as stream:
                written.append(path)
                stream.write(data)
    except OSError as error:
        for path in written:
            path.unlink()
        if isinstance(error, FileExistsError):
            raise UserError(f"'{error.filename}' exists: remove it, or choose another name") from error
        raise UserError(f"'{error.filename}' cannot be written: {error.strerror}") from error

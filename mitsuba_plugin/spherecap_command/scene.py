"""The sphere lights of any scene, found by Mitsuba's own parser: includes, references, defaults resolved.

Whether a light can be a `spherecap` is the plugin's decision: each sphere is made once, alone, and what the
plugin says against it is the reason to leave it as it is.
"""

import contextlib
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import mitsuba as mi

from spherecap_command.errors import UserError

BUILT_IN = "area"
OURS = "spherecap"

# What `area` does not know. Mitsuba refuses parameters that nobody asks for.
OWN_PARAMETERS = ("technique", "hemispheres", "defensive", "lights")


def best_variant() -> str:
    """Return the variant to render with where none is asked for: LLVM's where somebody has chosen an LLVM.

    That is the one of `pip install '.[llvm]'`, or the user's. One that Dr.Jit would find by itself may be too
    old for the processor, and then ends the program.
    """
    return "llvm_ad_rgb" if Path(os.environ.get("DRJIT_LIBLLVM_PATH", "")).is_file() else "scalar_rgb"


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Keep Mitsuba's warnings back, for what has been loaded before and has said them once."""
    before = mi.log_level()
    mi.set_log_level(mi.LogLevel.Error)
    try:
        yield
    finally:
        mi.set_log_level(before)


def use_variant(variant: str) -> None:
    """Select a Mitsuba variant, or raise with the list of variants that there are."""
    if variant not in mi.variants():
        raise UserError(f"Mitsuba has no variant '{variant}'; choose one of: {', '.join(mi.variants())}")
    try:
        mi.set_variant(variant)
    except Exception as error:  # Mitsuba raises ImportError or RuntimeError, e.g. for lack of a GPU.
        raise UserError(f"the variant '{variant}' does not work on this machine: {error}") from error


def resize(scene: "mi.Scene", size: int | None, most: int | None) -> None:
    """Give the image so many pixels along its longer side; no more than `most` if there is no size."""
    parameters = mi.traverse(scene.sensors()[0])
    if "film.size" not in parameters:  # a sensor that fixes it
        return
    side = max(parameters["film.crop_size"])
    factor = (size or min(side, most or side)) / side
    if factor != 1:
        for name, least in (("film.size", 1), ("film.crop_size", 1), ("film.crop_offset", 0)):
            parameters[name] = [max(int(x * factor + 1e-6), least) for x in parameters[name]]
        parameters.update()


@dataclass(frozen=True)
class Light:
    """An area light, with either emitter.

    node: its emitter, in the parser's list. where: file and line. refusal: why it cannot be a `spherecap`;
    empty if it can.
    """

    node: int
    emitter: str
    where: str
    refusal: str


class ParsedScene:
    """A scene as parsed, before anything is loaded, and its lights."""

    def __init__(self, path: Path, parameters: dict[str, str]):
        """Parse a file; parameters replace the values of its `<default>`s. Needs a variant to be set."""
        if not path.is_file():
            raise UserError(f"there is no file '{path}'")
        self.path = path
        # Beside the scene is where its meshes and textures are; the parser adds the paths that it names.
        self._resolver = mi.FileResolver(mi.file_resolver())
        self._resolver.prepend(str(path.resolve().parent))
        self._config = mi.parser.ParserConfig(mi.variant())
        with self._searching(), explained(f"Mitsuba cannot read '{path}'"):
            self.state = mi.parser.parse_file(self._config, str(path), **parameters)
            mi.parser.transform_upgrade(self._config, self.state)
            mi.parser.transform_resolve(self._config, self.state)
        self.files = [Path(str(file)).resolve() for file in self.state.files]
        self.lights = list(self._find_lights())

    @property
    def convertible(self) -> list[Light]:
        """The lights that can be a `spherecap`, or are one."""
        return [light for light in self.lights if not light.refusal]

    @property
    def refused(self) -> list[Light]:
        """The lights that stay as they are."""
        return [light for light in self.lights if light.refusal]

    @property
    def integrator(self) -> "mi.Properties":
        """What the scene says of its integrator."""
        return next(iter(self._parts(mi.ObjectType.Integrator).values()))

    @property
    def sensors(self) -> list[str]:
        """The sensors' ids, in the scene's order; empty for those without."""
        return [
            "" if props.id().startswith("_arg_") else props.id()
            for props in self._parts(mi.ObjectType.Sensor).values()
        ]

    def load(self, emitter: str, sensor: int = 0, **own: str) -> "mi.Scene":
        """Load the scene with `emitter` on every light that can be a `spherecap`, and one of its sensors.

        own: parameters of ours for all these lights, in place of what the scene says.
        """
        state = mi.parser.ParserState(self.state)
        for light in self.convertible:
            _change(state.nodes[light.node], emitter)
            for name, value in own.items():
                state.nodes[light.node].props[name] = value
        for number, name in enumerate(self._parts(mi.ObjectType.Sensor)):
            if number != sensor:
                del state.nodes[0].props[name]
        with self._searching(), explained(f"Mitsuba cannot load '{self.path}'"):
            mi.parser.transform_all(self._config, state)
            return mi.parser.instantiate(self._config, state)

    def resolve(self, name: str) -> Path:
        """Return the file that the scene means by a name."""
        return Path(str(self._resolver.resolve(name))).resolve()

    def must_be_renderable(self) -> None:
        """Raise if it lacks what a render needs. (What only has lights can be converted.)"""
        for kind, why in (
            (mi.ObjectType.Sensor, "sensor: without a camera there is nothing to render and compare"),
            (mi.ObjectType.Integrator, 'integrator: add one, <integrator type="path"/> for instance'),
        ):
            if not self._parts(kind):
                raise UserError(f"'{self.path}' has no {why}")

    def explain_no_lights(self) -> str:
        """Say why there is nothing to convert or compare."""
        text = f"'{self.path}' has no sphere light: no <shape type=\"sphere\"> with an area emitter"
        refused = [f"\n  {light.where}: {light.refusal}" for light in self.refused]
        return text + (" that could be a spherecap:" + "".join(refused) if refused else "")

    def _find_lights(self) -> Iterator[Light]:
        for number, shape in enumerate(self.state.nodes):
            if shape.type != mi.ObjectType.Shape:
                continue
            for child in _children(shape).values():
                emitter = self.state.nodes[child].props.plugin_name()
                if emitter in (BUILT_IN, OURS):
                    where = mi.parser.file_location(self.state, self.state.nodes[child])
                    yield Light(child, emitter, where, self._refusal(number, child))

    def _parts(self, kind: "mi.ObjectType") -> dict[str, "mi.Properties"]:
        """Return what the scene has of a kind, by the names among its children."""
        children = {name: self.state.nodes[child] for name, child in _children(self.state.nodes[0]).items()}
        return {name: node.props for name, node in children.items() if node.type == kind}

    def _refusal(self, shape: int, emitter: int) -> str:
        """Return what speaks against a `spherecap` there; raise if nothing could be there, as it is wrong."""
        kind = self.state.nodes[shape].props.plugin_name()
        if kind != "sphere":  # without loading it, as it may be a large mesh
            return f"its shape is a '{kind}', not a sphere"
        try:
            self._load_alone(shape, emitter, OURS)
        except RuntimeError as error:
            with explained(f"Mitsuba cannot load '{self.path}'"):
                self._load_alone(shape, emitter, BUILT_IN)
            return _sentence(error)
        return ""

    def _load_alone(self, shape: int, emitter: int, technique: str) -> None:
        state = mi.parser.ParserState(self.state)
        _change(state.nodes[emitter], technique)
        state.nodes[0] = mi.parser.SceneNode(state.nodes[shape])  # the root: all else is left out
        with self._searching(), quiet():
            mi.parser.instantiate(self._config, state)

    @contextlib.contextmanager
    def _searching(self) -> Iterator[None]:
        """Search for files where the scene would; afterwards the search path is what it was."""
        before = mi.file_resolver()
        mi.set_file_resolver(self._resolver)
        try:
            yield
        finally:
            mi.set_file_resolver(before)


def _children(node: "mi.parser.SceneNode") -> dict[str, int]:
    """Return the nodes that a node refers to, by the names that it has for them."""
    props = node.props
    names = props.keys()
    return {
        name: props.get(name).index()
        for name in names
        if props.type(name) == mi.Properties.Type.ResolvedReference
    }


def _change(node: "mi.parser.SceneNode", emitter: str) -> None:
    node.props.set_plugin_name(emitter)
    if emitter == BUILT_IN:
        for name in OWN_PARAMETERS:
            if name in node.props:
                del node.props[name]


@contextlib.contextmanager
def explained(what: str) -> Iterator[None]:
    """Turn what Mitsuba raises into the user's error, which begins with `what` it could not do."""
    try:
        yield
    except RuntimeError as error:
        raise UserError(f"{what}: {_without_sources(error)}") from error


def _sentence(error: RuntimeError) -> str:
    """Return what a plugin said, without the places that it went through."""
    return re.split(r"\[[\w.]+(?::\d+)?\] ", str(error))[-1].strip()


def _without_sources(error: RuntimeError) -> str:
    """Return what Mitsuba said, without the places in its sources: those in the scene tell more."""
    return re.sub(r"\[\w+\.\w+:\d+\] ", "", str(error)).strip()

"""The scene files: each says what it shows, has its emitter switch, and is covered by the plan."""

import re
import xml.etree.ElementTree as ElementTree

import pytest
from plan import PLANS
from renderlab.scenes import scene_file, scene_names
from spherecap_command.errors import UserError


def test_every_scene_is_planned() -> None:
    """A scene that no test renders would only look tested."""
    assert {plan.scene for plan in PLANS} == set(scene_names())
    assert len({plan.name for plan in PLANS}) == len(PLANS), "two plans share a name"


@pytest.mark.parametrize("name", scene_names())
def test_scene_file(name: str) -> None:
    """Two lines of comment first, the defaults that tests and demo set, and a switch on every light."""
    text = scene_file(name).read_text()
    comment = re.match(r"<!--(.*?)-->\n<scene", text, re.DOTALL)
    assert comment, "starts with a comment"
    assert len(comment[1].splitlines()) == 2, "the comment says in two lines what the scene is there to show"
    root = ElementTree.fromstring(text)
    defaults = {entry.get("name"): entry.get("value") for entry in root.findall("default")}
    assert defaults["emitter"] == "spherecap"
    assert {"spp", "width", "height", "sampler", "fov", "target"} <= set(defaults)
    lights = [shape for shape in root.iter("shape") if shape.find("emitter") is not None]
    assert lights
    for light in lights:
        assert light.get("type") == "sphere"
        assert light.find("emitter").get("type") == "$emitter"


def test_unknown_scene_is_named_with_the_choices() -> None:
    """The message is what the demo shows."""
    with pytest.raises(UserError, match=r"no scene 'moon'.*open_floor"):
        scene_file("moon")

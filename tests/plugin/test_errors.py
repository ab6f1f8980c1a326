"""Every refusal says what is wrong and what to do."""

import mitsuba as mi
import pytest
from lights import light

SPHERE = {"type": "sphere", "emitter": {"type": "spherecap"}}


def shape(**changes):
    """A light, with changes to its sphere."""
    return {**SPHERE, **changes}


def emitter(**parameters):
    """A light, with parameters of its emitter."""
    return {"type": "sphere", "emitter": {"type": "spherecap", **parameters}}


def transform():
    """The identity."""
    return mi.ScalarTransform4f()


# What is built, and words of the message: the fault, and the way out.
REFUSALS = {
    "not a sphere": (
        lambda: shape(type="cube"),
        "must be attached to a .sphere..*Cube.*use the .area. emitter",
    ),
    "stretched": (
        lambda: shape(to_world=transform().scale([1, 1, 1.01])),
        "uniformly scaled.*use the .area.",
    ),
    "sheared": (
        lambda: shape(
            to_world=transform()
            @ mi.ScalarTransform4f([[1, 0.01, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        ),
        "uniformly scaled.*without shear.*use the .area.",
    ),
    "no radius": (lambda: shape(radius=0.0), "must have a positive radius"),
    "flipped normals": (
        lambda: shape(flip_normals=True),
        "flipped normals.*remove the flip, or use the .area.",
    ),
    "mirrored": (lambda: shape(to_world=transform().scale(-1)), "flipped normals.*mirroring.*use the .area."),
    "transformed emitter": (
        lambda: emitter(to_world=transform().translate([1, 0, 0])),
        "takes no .to_world.: it follows its sphere, so transform the sphere",
    ),
    "textured": (
        lambda: emitter(radiance={"type": "checkerboard"}),
        "must not vary over the sphere: use the .area. emitter",
    ),
    "technique": (
        lambda: emitter(technique="cosine"),
        'technique "cosine".*use one of "projected", "projected_bounded", "solid_angle"',
    ),
    "hemispheres": (
        lambda: emitter(hemispheres="back"),
        'hemispheres "back".*use one of "auto", "front", "both"',
    ),
    "defensive above": (lambda: emitter(defensive=1.01), r"probability in \[0, 1\], not 1.01"),
    "defensive below": (lambda: emitter(defensive=-0.1), r"probability in \[0, 1\], not -0.1"),
    "defensive NaN": (lambda: emitter(defensive=float("nan")), r"probability in \[0, 1\], not -?nan"),
    "unknown parameter": (lambda: emitter(tecnique="projected"), "unreferenced property.*tecnique"),
    "two emitters": (lambda: shape(other={"type": "spherecap"}), "Only a single Emitter"),
}


@pytest.mark.parametrize("name", REFUSALS)
def test_refusal(variant, name):
    """The message names the fault and the way out."""
    scene, message = REFUSALS[name]
    with pytest.raises(RuntimeError, match=f"(?s){message}"):
        mi.load_dict(scene())


def test_the_limits_are_accepted(scalar_rgb):
    """The other side of each threshold."""
    for defensive in (0.0, 1.0):
        mi.load_dict(emitter(defensive=defensive))
    # Products of transformations are uniform only up to rounding.
    rounded = transform().rotate([0.6, 0.8, 0], 33).scale(1e3).rotate([0, 0.6, 0.8], 77).scale(1e-3)
    mi.load_dict(shape(to_world=rounded))
    mi.load_dict(shape(to_world=transform().scale([1, 1, 1 + 0.5e-4])))
    mi.load_dict(shape(radius=1e-6))
    mi.load_dict(shape(radius=1e6))


def test_stretching_later_is_refused(scalar_rgb):
    """By `update`, which is told of the change."""
    sphere = light()
    params = mi.traverse(sphere)
    params["to_world"] = mi.Transform4f().scale([1, 2, 1])
    with pytest.raises(RuntimeError, match="uniformly scaled"):
        params.update()


def test_an_emitter_has_one_sphere(scalar_rgb):
    """As every emitter."""
    shared = mi.load_dict({"type": "spherecap"})
    first = mi.load_dict({"type": "sphere", "emitter": shared})
    with pytest.raises(RuntimeError, match="only be attached to a single shape"):
        mi.load_dict({"type": "sphere", "emitter": shared})
    assert first.emitter() == shared


def test_an_emitter_without_a_sphere(scalar_rgb):
    """It can be printed."""
    loose = mi.load_dict({"type": "spherecap"})
    assert "no shape attached" in str(loose)

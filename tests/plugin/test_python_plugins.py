"""Scenes whose BSDFs, textures and meshes are written in Python: they load, and are lit as by `area`."""

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

VARIANTS = ["scalar_rgb", "llvm_ad_rgb"]


@pytest.fixture(params=VARIANTS, autouse=True)
def variant(request):
    """Every test runs where Python is called for each point, and where it is recorded."""
    mi.set_variant(request.param)


def register(**changed):
    """Register a diffuse BSDF, `python`, with some of its methods changed.

    A class belongs to the variant that it was defined in.
    """

    class Diffuse(mi.BSDF):
        def __init__(self, props):
            super().__init__(props)
            self.m_flags = mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide
            self.m_components = [self.m_flags]
            changed.get("init", lambda self: None)(self)

        def eval(self, context, si, wo, active=True):
            cos_i, cos_o = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
            lit = changed.get("lit", lambda cos_i, cos_o: (cos_i > 0) & (cos_o > 0))(cos_i, cos_o)
            return dr.select(lit, mi.Color3f(0.8 / dr.pi) * dr.abs(cos_o), 0)

        def pdf(self, context, si, wo, active=True):
            return dr.abs(mi.Frame3f.cos_theta(wo)) / (2 * dr.pi)

        def eval_pdf(self, context, si, wo, active=True):
            return self.eval(context, si, wo, active), self.pdf(context, si, wo, active)

        def sample(self, context, si, sample1, sample2, active=True):
            return mi.BSDFSample3f(), mi.Color3f(0)

        def traverse(self, callback):
            changed.get("traverse", lambda self, callback: None)(self, callback)

        def to_string(self):
            return "Diffuse[]"

    mi.register_bsdf("python", Diffuse)
    return {"type": "python"}


def transmitting(bsdf):
    """Change the flags to those of a BSDF that transmits."""
    bsdf.m_flags = mi.BSDFFlags.DiffuseTransmission | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide


def scene(emitter, floor, below=False, **parameters):
    """Load a floor, lit from above or below, where the emitter alone is sampled."""
    look = mi.ScalarTransform4f().look_at(origin=[0, -5, 6], target=[0, 0, 0], up=[0, 0, 1])
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct", "bsdf_samples": 0, "emitter_samples": 1, "hide_emitters": True},
            "sensor": {
                "type": "perspective",
                "to_world": look,
                "film": {"type": "hdrfilm", "width": 8, "height": 8, "rfilter": {"type": "box"}},
            },
            "floor": floor,
            "light": {
                "type": "sphere",
                "center": [0, 0, -2 if below else 2],
                "radius": 0.5,
                "emitter": {"type": emitter, **parameters},
            },
        }
    )


def floor(bsdf):
    """A rectangle."""
    return {"type": "rectangle", "to_world": mi.ScalarTransform4f().scale(5), "bsdf": bsdf}


def decisions(loaded):
    """What the emitter has decided, as it prints it."""
    lines = [line.strip().rstrip(",") for line in str(loaded.emitters()[0]).splitlines()]
    return [line for line in lines if line.startswith(("hemispheres", "defensive"))]


SAFE = ["hemispheres = both (auto)", "defensive = 0.125 (auto)"]


def same_light(description, below=False):
    """Render it with both emitters: whether the means agree, to four standard errors of the noisier."""
    area, ours = (scene(emitter, description, below) for emitter in ("area", "spherecap"))
    images = [[np.array(mi.render(s, spp=64, seed=i)).mean() for i in range(8)] for s in (area, ours)]
    error = np.std(images, axis=1, ddof=1).max() / np.sqrt(8)
    means = np.mean(images, axis=1)
    return means[1] > 0 and abs(means[0] - means[1]) < 4 * error + 1e-4 * means[0]


#: What may be written for a parameter of a BSDF.
VALUES = {
    "float": lambda: 0.3,
    "int": lambda: 3,
    "bool": lambda: True,
    "str": lambda: "rough",
    "none": lambda: None,
    "list": lambda: [1.0, 2.0],
    "dict": lambda: {"a": 1},
    "numpy": lambda: np.zeros(3),
    "object": object,
    "Float": lambda: mi.Float(0.3),
    "Color3f": lambda: mi.Color3f(0.3),
    "TensorXf": lambda: mi.TensorXf(np.zeros((2, 2, 3))),
    "Transform4f": lambda: mi.Transform4f(),
    "texture": lambda: mi.load_dict({"type": "rgb", "value": 0.5}),
    "bsdf": lambda: mi.load_dict({"type": "diffuse"}),
}


@pytest.mark.parametrize("put", ["put", "put_parameter", "put_object"])
@pytest.mark.parametrize("value", VALUES)
def test_any_parameter_loads(capfd, put, value):
    """Whatever a BSDF exposes, and by whichever method, `area` does not ask; nor is anything reported."""
    exposed = VALUES[value]()

    def traverse(bsdf, callback):
        getattr(callback, put)("roughness", exposed, mi.ParamFlags.NonDifferentiable)

    bsdf = register(traverse=traverse)
    for description in (
        bsdf,
        {"type": "twosided", "bsdf": bsdf},
        {"type": "mask", "opacity": 0.5, "bsdf": bsdf},
    ):
        assert decisions(scene("spherecap", floor(description))) == SAFE
    assert capfd.readouterr() == ("", "")


def test_a_traverse_that_fails():
    """It is not called."""

    def traverse(bsdf, callback):
        raise RuntimeError("not today")

    assert decisions(scene("spherecap", floor(register(traverse=traverse)))) == SAFE


FLAGS = {
    "no components": lambda bsdf: (transmitting(bsdf), setattr(bsdf, "m_components", [])),
    "other components": lambda bsdf: (
        transmitting(bsdf),
        setattr(bsdf, "m_components", [mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide]),
    ),
    "no sides": lambda bsdf: setattr(bsdf, "m_flags", +mi.BSDFFlags.DiffuseTransmission),
    "reflection": lambda bsdf: None,
}


@pytest.mark.parametrize("flags", FLAGS)
def test_flags_that_are_incomplete_or_wrong(flags):
    """A BSDF that transmits is lit from behind, whatever it says of itself."""
    bsdf = register(init=FLAGS[flags], lit=lambda cos_i, cos_o: cos_i * cos_o < 0)
    assert decisions(scene("spherecap", floor(bsdf))) == SAFE
    assert same_light(floor(bsdf), below=True)


def test_given_parameters_are_not_asked_for():
    """Nor guessed."""
    given = {"hemispheres": "front", "defensive": 0.0}
    loaded = scene("spherecap", floor(register()), **given)
    assert decisions(loaded) == ["hemispheres = front", "defensive = 0"]
    one = scene("spherecap", floor(register()), hemispheres="front")
    assert decisions(one) == ["hemispheres = front", "defensive = 0.125 (auto)"]


def test_textures():
    """A texture of Python's as a reflectance, as what perturbs a normal, and as the radiance."""

    class Grey(mi.Texture):
        def __init__(self, props):
            super().__init__(props)

        def eval(self, si, active=True):
            return mi.UnpolarizedSpectrum(0.5)

        def eval_1(self, si, active=True):
            return mi.Float(0.5)

        def eval_1_grad(self, si, active=True):
            return mi.Vector2f(0)

        def eval_3(self, si, active=True):
            return mi.Color3f(0.5)

        def mean(self):
            return mi.Float(0.5)

        def max(self):
            return 0.5

        def traverse(self, callback):
            raise RuntimeError("not today")

        def to_string(self):
            return "Grey[]"

    mi.register_texture("grey", Grey)
    grey = {"type": "grey"}
    diffuse = {"type": "diffuse", "reflectance": grey}
    assert decisions(scene("spherecap", floor(diffuse))) == [
        "hemispheres = front (auto)",
        "defensive = 0 (auto)",
    ]
    assert same_light(floor(diffuse))
    bumps = {"type": "bumpmap", "texture": grey, "bsdf": {"type": "diffuse"}}
    assert decisions(scene("spherecap", floor(bumps)))[1] == "defensive = 0.125 (auto)"
    images = [
        np.array(mi.render(scene(emitter, floor({"type": "diffuse"}), radiance=grey), spp=256)).mean()
        for emitter in ("area", "spherecap")
    ]
    assert images[0] == pytest.approx(images[1], rel=0.02)


def test_meshes():
    """A mesh of a class of Python's."""

    class Square(mi.Mesh):
        def __init__(self):
            super().__init__("square", 4, 2)
            params = mi.traverse(self)
            params["vertex_positions"] = np.ravel([[-5.0, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]])
            params["faces"] = [0, 1, 2, 0, 2, 3]
            params.update()
            self.set_bsdf(mi.load_dict({"type": "diffuse"}))

        def to_string(self):
            return "Square[]"

    square = Square()
    assert decisions(scene("spherecap", square)) == ["hemispheres = front (auto)", "defensive = 0 (auto)"]
    assert same_light(square)

"""What the emitter decides from its scene: which hemispheres, and how much defensive sampling."""

import mitsuba as mi
import numpy as np
import pytest

DIFFUSE = {"type": "diffuse"}
TEXTURE = {"type": "checkerboard"}


def decisions(*shapes, **parameters):
    """Which hemispheres and which defensive fraction a light takes in a scene, and whether by itself."""
    scene = {"type": "scene", "light": {"type": "sphere", "emitter": {"type": "spherecap", **parameters}}}
    for i, shape in enumerate(shapes):
        scene[f"shape{i}"] = shape
    loaded = mi.load_dict(scene)
    return read(loaded.emitters()[0])


def read(emitter):
    """The two decisions, as the emitter prints them."""
    found = {}
    for line in str(emitter).splitlines():
        name, _, value = line.strip().rstrip(",").partition(" = ")
        found[name] = value
    return found["hemispheres"], found["defensive"]


def floor(bsdf):
    """A flat surface."""
    return {"type": "rectangle", "bsdf": bsdf}


def bump(bsdf):
    """A BSDF with a perturbed normal."""
    return {"type": "bumpmap", "texture": TEXTURE, "bsdf": bsdf}


def normal_map(bsdf):
    """The same by another plugin."""
    return {
        "type": "normalmap",
        "normalmap": {"type": "bitmap", "raw": True, "bitmap": flat_bitmap()},
        "bsdf": bsdf,
    }


def flat_bitmap():
    """Normals that happen to be straight."""
    return mi.Bitmap(np.full((2, 2, 3), [0.5, 0.5, 1.0], dtype=np.float32))


def mesh(vertex_normals, flip=1.0):
    """Two triangles with a fold, and normals at their corners: none, their own, or interpolated."""
    positions = np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0], [-1, 0, 1]], dtype=np.float32
    )
    faces = np.array([[0, 1, 2], [3, 4, 5]], dtype=np.uint32)
    edges = positions[faces[:, 1:]] - positions[faces[:, :1]]
    flat = np.cross(edges[:, 0], edges[:, 1])
    flat /= np.linalg.norm(flat, axis=1, keepdims=True)
    normals = np.repeat(flat, 3, axis=0)
    if vertex_normals == "interpolated":
        normals[[0, 3]] = normals[[2, 4]] = (flat[0] + flat[1]) / np.linalg.norm(flat[0] + flat[1])
    elif vertex_normals == "rounded":
        normals = np.round(normals, 3)
    result = mi.Mesh("fold", 6, 2, has_vertex_normals=vertex_normals != "none")
    params = mi.traverse(result)
    params["vertex_positions"] = positions.ravel()
    params["faces"] = faces.ravel()
    if vertex_normals != "none":
        # `update` recomputes the normals of a mesh whose positions change, so they come in a second one.
        params.update()
        params["vertex_normals"] = (flip * normals).astype(np.float32).ravel()
    params.update()
    return result


# BSDF -> hemispheres. Only smooth lobes count, and only if they see the back side or transmit.
HEMISPHERES = {
    "diffuse": (lambda: DIFFUSE, "front"),
    "plastic": (lambda: {"type": "plastic"}, "front"),
    "roughplastic": (lambda: {"type": "roughplastic"}, "front"),
    "conductor": (lambda: {"type": "conductor"}, "front"),
    "roughconductor": (lambda: {"type": "roughconductor"}, "front"),
    "dielectric": (lambda: {"type": "dielectric"}, "front"),
    "thindielectric": (lambda: {"type": "thindielectric"}, "front"),
    "null": (lambda: {"type": "null"}, "front"),
    "mask": (lambda: {"type": "mask", "opacity": 0.5, "bsdf": DIFFUSE}, "front"),
    "blendbsdf": (
        lambda: {"type": "blendbsdf", "weight": 0.5, "a": DIFFUSE, "b": {"type": "dielectric"}},
        "front",
    ),
    "bumpmap": (lambda: bump(DIFFUSE), "front"),
    "twosided": (lambda: {"type": "twosided", "bsdf": DIFFUSE}, "both"),
    "mask of twosided": (
        lambda: {"type": "mask", "opacity": 0.5, "bsdf": {"type": "twosided", "bsdf": DIFFUSE}},
        "both",
    ),
    "blend with twosided": (
        lambda: {
            "type": "blendbsdf",
            "weight": 0.5,
            "a": DIFFUSE,
            "b": {"type": "twosided", "bsdf": DIFFUSE},
        },
        "both",
    ),
    "roughdielectric": (lambda: {"type": "roughdielectric"}, "both"),
    "hair": (lambda: {"type": "hair"}, "both"),
    "principledthin": (lambda: {"type": "principledthin"}, "both"),
    "principled, transmissive": (lambda: {"type": "principled", "spec_trans": 0.5}, "both"),
}

# BSDF -> defensive fraction
DEFENSIVE = {
    "diffuse": (lambda: DIFFUSE, "0"),
    "bumpmap": (lambda: bump(DIFFUSE), "0.125"),
    "normalmap": (lambda: normal_map(DIFFUSE), "0.125"),
    "twosided bumpmap": (lambda: {"type": "twosided", "bsdf": bump(DIFFUSE)}, "0.125"),
    "masked normalmap": (lambda: {"type": "mask", "opacity": 0.5, "bsdf": normal_map(DIFFUSE)}, "0.125"),
    "textured": (lambda: {"type": "diffuse", "reflectance": TEXTURE}, "0"),
}


@pytest.mark.parametrize("name", HEMISPHERES)
def test_hemispheres_of_a_bsdf(variant, name):
    """Also one such surface among others."""
    bsdf, expected = HEMISPHERES[name]
    assert decisions(floor(bsdf()))[0] == f"{expected} (auto)"
    assert decisions(floor(DIFFUSE), floor(bsdf()), floor(DIFFUSE))[0] == f"{expected} (auto)"


@pytest.mark.parametrize("name", DEFENSIVE)
def test_defensive_fraction_of_a_bsdf(variant, name):
    """Also where the one that perturbs the normal is wrapped in others."""
    bsdf, expected = DEFENSIVE[name]
    assert decisions(floor(bsdf()))[1] == f"{expected} (auto)"


@pytest.mark.parametrize("shape", ["rectangle", "cube", "disk", "cylinder", "sphere"])
def test_shapes_with_exact_normals(variant, shape):
    """Boxes and rectangles are meshes with vertex normals, which change nothing."""
    assert decisions({"type": shape}) == ("front (auto)", "0 (auto)")


MESHES = {
    "none": ("front (auto)", "0 (auto)"),
    "flat": ("front (auto)", "0 (auto)"),
    "rounded": ("front (auto)", "0 (auto)"),
    "interpolated": ("front (auto)", "0.125 (auto)"),
}


@pytest.mark.parametrize("vertex_normals", MESHES)
def test_mesh(variant, vertex_normals):
    """Only interpolated normals count, not normals as such."""
    assert decisions(mesh(vertex_normals)) == MESHES[vertex_normals]


def test_mesh_with_normals_against_its_winding(variant):
    """What its BSDF calls the front is below the geometric normal."""
    assert decisions(mesh("flat", flip=-1.0)) == ("both (auto)", "0.125 (auto)")


def test_shapes_in_groups_count(variant):
    """`scene.shapes()` shows instances, not what they repeat."""

    def instanced(shape):
        return (
            {"type": "shapegroup", "id": "group", "shape": shape},
            {"type": "instance", "group": {"type": "ref", "id": "group"}},
        )

    assert decisions(*instanced({"type": "cube"})) == ("front (auto)", "0 (auto)")
    two_sided = {"type": "cube", "bsdf": {"type": "twosided", "bsdf": DIFFUSE}}
    assert decisions(*instanced(two_sided)) == ("both (auto)", "0 (auto)")
    assert decisions(*instanced(mesh("interpolated"))) == ("front (auto)", "0.125 (auto)")


def test_before_there_is_a_scene(variant):
    """The choices that are right in every scene."""
    sphere = mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}})
    assert read(sphere.emitter()) == ("both (auto)", "0.125 (auto)")


def test_every_scene_of_a_light_counts(scalar_rgb):
    """A light that is used in two scenes must be right in both, in either order."""
    plain = {"type": "scene", "floor": floor(DIFFUSE)}
    demanding = {"type": "scene", "floor": floor({"type": "twosided", "bsdf": bump(DIFFUSE)})}
    for scenes in ((plain, demanding), (demanding, plain)):
        sphere = mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}})
        loaded = [mi.load_dict({**scene, "light": sphere}) for scene in scenes]
        assert len(loaded) == 2
        assert read(sphere.emitter()) == ("both (auto)", "0.125 (auto)")


def test_parameters_override(variant):
    """And are printed as such."""
    demanding = floor({"type": "twosided", "bsdf": bump(DIFFUSE)})
    assert decisions(demanding, hemispheres="front", defensive=0.0) == ("front", "0")
    assert decisions(floor(DIFFUSE), hemispheres="both", defensive=0.5) == ("both", "0.5")


def test_decisions_reach_the_sampler(scalar_rgb):
    """The printed words are what happens: a light below the horizon is sampled in a two-sided scene only."""
    for bsdf, lit in ((DIFFUSE, False), ({"type": "twosided", "bsdf": DIFFUSE}, True)):
        light = {"type": "sphere", "center": [0, 0, -3], "emitter": {"type": "spherecap"}}
        scene = mi.load_dict({"type": "scene", "light": light, "floor": floor(bsdf)})
        it = mi.SurfaceInteraction3f()
        it.n = [0, 0, 1]
        ds, _ = scene.sample_emitter_direction(it, [0.3, 0.4], False)
        assert (ds.pdf > 0) == lit

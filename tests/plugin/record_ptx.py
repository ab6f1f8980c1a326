"""Records kernels of a sample and the density of its direction, for each emitter: record_ptx.py FOLDER."""

import sys
from pathlib import Path

import spherecap  # noqa: F401 (before Mitsuba)

import drjit as dr  # isort: skip
import mitsuba as mi  # isort: skip


def sphere(emitter, **parameters):
    """A sphere that shines."""
    return {"type": "sphere", "emitter": {"type": emitter, **parameters}}


def projected(technique="projected", hemispheres="front", defensive=0.0):
    """The emitter with all that it would choose by itself."""
    return sphere("spherecap", technique=technique, hemispheres=hemispheres, defensive=defensive)


SPHERES = {
    "area": sphere("area"),
    "projected": projected(),
    "projected, both sides, defensive": projected(hemispheres="both", defensive=0.125),
    "projected_bounded": projected("projected_bounded", "both"),
    "solid_angle": projected("solid_angle", "both"),
}


def main(folder):
    """Write the PTX of each kernel, named by what it samples."""
    mi.set_variant("cuda_ad_rgb")
    # They have to be kept: an emitter keeps neither its shape nor its scene alive.
    shapes = {name: mi.load_dict(given) for name, given in SPHERES.items()}
    several = mi.load_dict({"type": "scene", "first": projected(), "second": projected()})
    emitters = {name: shape.emitter() for name, shape in shapes.items()}
    emitters["one of several lights"] = several.emitters()[0]
    dr.set_flag(dr.JitFlag.KernelHistory, True)
    for name, emitter in emitters.items():
        it = dr.zeros(mi.SurfaceInteraction3f, 2)
        it.p, it.n = dr.opaque(mi.Point3f, 2, 2), dr.opaque(mi.Normal3f, -0.6, 2)
        u = dr.opaque(mi.Point2f, 0.5, 2)
        dr.eval(it, u)
        dr.kernel_history_clear()
        ds, weight = emitter.sample_direction(it, u)
        # What has the width of the points: constants would have another kernel.
        dr.eval(ds.d, ds.p, ds.n, ds.dist, ds.pdf, weight, emitter.pdf_direction(it, ds))
        (kernel,) = dr.kernel_history([dr.KernelType.JIT])
        Path(folder, name + ".ptx").write_text(kernel["ir"].getvalue())


if __name__ == "__main__":
    main(sys.argv[1])

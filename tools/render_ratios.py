"""Measure what rendering with spherecap costs compared with the built-in emitter, at equal sample counts.

For each scene both emitters are rendered in turns in one process, kernels warm, and the median of the ratios
of neighbouring renders is printed; beside it the operations and the compile time of the kernels (in variants
that compile them).
"""

import argparse
import gc
import sys
import time

import fresh_kernels  # before Dr.Jit
import numpy as np
from renderlab.scenes import load_scene, scene_names  # before Dr.Jit
from spherecap_command.compare import render
from spherecap_command.errors import UserError
from spherecap_command.scene import BUILT_IN, OURS, use_variant

import drjit as dr  # isort: skip


def arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", nargs="*", default=scene_names(), help="names; all by default")
    parser.add_argument("--variant", default="llvm_ad_rgb", help="variant of Mitsuba (default: %(default)s)")
    parser.add_argument("--spp", type=int, default=16, help="samples per pixel (default: %(default)s)")
    parser.add_argument("--width", type=int, default=512, help="pixels (default: %(default)s)")
    parser.add_argument("--rounds", type=int, default=11, help="renders of each (default: %(default)s)")
    parser.add_argument(
        "--mis", action="store_true", help="sample the BSDF, too, where scenes have the choice"
    )
    return parser.parse_args()


def compilation(name: str, emitter: str, parameters: dict) -> tuple[int, float]:
    """Return the operations in the kernels of a render, and the milliseconds that they take to compile."""
    scene = load_scene(name, emitter, **parameters)
    fresh_kernels.forget()
    dr.kernel_history_clear()
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        render(scene, parameters["spp"], seed=0)
        history = [kernel for kernel in dr.kernel_history() if kernel["type"] == dr.KernelType.JIT]
    milliseconds = sum(kernel["codegen_time"] + kernel["backend_time"] for kernel in history)
    return sum(kernel["operation_count"] for kernel in history), milliseconds


def seconds(name: str, emitter: str, parameters: dict, seed: int) -> float:
    """Return the time of a render of a freshly loaded scene, the shortest of three.

    In JIT variants calls are dispatched over all emitters that exist, so only one scene may exist at a time.
    """
    gc.collect()
    scene = load_scene(name, emitter, **parameters)
    times = []
    for i in range(4):
        start = time.perf_counter()
        render(scene, parameters["spp"], seed + i)
        times.append(time.perf_counter() - start)
    return min(times[1:])


def measure(name: str, chosen: argparse.Namespace) -> None:
    """Measure one scene and print a line."""
    parameters = {"width": chosen.width, "height": chosen.width * 3 // 4, "spp": chosen.spp}
    if chosen.mis:
        parameters["bsdf_samples"] = 1
    try:
        load_scene(name, BUILT_IN, **parameters)
    except RuntimeError:
        return  # no such parameter
    emitters = (BUILT_IN, OURS)
    compiled = []
    if chosen.variant.startswith(("llvm", "cuda")):
        for emitter in emitters:
            gc.collect()
            compiled.append(compilation(name, emitter, parameters))
    times = np.array(
        [[seconds(name, emitter, parameters, 4 * i) for emitter in emitters] for i in range(chosen.rounds)]
    )
    built_in, ours = np.median(times, axis=0)
    low, median, high = np.percentile(times[:, 1] / times[:, 0], [25, 50, 75])
    line = f"{name:<15} {built_in:8.3f} {ours:8.3f} {median:7.3f} [{low:.3f}, {high:.3f}]"
    for operations, milliseconds in compiled:
        line += f" {operations:8} {milliseconds:7.0f}"
    print(line, flush=True)


def main() -> None:
    """Measure all scenes."""
    chosen = arguments()
    try:
        use_variant(chosen.variant)
        print(f"{chosen.variant}, {chosen.width} pixels wide, {chosen.spp} spp, {chosen.rounds} rounds")
        print(f"{'scene':<15} {BUILT_IN:>8} {OURS:>8}   ratio  [quartiles]      ops, ms ({BUILT_IN}; {OURS})")
        for name in chosen.scenes:
            measure(name, chosen)
    except UserError as error:
        sys.exit(f"render_ratios: {error}")


if __name__ == "__main__":
    main()

"""The comparison as text."""

from cross.compare import SPP


def scene_table(scene: dict) -> str:
    """Return one scene's table."""
    heads = [
        "bias +- 95 %",
        "p99",
        "blocks",
        *(f"{n} spp" for n in SPP),
        "slope",
        "us/sample",
        "x area, 1",
        "x area, 64",
    ]
    widths = [18, 7, 7, *(8 for _ in SPP), 6, 9, 10, 10]
    jitter = f"; jitter alone gives {scene['jitter_floor']:.4f} at 1 spp" if "jitter_floor" in scene else ""
    lines = [
        f"{scene['name']}: {scene['about']}",
        f"  reference: {scene['reference']}, mean {scene['mean']:.6f}{jitter}",
    ]
    lines.append(" ".join([" " * 32, *(head.rjust(w) for head, w in zip(heads, widths, strict=True))]))
    for row in scene["series"]:
        cells = ["", "", ""]
        if "bias" in row:
            cells = [f"{row['bias']:+.1e} +- {1.96 * row['standard_error']:.0e}"]
            cells += [f"{row['p99']:.2%}", f"{row['p99_blocks']:.2%}"]
        cells += [f"{rmse:.5f}" for rmse in row["rmse"]]
        cells += [f"{row['slope']:.2f}", f"{row['microseconds_per_sample']:.3f}"]
        cells += [f"{row['equal_time'][SPP.index(n)]:.3g}" for n in (1, 64)]
        lines.append(
            " ".join([f"  {row['label']:<30}", *(c.rjust(w) for c, w in zip(cells, widths, strict=True))])
        )
    return "\n".join(lines)


def table(results: dict) -> str:
    """Return everything that is worth printing."""
    size = f"{results['width']} x {results['height']} pixels"
    lines = [
        f"{size}, {results['seeds']} renders of each, on one thread. Bias of the image mean; 99th\n"
        "percentile of the errors of pixels, and of blocks of 4 x 4; relative RMSE at so many samples\n"
        "per pixel; its slope; CPU time; how many times less work than Mitsuba's area (with the same\n"
        "kind of sampler) for the same error, at 1 and 64 samples."
    ]
    lines += [scene_table(scene) for scene in results["scenes"]]
    targets = results["targets"]
    missed = [f"  MISSED  {target['name']}: {target['text']}" for target in targets if not target["ok"]]
    lines.append("\n".join([f"targets: {len(targets) - len(missed)} of {len(targets)} reached", *missed]))
    return "\n\n".join(lines)

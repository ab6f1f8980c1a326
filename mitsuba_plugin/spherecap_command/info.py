"""What `spherecap info` prints: versions, variants, and what the processor has."""

from importlib import metadata
from pathlib import Path

# What the Mitsuba wheel, and so the plugin, is compiled for (`mitsuba --help` prints it), as Linux calls it.
NEEDED = ("sse4_2", "avx2", "fma", "f16c")


def version(package: str) -> str:
    """Return the version of an installed package."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "(not installed)"


def processor() -> tuple[str, set[str]]:
    """Return the processor's name and the names of its features."""
    name, features = "unknown", set()
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        key, _, value = (part.strip() for part in line.partition(":"))
        if key == "model name":
            name = value
        elif key == "flags":
            features = set(value.split())
    return name, features


def usable_variants() -> list[tuple[str, str]]:
    """Return Mitsuba's variants, each with the reason why it cannot be used, or nothing."""
    import mitsuba as mi

    found = []
    for variant in mi.variants():
        try:
            mi.set_variant(variant)
            mi.load_dict({"type": "sphere", "emitter": {"type": "spherecap"}})
            found.append((variant, ""))
        except Exception as error:  # Mitsuba raises ImportError or RuntimeError, for lack of LLVM or a GPU.
            reason = str(error).strip().split("\n")[0].split(". ")[0]
            found.append((variant, f"not on this machine: {reason}"))
    return found

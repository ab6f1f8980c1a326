"""Where the work goes, and what was tried to make it less: experiments, with the figures of their time."""

from report.page import Section, table

# Of the graph that the recorded kernel leaves of a direction and its density, without what has no use in it.
WORK = (
    "<p>Before the kernel followed one side of a branch alone, a direction by <code>solid_angle</code> with "
    "its density, right in single precision at every size and distance, was 201 additions, multiplications, "
    "fused ones, divisions and roots, and 60 comparisons, choices and operations on bits. Of "
    "these</p><ul><li>some 55 tell how far the light's limb is from the horizon and from the point, by "
    "dot products that carry their rounding errors along: the projected solid angle of the published "
    "method, which has none, is off by 100 % at r/d = 0.01 where the horizon cuts the light;</li><li>17 "
    "scale the scene by a power of two: distances of 1e18 and of 1e-18 give what 1 gives;</li><li>some 55 "
    "make a frame towards the zenith, whose vectors have unit length also if that is where the light is: "
    "the offsets of all techniques are in it, and solid angles are mixed with the others;</li><li>some 45 "
    "are the map onto the disk by the area of its segments, which all techniques share.</li></ul><p>A "
    "preparation that is stored takes some 190 instructions more than one whose only sample is drawn in "
    "the same call: numbers wait on the stack until the last branch is decided. The published method has "
    "a third as many numbers to keep.</p>"
)

# What, what came of it, and the decision.
TRIED = (
    ("one division for 1/d, 1/r and 1/(1 + v)", "vectors of the frame lose their unit length", "dropped"),
    (
        "one division for the reciprocals of the frame and the crescent",
        "densities, which need no frame, have to make one: their graph grows",
        "dropped",
    ),
    (
        "the ellipse's area from the crescent's, without the segment that the horizon cuts off",
        "small ellipses drown in the rounding of their share",
        "dropped",
    ),
    (
        "one division, when sampling, for what is left of a random number and for where a slice ends",
        "one division less when recorded; 217 instead of 204 instructions per sample over 16",
        "dropped",
    ),
    ("no vectorisation of straight code by the compiler", "3 % more instructions", "dropped"),
    (
        "a cube root, a polynomial and a square root for disk and crescent together",
        "less for packets and graphs, which follow both sides of a branch; scalars as before",
        "kept",
    ),
    (
        "powers of two by masking the exponent; cube roots by one series",
        "617 instead of 632 instructions (prepare, 1 sample); recorded, 3 to 5 % less time",
        "kept",
    ),
    (
        "what a slice of the crescent has and the disk has not, as one factor of what both share",
        "per sample over 16, 197 instead of 203 instructions, and in case 3, 207 instead of 223",
        "kept",
    ),
    (
        "conditionals in the recorded graph, for sides of at least 12 operations",
        "emitter sampling of neighbouring points: 1.6 times the time of <code>area</code> instead of 2.3 "
        "where nothing is cut, 2.0 instead of 2.3 elsewhere; renders, 3 to 5 % less time",
        "kept",
    ),
    (
        "code of its own for samplers of which nothing is sampled by solid angle alone or in a mixture",
        "a sample of a prepared sampler takes 106 to 125 instructions, by case, instead of 121 to 140",
        "kept",
    ),
    (
        "the power of two thirds by a fit instead of a series, and without the cube root before it; areas in "
        "units that this power needs; polynomials by Horner's rule in the third power; what follows the "
        "chord's length shortened to a fused multiplication and a root",
        "before scalars had that code, nine tenths of the time in one call and per sample over 16",
        "kept",
    ),
    (
        "a copy of the code also for what is not seen",
        "in case 1, 230 instead of 245 instructions in one call; the library takes 97 instead of 36 seconds "
        "to compile, and the plugin is larger than 1.5 MiB",
        "dropped",
    ),
    (
        "a prepared sampler without what only preparing reads, and code of its own for each case",
        "per sample over 16, 134 instead of 138 instructions; 208 bytes instead of 232",
        "kept",
    ),
    (
        "importances of lights in the caller's unit of length, where that is neither large nor small",
        "with 400 lights, 1.9 instead of 2.6 nanoseconds each by AVX2, 1.5 instead of 1.8 by AVX-512",
        "kept",
    ),
    (
        "recordings in which Dr.Jit does not look for what it knows; then one for all lights of a scene",
        "a small image with 100 lights in <code>llvm_ad_rgb</code>: 93 instead of 145 ms, then 54 "
        "(<code>area</code>: 40)",
        "kept",
    ),
    (
        "importances of lights by one division instead of two",
        "7 % less time by AVX2, 5 % more by AVX-512",
        "dropped",
    ),
)


def section() -> Section:
    """Return the text and the table."""
    rows = [list(row) for row in TRIED]
    tried = f'<div class="words">{table(["tried", "result", ""], rows)}</div>'
    return Section("limits", "Where the work goes", WORK + tried)

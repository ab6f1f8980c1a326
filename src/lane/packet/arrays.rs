//! Runs a kernel over arrays, by the instructions that the CPU has.

use super::Packet;
#[cfg(target_arch = "x86_64")]
use super::{avx2::F32x8, avx512::F32x16};
use crate::lane::{Lane, Mask};
use crate::strategy::Strategy;
use core::{ffi::CStr, fmt};

/// What a CPU may have for packets of numbers.
///
/// ```
/// use spherecap::batch::Instructions;
///
/// let widest = Instructions::widest();
/// println!("batches use {widest}; available are:");
/// for instructions in Instructions::ALL.into_iter().filter(|instructions| instructions.are_available()) {
///     println!("{instructions}");
/// }
/// # assert!(widest.are_available());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Instructions {
    /// One number at a time, by what every CPU of its kind has.
    Portable,
    /// Eight: AVX2 and FMA.
    Avx2,
    /// Sixteen: AVX-512F, and all of the above.
    Avx512,
}

impl Instructions {
    /// All there are.
    pub const ALL: [Self; 3] = [Self::Portable, Self::Avx2, Self::Avx512];

    /// The widest that this CPU has: those that batches use.
    #[inline]
    pub fn widest() -> Self {
        if Self::Avx512.are_available() {
            Self::Avx512
        } else if Self::Avx2.are_available() {
            Self::Avx2
        } else {
            Self::Portable
        }
    }

    /// Whether this CPU has them.
    #[inline]
    pub fn are_available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => is_x86_feature_detected!("avx512f") && Self::Avx2.are_available(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// Their name: "AVX-512", "AVX2" or "portable".
    pub(crate) const fn name(self) -> &'static CStr {
        match self {
            Self::Portable => c"portable",
            Self::Avx2 => c"AVX2",
            Self::Avx512 => c"AVX-512",
        }
    }
}

impl fmt::Display for Instructions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name().to_str().expect("names are ASCII"))
    }
}

/// What is computed for each element of the arrays: numbers in, numbers out, and whether the input was bad. A kernel holds what else
/// all elements share.
pub(crate) trait Kernel<const INPUTS: usize, const OUTPUTS: usize>: Copy {
    fn run<L: Lane>(self, strategy: Strategy<L>, inputs: [L; INPUTS]) -> ([L; OUTPUTS], L::Mask);
}

/// Runs a kernel over arrays of one length, and counts where the input was bad.
///
/// # Panics
/// If they differ in length.
pub(crate) fn run_slices<K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    instructions: Instructions,
    strategy: Strategy<f32>,
    inputs: [&[f32]; I],
    outputs: [Option<&mut [f32]>; O],
) -> usize {
    let count = inputs[0].len();
    let check = |length: usize| {
        assert!(
            length == count,
            "an array has {length} numbers, and the first one of the points has {count}"
        );
    };
    inputs.iter().for_each(|input| check(input.len()));
    outputs.iter().flatten().for_each(|output| check(output.len()));
    let inputs = inputs.map(<[f32]>::as_ptr);
    let outputs = outputs.map(|output| output.map_or(core::ptr::null_mut(), <[f32]>::as_mut_ptr));
    assert!(instructions.are_available(), "this CPU does not have {instructions}");
    // SAFETY: the lengths and the CPU were checked, and slices are valid.
    unsafe { run(kernel, instructions, strategy, &inputs, &outputs, count) }
}

/// Runs a kernel over arrays of `count` numbers, and counts where the input was bad.
///
/// # Safety
/// The CPU has the instructions. `count` numbers can be read at each input, and written at each output that is not NULL,
/// without touching what another argument points to.
#[inline]
pub(crate) unsafe fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    instructions: Instructions,
    strategy: Strategy<f32>,
    inputs: &[*const f32; I],
    outputs: &[*mut f32; O],
    count: usize,
) -> usize {
    // SAFETY: the caller's promise.
    unsafe {
        match instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => avx512(kernel, strategy, inputs, outputs, count),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => avx2(kernel, strategy, inputs, outputs, count),
            _ => packets::<f32, K, I, O>(kernel, strategy, inputs, outputs, count),
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
unsafe fn avx512<K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    strategy: Strategy<f32>,
    inputs: &[*const f32; I],
    outputs: &[*mut f32; O],
    count: usize,
) -> usize {
    // SAFETY: the caller's promise.
    unsafe { packets::<F32x16, K, I, O>(kernel, strategy, inputs, outputs, count) }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
unsafe fn avx2<K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    strategy: Strategy<f32>,
    inputs: &[*const f32; I],
    outputs: &[*mut f32; O],
    count: usize,
) -> usize {
    // SAFETY: the caller's promise.
    unsafe { packets::<F32x8, K, I, O>(kernel, strategy, inputs, outputs, count) }
}

/// As [`run`]. What remains after the last whole packet is one with zeros in the place of what there is not.
#[inline(always)]
unsafe fn packets<P: Packet, K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    strategy: Strategy<f32>,
    inputs: &[*const f32; I],
    outputs: &[*mut f32; O],
    count: usize,
) -> usize {
    let mut bad = 0;
    let Strategy { technique, hemispheres, defensive } = strategy;
    let strategy = Strategy { technique, hemispheres, defensive: P::lit(f64::from(defensive)) };
    for first in (0..count).step_by(P::WIDTH) {
        let filled = P::WIDTH.min(count - first);
        let mut packets = [P::lit(0.0); I];
        for i in 0..I {
            // SAFETY: the caller's promise.
            packets[i] = unsafe { P::load(inputs[i].add(first), filled) };
        }
        let (results, is_bad) = kernel.run(strategy, packets);
        for i in 0..O {
            if !outputs[i].is_null() {
                // SAFETY: as above.
                unsafe { results[i].store(outputs[i].add(first), filled) };
            }
        }
        if is_bad.any() {
            const { assert!(P::WIDTH <= WIDEST) };
            let mut ones = [0.0_f32; WIDEST];
            // SAFETY: no packet is wider.
            unsafe { P::select(is_bad, P::lit(1.0), P::lit(0.0)).store(ones.as_mut_ptr(), filled) };
            for one in ones {
                bad += usize::from(one > 0.0);
            }
        }
    }
    bad
}

/// Numbers of the widest packet.
const WIDEST: usize = 16;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lane::lit;

    fn truth(x: bool) -> f64 {
        f64::from(u8::from(x))
    }

    /// Every operation of a lane.
    #[derive(Clone, Copy)]
    struct Operations;

    impl Kernel<3, 20> for Operations {
        #[inline(always)]
        fn run<L: Lane>(self, strategy: Strategy<L>, [a, b, c]: [L; 3]) -> ([L; 20], L::Mask) {
            let number = |mask: L::Mask| L::select(mask, a, strategy.defensive);
            let (less, at_most) = (a.lt(b), b.le(c));
            let results = [
                a + b,
                a - b,
                a * b,
                a / b,
                a + lit(0.1),
                lit(0.1) - a,
                a.fma(b, c),
                -a,
                a.sqrt(),
                a.abs(),
                a.min(b),
                a.max(b),
                number(less),
                number(at_most),
                number(less & at_most),
                number(less | at_most),
                number(!less),
                a.bits(),
                // Of numbers in its range.
                a.abs().min(L::lit(2_147_483_520.0)).float_of_bits(),
                // Wrong, unless some are less where one is, and all only if none is not.
                L::select(less, L::lit(truth(less.any())), L::lit(truth(!less.all()))),
            ];
            (results, less)
        }
    }

    #[test]
    fn operations_on_packets_give_the_bits_of_those_on_scalars() {
        assert!(Instructions::widest().are_available());
        let mut numbers: Vec<f32> =
            vec![0.0, 1.0, 0.1, f32::MIN_POSITIVE, f32::EPSILON, f32::MAX, f32::INFINITY];
        numbers.extend((0..=40).map(|i| f32::from_bits(i * 0x0333_3333 + i % 3)));
        numbers.extend([f32::from_bits(1), f32::from_bits(0x007f_ffff), f32::NAN]);
        let negative: Vec<f32> = numbers.iter().map(|x| -x).collect();
        numbers.extend(negative);
        let [mut a, mut b, mut c] = [(); 3].map(|()| Vec::new());
        for (i, &x) in numbers.iter().enumerate() {
            for &y in &numbers {
                a.push(x);
                b.push(y);
                c.push(numbers[(3 * i + a.len()) % numbers.len()]);
            }
        }
        // The conversions, over all exponents.
        for i in 0..1 << 18 {
            a.push(f32::from_bits(i << 14 | i & 0x3fff));
            b.push(1.0);
            c.push(0.5);
        }
        let strategy = Strategy { defensive: -7.0, ..Strategy::default() };
        let results = |instructions| {
            let mut results = [(); 20].map(|()| vec![0.0_f32; a.len()]);
            let outputs = results.each_mut().map(|result| Some(&mut result[..]));
            let less = run_slices(Operations, instructions, strategy, [&a, &b, &c], outputs);
            assert_eq!(less, a.iter().zip(&b).filter(|(a, b)| a < b).count());
            results
        };
        let expected = results(Instructions::Portable);
        for instructions in Instructions::ALL.into_iter().filter(|i| i.are_available()) {
            println!("instruction set exercised: {instructions}");
            for (operation, (found, expected)) in results(instructions).iter().zip(&expected).enumerate() {
                for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
                    // Which NaN an operation gives is nobody's promise.
                    let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                    let (a, b, c) = (a[i], b[i], c[i]);
                    assert!(
                        same,
                        "{instructions}, {operation}: {found:e}, not {expected:e}, for {a:e} {b:e} {c:e}"
                    );
                }
            }
        }
    }
}

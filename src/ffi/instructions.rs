//! Which instructions the C ABI uses: the best that the CPU has, unless the environment names others.

use super::single::spherecap_status_t as Status;
use crate::batch::Instructions;
use core::ffi::CStr;
use core::sync::atomic::{AtomicU8, Ordering::Relaxed};

/// 0 until the environment was read; then the place in [`Instructions::ALL`], from 1; [`NONE`] where it names none of them.
static CHOICE: AtomicU8 = AtomicU8::new(0);
const NONE: u8 = u8::MAX;

/// The instructions to use, or the status that the environment names none of this CPU's.
#[inline]
pub(super) fn instructions() -> Result<Instructions, u32> {
    let known = CHOICE.load(Relaxed);
    // Threads that read it at once find the same.
    let choice = if known == 0 { read() } else { known };
    match choice {
        1 => Ok(Instructions::Portable),
        2 => Ok(Instructions::Avx2),
        3 => Ok(Instructions::Avx512),
        _ => Err(Status::SPHERECAP_STATUS_INSTRUCTIONS as u32),
    }
}

#[cold]
fn read() -> u8 {
    // SAFETY: the name ends with a zero. (The standard library's function would allocate.)
    let word = unsafe { libc::getenv(c"SPHERECAP_INSTRUCTIONS".as_ptr()) };
    // SAFETY: what the environment holds ends with a zero, too, and is not changed meanwhile.
    let word = if word.is_null() { &[] } else { unsafe { CStr::from_ptr(word) }.to_bytes() };
    let named = match word {
        b"" => Some(Instructions::widest()),
        b"portable" => Some(Instructions::Portable),
        b"avx2" => Some(Instructions::Avx2),
        b"avx512" => Some(Instructions::Avx512),
        _ => None,
    };
    let choice = match named.filter(|named| named.are_available()) {
        Some(Instructions::Portable) => 1,
        Some(Instructions::Avx2) => 2,
        Some(Instructions::Avx512) => 3,
        None => NONE,
    };
    CHOICE.store(choice, Relaxed);
    choice
}

//! Counts the instructions that functions take, those that they call included: the kernel runs the program step by step, so that
//! every instruction counts that the CPU has, and nothing else that the machine does.

use std::io::{Error, Result};

/// Runs `work` in a child process, and returns how many instructions it spends in functions that begin at one of `entries`.
pub fn count(entries: &[u64], work: impl FnOnce()) -> Result<u64> {
    // Where both run on one CPU, the one's end need not wake another for the other.
    // SAFETY: all zeros are an empty set of CPUs; this thread may run where it runs.
    unsafe {
        let mut set: libc::cpu_set_t = std::mem::zeroed();
        libc::CPU_SET(libc::sched_getcpu().max(0) as usize, &mut set);
        libc::sched_setaffinity(0, size_of::<libc::cpu_set_t>(), &set);
    }
    // SAFETY: this program has one thread, so the child can do all that it can.
    match unsafe { libc::fork() } {
        -1 => Err(Error::last_os_error()),
        0 => {
            // SAFETY: plain system calls; the child ends here, without the parent's destructors.
            unsafe {
                if libc::ptrace(libc::PTRACE_TRACEME, 0, 0, 0) == -1 {
                    libc::_exit(1);
                }
                libc::raise(libc::SIGSTOP);
                work();
                libc::_exit(0)
            }
        }
        child => follow(child, entries),
    }
}

/// Follows the child to its end. Between an entry and the address that it returns to, every step counts.
fn follow(child: libc::pid_t, entries: &[u64]) -> Result<u64> {
    let failed = |result: libc::c_long| if result == -1 { Err(Error::last_os_error()) } else { Ok(()) };
    let (mut count, mut return_address) = (0, None);
    loop {
        let mut status = 0;
        // SAFETY: `child` is ours, and `status` is a place for the answer.
        failed(unsafe { libc::waitpid(child, &mut status, 0) }.into())?;
        if libc::WIFEXITED(status) && libc::WEXITSTATUS(status) == 0 {
            return Ok(count);
        }
        if !libc::WIFSTOPPED(status) {
            return Err(Error::other(format!("the child ended with the status {status:#x}")));
        }
        // SAFETY: all numbers, so all zeros are a value.
        let mut registers: libc::user_regs_struct = unsafe { std::mem::zeroed() };
        // SAFETY: the child has stopped; `registers` is a place for them.
        failed(unsafe { libc::ptrace(libc::PTRACE_GETREGS, child, 0, &mut registers) })?;
        if return_address == Some(registers.rip) {
            return_address = None;
        }
        if return_address.is_none() && entries.contains(&registers.rip) {
            // SAFETY: at a function's entry the return address is on top of the stack.
            let top = unsafe { libc::ptrace(libc::PTRACE_PEEKDATA, child, registers.rsp, 0) };
            return_address = Some(top as u64);
        }
        count += u64::from(return_address.is_some());
        // SAFETY: the child has stopped.
        failed(unsafe { libc::ptrace(libc::PTRACE_SINGLESTEP, child, 0, 0) })?;
    }
}

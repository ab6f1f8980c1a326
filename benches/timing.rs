//! Times of several pieces of work, in rounds that go through all of them: what else the machine does hits all alike.

use crate::calls::Work;
use std::time::{Duration, Instant};

/// Rounds that count. Medians over so many repeat to about two units in their second digit on a machine that others use, too.
pub const ROUNDS: usize = 101;

/// What a work runs for before it is timed. A CPU that has run AVX-512 stays slower for 0.7 milliseconds, which would be counted to
/// the next; and caches and branch predictors know the last one.
const WARM_UP: Duration = Duration::from_millis(1);

/// Nanoseconds per call of each work in each round.
pub fn rounds(works: &mut [Work<'_>]) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::with_capacity(ROUNDS); works.len()];
    for _ in 0..ROUNDS {
        for (work, times) in works.iter_mut().zip(&mut times) {
            let warm_up = Instant::now();
            while warm_up.elapsed() < WARM_UP {
                (work.run)();
            }
            let start = Instant::now();
            (work.run)();
            times.push(start.elapsed().as_secs_f64() * 1e9 / work.calls as f64);
        }
    }
    times
}

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The median of the ratios within the rounds.
pub fn ratio(times: &[f64], baseline: &[f64]) -> f64 {
    median(times.iter().zip(baseline).map(|(time, baseline)| time / baseline).collect())
}

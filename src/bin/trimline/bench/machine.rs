//! What one core of this machine can do at most, measured here and now.

use std::convert::Infallible;
use std::hint::black_box;

use trimline::kernels::{InstructionSet, Rows, peak};

use super::Row;
use super::clock::Clock;

/// Of the buffer that is written past the caches: 24 MB, as large as a million vertices.
const STREAMED: usize = 3_000_000;
/// Of the buffer that stays in the second-level cache: 160 KB, 80 rows of 256 values.
const CACHED: [usize; 2] = [80, 256];
/// Rounds of multiply-adds in one repetition.
const ROUNDS: usize = 10_000;

/// The limits of one core.
pub struct Machine {
    pub instructions: &'static str,
    /// Bytes a second written past the caches.
    pub store: f64,
    /// Bytes a second written to the second-level cache.
    pub cached_store: f64,
    /// Fused multiply-adds of doubles a second.
    pub multiply_adds: f64,
}

impl Machine {
    pub fn measure(clock: &Clock) -> Machine {
        let set = InstructionSet::best();
        let seconds = |work: &mut dyn FnMut()| {
            let done = clock.fastest(|| {
                work();
                Ok::<(), Infallible>(())
            });
            done.unwrap_or(f64::NAN)
        };
        let mut buffer = vec![0.0; STREAMED];
        let streamed = seconds(&mut || peak::stream(black_box(&mut buffer), 1.0));
        let [rows, length] = CACHED;
        let mut cached = Rows::zeros(rows, length);
        let filled = seconds(&mut || {
            for row in black_box(&mut cached).iter_mut() {
                peak::fill(set, row, 1.0);
            }
        });
        let multiplied = seconds(&mut || {
            black_box(peak::multiply_add(set, black_box(ROUNDS), black_box(0.5), black_box(0.5)));
        });
        Machine {
            instructions: set.name(),
            store: (8 * STREAMED) as f64 / streamed,
            cached_store: (8 * rows * length) as f64 / filled,
            multiply_adds: (ROUNDS * peak::MULTIPLY_ADDS) as f64 / multiplied,
        }
    }

    /// The limits as figures.
    pub fn rows(&self) -> Vec<Row> {
        vec![
            Row::new("store_gb_per_s", "stores past the caches", "GB/s", 1e-9 * self.store),
            Row::new("cached_store_gb_per_s", "stores that stay in the caches", "GB/s", 1e-9 * self.cached_store),
            Row::new("multiply_adds_per_ns", "fused multiply-adds of doubles", "/ns", 1e-9 * self.multiply_adds),
        ]
    }
}

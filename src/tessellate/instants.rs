//! Evenly spaced parameters and instants with exact end points.

use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;

/// The instants of a sequence of `frames` pictures, from the start of `time_range` to its end, both exact.
///
/// One frame is the start. A range whose end lies before its start runs backwards.
///
/// # Errors
/// [`Code::SettingOutOfRange`] for no frames; [`Code::LimitReached`] for more than `limits.frames`;
/// [`Code::EmptyDomain`] when an end of the range is not finite.
pub fn instants(time_range: [f64; 2], frames: usize, limits: &Limits) -> Result<Vec<f64>, Diagnostic> {
    let [start, end] = time_range;
    if frames == 0 {
        return Err(Diagnostic::new(Code::SettingOutOfRange, "a sequence of 0 frames shows nothing")
            .hint("ask for at least 1 frame"));
    }
    if frames > limits.frames {
        return Err(Diagnostic::new(
            Code::LimitReached,
            format!("a sequence of {frames} frames is over the limit frames = {}", limits.frames),
        )
        .hint("ask for fewer frames, or raise the limit `frames`"));
    }
    if !(start.is_finite() && end.is_finite()) {
        return Err(Diagnostic::new(Code::EmptyDomain, format!("the time from {start} to {end} is not finite")));
    }
    Ok(if frames == 1 { vec![start] } else { evenly_spaced(time_range, frames - 1) })
}

/// The `cells + 1` ends of `cells` equal parts of a finite range; the first and the last are the range's own.
pub(super) fn evenly_spaced([start, end]: [f64; 2], cells: usize) -> Vec<f64> {
    let (low, high) = (start.min(end), start.max(end));
    (0..=cells)
        .map(|i| {
            let share = i as f64 / cells as f64;
            // Not start + share * (end - start): that misses `end` by rounding, and overflows for wide ranges.
            (start * (1.0 - share) + end * share).max(low).min(high)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_frame_is_the_start() {
        assert_eq!(instants([0.3, 0.7], 1, &Limits::default()), Ok(vec![0.3]));
    }

    #[test]
    fn several_frames_hit_both_ends_exactly() {
        for frames in [2, 3, 7, 10, 49, 1000] {
            let times = instants([0.1, 0.7], frames, &Limits::default()).unwrap();
            assert_eq!((times.len(), times[0], times[frames - 1]), (frames, 0.1, 0.7));
            assert!(times.is_sorted_by(|a, b| a < b));
        }
    }

    #[test]
    fn frames_of_a_backward_range_descend() {
        assert_eq!(instants([1.0, 0.0], 3, &Limits::default()), Ok(vec![1.0, 0.5, 0.0]));
    }

    #[test]
    fn frames_of_a_range_without_length_are_all_its_one_instant() {
        for t in [0.1, 0.3, 1.7, -2.9] {
            assert_eq!(instants([t, t], 64, &Limits::default()), Ok(vec![t; 64]));
        }
    }

    #[test]
    fn frames_of_the_widest_range_stay_finite() {
        let times = instants([-f64::MAX, f64::MAX], 3, &Limits::default()).unwrap();
        assert_eq!(times, [-f64::MAX, 0.0, f64::MAX]);
    }

    #[test]
    fn no_frames_are_refused() {
        assert_eq!(instants([0.0, 1.0], 0, &Limits::default()).unwrap_err().code, Code::SettingOutOfRange);
    }

    #[test]
    fn frames_at_the_limit_pass_and_one_more_is_refused() {
        let limits = Limits { frames: 5, ..Limits::default() };
        assert_eq!(instants([0.0, 1.0], 5, &limits).unwrap().len(), 5);
        let refused = instants([0.0, 1.0], 6, &limits).unwrap_err();
        assert_eq!(refused.code, Code::LimitReached);
        assert_eq!(refused.message, "a sequence of 6 frames is over the limit frames = 5");
    }

    #[test]
    fn time_without_end_is_refused() {
        assert_eq!(instants([0.0, f64::INFINITY], 2, &Limits::default()).unwrap_err().code, Code::EmptyDomain);
    }
}

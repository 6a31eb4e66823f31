//! The factor by which a corner's twist turns from that of one side into that of the other (Gregory).
//!
//! With x and y the distances from the corner across and along the blend, each in units of its range, the twist
//! `(x a + y b) / (x + y)` is b on the side x = 0 and a on the side y = 0. It is `(a + b)/2 + r (a - b)/2` with
//! `r = (x - y)/(x + y) = 1 - 2 y/(x + y)` (docs/methods.md, H2).

/// `∂^m_x ∂^n_y (x - y)/(x + y)`; 0 at the corner itself, the mean over all directions.
pub(super) fn turn(m: usize, n: usize, x: f64, y: f64) -> f64 {
    let sum = x + y;
    if sum == 0.0 {
        return 0.0;
    }
    // ∂^m_x ∂^n_y 1/(x + y)
    let inverse = |m: usize, n: usize| {
        let total = m + n;
        (1..=total).fold(1.0 / sum, |value, k| -value * k as f64 / sum)
    };
    let one = if m + n == 0 { 1.0 } else { 0.0 };
    let share = y * inverse(m, n) + if n > 0 { n as f64 * inverse(m, n - 1) } else { 0.0 };
    one - 2.0 * share
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_have_their_own_twist() {
        assert_eq!((turn(0, 0, 0.0, 0.3), turn(0, 0, 0.3, 0.0)), (-1.0, 1.0));
    }

    #[test]
    fn derivatives_agree_with_difference_quotients() {
        let (x, y, h) = (0.4, 0.7, 1e-5);
        for m in 0..4 {
            for n in 0..4 {
                let in_x = (turn(m, n, x + h, y) - turn(m, n, x - h, y)) / (2.0 * h);
                let in_y = (turn(m, n, x, y + h) - turn(m, n, x, y - h)) / (2.0 * h);
                // Derivatives of order k are below k! of size; rounding ε/h and truncation h² times 8!.
                assert!((in_x - turn(m + 1, n, x, y)).abs() < 1e-5, "{m} {n}");
                assert!((in_y - turn(m, n + 1, x, y)).abs() < 1e-5, "{m} {n}");
            }
        }
    }
}

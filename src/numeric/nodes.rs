//! Collocation nodes on an interval.

/// Where collocation nodes lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NodeKind {
    /// In the middle of equal cells: `(l - 1/2) / L`.
    #[default]
    Midpoints,
    /// Equally spaced with both ends: `(l - 1) / (L - 1)`; a single node lies in the middle.
    Ends,
    /// The zeros of the Legendre polynomial of degree L.
    Gauss,
    /// The zeros of the Chebyshev polynomial of degree L: `(1 - cos(π(2l - 1)/(2L)))/2`.
    Chebyshev,
}

impl NodeKind {
    /// All kinds with the names users give them.
    pub const NAMED: [(&str, NodeKind); 4] = [
        ("midpoints", NodeKind::Midpoints),
        ("ends", NodeKind::Ends),
        ("gauss", NodeKind::Gauss),
        ("chebyshev", NodeKind::Chebyshev),
    ];
}

/// `count` ascending nodes in `[low, high]`; exact at the ends where a node lies on one.
#[must_use]
pub fn nodes(kind: NodeKind, count: usize, [low, high]: [f64; 2]) -> Vec<f64> {
    // Weights of both ends, so that the last node is `high` itself and not `low + (high - low)`.
    let between = |share: f64| low * (1.0 - share) + high * share;
    let total = count as f64;
    match kind {
        NodeKind::Midpoints => (0..count).map(|l| between((l as f64 + 0.5) / total)).collect(),
        NodeKind::Ends if count < 2 => (0..count).map(|_| between(0.5)).collect(),
        NodeKind::Ends => (0..count).map(|l| between(l as f64 / (total - 1.0))).collect(),
        NodeKind::Gauss => legendre_zeros(count).iter().map(|x| between(0.5 * (1.0 - x))).collect(),
        NodeKind::Chebyshev => {
            let share = |l: usize| 0.5 * (1.0 - libm::cos(std::f64::consts::PI * (l as f64 + 0.5) / total));
            (0..count).map(|l| between(share(l))).collect()
        }
    }
}

/// The nodes and weights of Gauss' rule with `count` nodes: exact for polynomials up to degree `2 count - 1`.
#[must_use]
pub fn gauss_rule(count: usize, range: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
    let weight = |index: usize| {
        let x = legendre_zero(count, index);
        let (_, slope) = legendre(count, x);
        (range[1] - range[0]) / ((1.0 - x * x) * slope * slope)
    };
    (nodes(NodeKind::Gauss, count, range), (0..count).map(weight).collect())
}

/// The zeros of the Legendre polynomial of degree `degree`, from the right; they lie symmetrically.
fn legendre_zeros(degree: usize) -> Vec<f64> {
    let mut zeros: Vec<f64> = (0..degree.div_ceil(2)).map(|index| legendre_zero(degree, index)).collect();
    let mirrored: Vec<f64> = zeros.iter().take(degree / 2).rev().map(|x| -x).collect();
    zeros.extend(mirrored);
    zeros
}

/// Zero number `index`, from the right, of the Legendre polynomial of degree `degree`.
fn legendre_zero(degree: usize, index: usize) -> f64 {
    let angle = std::f64::consts::PI * (index as f64 + 0.75) / (degree as f64 + 0.5);
    let mut x = libm::cos(angle);
    // Newton from this start is quadratic; four steps reach rounding for every degree.
    for _ in 0..6 {
        let (value, slope) = legendre(degree, x);
        let step = value / slope;
        x -= step;
        // The next step would be its square times less than degree².
        if step.abs() <= 1e-12 {
            break;
        }
    }
    x
}

/// The Legendre polynomial and its derivative at |x| < 1, by the three-term recurrence.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (0.0, 1.0);
    for n in 0..degree {
        let n = n as f64;
        (before, value) = (value, ((2.0 * n + 1.0) * x * value - n * before) / (n + 1.0));
    }
    (value, degree as f64 * (before - x * value) / (1.0 - x * x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn end_nodes_are_the_ends_themselves() {
        let high = 2.0 * std::f64::consts::PI;
        let nodes = nodes(NodeKind::Ends, 11, [0.1, high]);
        assert_eq!((nodes.first(), nodes.last()), (Some(&0.1), Some(&high)));
    }

    #[test]
    fn chebyshev_nodes_are_zeros_of_the_chebyshev_polynomial() {
        // The zeros of T3 are 0 and ±sqrt(3)/2.
        let expected = [-0.75_f64.sqrt(), 0.0, 0.75_f64.sqrt()];
        for (node, expected) in nodes(NodeKind::Chebyshev, 3, [-1.0, 1.0]).iter().zip(expected) {
            assert!((node - expected).abs() < 4.0 * f64::EPSILON, "{node} {expected}");
        }
    }

    #[test]
    fn gauss_rule_integrates_the_highest_power_it_should() {
        for count in [1, 2, 5, 24, 48] {
            let (nodes, weights) = gauss_rule(count, [0.0, 2.0]);
            let power = 2 * count - 1;
            let exponent = i32::try_from(power).expect("small");
            let sum: f64 = nodes.iter().zip(&weights).map(|(x, weight)| weight * (0.5 * x).powi(exponent)).sum();
            // ∫ (x/2)^p from 0 to 2 = 2/(p + 1); a rounding error for each term, and p for the power.
            let error = (sum * (power + 1) as f64 / 2.0 - 1.0).abs();
            assert!(error < 4.0 * power as f64 * f64::EPSILON, "{count}: {error:.1e}");
        }
    }

    #[test]
    fn gauss_nodes_are_zeros_of_the_legendre_polynomial() {
        // The zeros of P3 are 0 and ±sqrt(3/5).
        let expected = [-(0.6_f64.sqrt()), 0.0, 0.6_f64.sqrt()];
        for (node, expected) in nodes(NodeKind::Gauss, 3, [-1.0, 1.0]).iter().zip(expected) {
            assert!((node - expected).abs() < 4.0 * f64::EPSILON, "{node} {expected}");
        }
    }
}

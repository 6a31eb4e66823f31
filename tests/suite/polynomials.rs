//! Boundary data and forces that are polynomials about a centre far from v = 0.

use trimline::blend::Blend;
use trimline::diagnostic::Source;
use trimline::method::Options;

use crate::spec::at;

/// `(v - c)^6` about the middle of its range: the closed form is a polynomial of w = v - c whose functions of u are those of
/// the same data about 0.
#[test]
fn powers_about_a_far_centre_keep_their_digits() {
    let spec = |centre: &str, low: &str, high: &str| {
        format!(
            "param c = {centre}\ndomain v in [{low}, {high}]\npde d4S/du4 + 2 d4S/du2dv2 + d4S/dv4 = [0, 0, (v - c)^5]
        at u = 0: S = [(v - c)^6, 0, (v - c)^3], dS/du = [0, (v - c)^4, 1]
        at u = 1: S = [0, (v - c)^6, 0], dS/du = [(v - c)^2, 0, 1]\n"
        )
    };
    let solved = |text: &str| {
        let blend = Blend::compile(&Source::new("spec.trim", text), &Options::default()).expect("a spec");
        let solution = blend.solve(0, 0.0).expect("a solution");
        assert!(solution.report.is_exact);
        let measured = blend.verify(0, &solution, 0.0).expect("finite");
        assert!(measured.boundary_error() < 1e-13 && measured.relative_residual() < 1e-11, "{measured:?}\n{text}");
        solution
    };
    let near = solved(&spec("0", "-1", "1"));
    for (centre, low, high) in [("10", "9", "11"), ("1024", "1023", "1025")] {
        let far = solved(&spec(centre, low, high));
        let centre: f64 = centre.parse().expect("a number");
        for (u, w) in [(0.2, -0.875), (0.5, 0.25), (0.75, 1.0)] {
            let [expected, found] = [(&near, w), (&far, centre + w)].map(|(s, v)| at(&*s.surface, "", [u, v, 0.0]));
            for (expected, found) in expected.iter().zip(found) {
                // v and 1 of (v - c)^3 and (v - c)^5 are as large as c, each rounded.
                assert!(
                    (expected - found).abs() < 1e-15 * (8.0 + 2.0 * centre),
                    "{centre} {u} {w}: {expected} {found}"
                );
            }
        }
    }
}

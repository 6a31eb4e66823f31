//! The kernels against correctly rounded functions, against themselves on every instruction set, and at the edges.

use trimline::kernels::InstructionSet;
use trimline::kernels::elementary as kernel;

/// One function under test.
struct Case {
    name: &'static str,
    one: fn(f64) -> f64,
    block: fn(InstructionSet, &mut [f64], &[f64]),
    #[cfg(unix)]
    rounded: fn(f64) -> f64,
}

macro_rules! cases {
    ($($one:ident $block:ident $rounded:ident)*) => {
        const CASES: &[Case] = &[$(Case {
            name: stringify!($one),
            one: kernel::$one,
            block: kernel::$block,
            #[cfg(unix)]
            rounded: core_math::$rounded,
        },)*];
    };
}

cases! {
    sin sin_block sin
    cos cos_block cos
    tan tan_block tan
    exp exp_block exp
    sinh sinh_block sinh
    cosh cosh_block cosh
    tanh tanh_block tanh
    ln ln_block log
}

/// Numbers in [0, 1) from a multiplicative congruential generator.
struct Uniform(u64);

impl Iterator for Uniform {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Some((self.0 >> 11) as f64 / 9_007_199_254_740_992.0)
    }
}

/// `count` arguments of either sign in every binade, zeros and infinities left out.
fn by_binade(count: usize) -> Vec<f64> {
    let mut uniform = Uniform(1);
    let mut all = Vec::new();
    for exponent in -1074..=1023 {
        for (index, fraction) in uniform.by_ref().take(count).enumerate() {
            let x = libm_scale(1.0 + fraction, exponent);
            all.push(if index % 2 == 0 { x } else { -x });
        }
    }
    // Most calls fall between 2^-8 and 2^10.
    for exponent in -8..10 {
        for (index, fraction) in uniform.by_ref().take(100 * count).enumerate() {
            let x = libm_scale(1.0 + fraction, exponent);
            all.push(if index % 2 == 0 { x } else { -x });
        }
    }
    all
}

fn libm_scale(x: f64, exponent: i32) -> f64 {
    // In two steps: 2^-1074 itself is a double, but 2^1074 is none.
    x * 2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2)
}

/// The doubles next to multiples of π/2, π/4 and ln 2 / 2, where reductions cancel or change over.
fn next_to_multiples() -> Vec<f64> {
    let mut all = Vec::new();
    for step in [std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_4, 0.5 * std::f64::consts::LN_2] {
        for multiple in (0..3000).chain((1..2000).map(|k| k * 344_777)) {
            let x = f64::from(multiple) * step;
            all.extend([x, -x, x.next_up(), x.next_down(), x * (1.0 + 1e-9)]);
        }
    }
    all
}

const AWKWARD: [f64; 14] = [
    0.0,
    -0.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    f64::MAX,
    f64::MIN,
    1_073_741_824.0,
    708.0,
    -708.0,
];

#[cfg(unix)]
fn ulps(found: f64, expected: f64) -> f64 {
    if found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan()) {
        return 0.0;
    }
    // Adjacent doubles of one sign have adjacent bits, infinity being the one after the largest.
    let (found, expected) = (found.to_bits().cast_signed(), expected.to_bits().cast_signed());
    if (found < 0) == (expected < 0) { found.abs_diff(expected) as f64 } else { f64::INFINITY }
}

/// Within one ulp of the correctly rounded value, so less than 1.5 ulps off, half an ulp inside the promise of 2.
#[cfg(unix)]
fn check_accuracy(arguments: &[f64]) {
    for case in CASES {
        let worst = arguments
            .iter()
            .map(|&x| (ulps((case.one)(x), (case.rounded)(x)), x))
            .fold((0.0, 0.0), |worst, found| if found.0 > worst.0 { found } else { worst });
        let (one, rounded) = ((case.one)(worst.1), (case.rounded)(worst.1));
        assert!(worst.0 <= 1.0, "{}({:?}) = {one:?}, {} ulps from {rounded:?}", case.name, worst.1, worst.0);
    }
}

#[cfg(unix)]
#[test]
fn kernels_are_within_an_ulp_of_the_rounded_value_in_every_binade() {
    check_accuracy(&by_binade(40));
}

#[cfg(unix)]
#[test]
fn kernels_are_within_an_ulp_of_the_rounded_value_where_reductions_cancel() {
    check_accuracy(&next_to_multiples());
}

#[cfg(unix)]
#[test]
fn kernels_treat_awkward_numbers_as_c_does() {
    check_accuracy(&AWKWARD);
}

#[test]
fn blocks_give_the_bits_of_single_calls_on_every_instruction_set() {
    let sets = InstructionSet::available();
    assert_eq!(sets.last(), Some(&InstructionSet::BASELINE));
    let arguments: Vec<f64> = by_binade(4).into_iter().chain(AWKWARD).chain(next_to_multiples()).collect();
    for case in CASES {
        let expected: Vec<u64> = arguments.iter().map(|&x| (case.one)(x).to_bits()).collect();
        for set in &sets {
            // Odd lengths have remainders; the whole has lanes that are not fast among others.
            for length in [0, 1, 3, 7, 8, 9, 255, 256, 257, arguments.len()] {
                let mut values = vec![0.5; length];
                (case.block)(*set, &mut values, &arguments[..length]);
                let same = values.iter().zip(&expected).all(|(value, expected)| {
                    value.to_bits() == *expected || (value.is_nan() && f64::from_bits(*expected).is_nan())
                });
                assert!(same, "{} of {length} on {}", case.name, set.name());
            }
        }
    }
}

#[test]
fn sine_and_cosine_together_are_those_of_their_own_kernels() {
    let arguments: Vec<f64> = by_binade(4).into_iter().chain(AWKWARD).collect();
    let mut together = [vec![0.0; arguments.len()], vec![0.0; arguments.len()]];
    let [sines, cosines] = &mut together;
    kernel::sin_cos_block(InstructionSet::best(), sines, cosines, &arguments);
    for (index, &x) in arguments.iter().enumerate() {
        let found = together.each_ref().map(|all| all[index]);
        let expected = [kernel::sin(x), kernel::cos(x)];
        assert!(found.map(f64::to_bits) == expected.map(f64::to_bits) || expected[0].is_nan(), "{x:?}");
    }
}

#[test]
fn odd_functions_are_odd_to_the_bit() {
    for x in by_binade(2) {
        for (name, odd) in [
            ("sin", kernel::sin as fn(f64) -> f64),
            ("tan", kernel::tan),
            ("sinh", kernel::sinh),
            ("tanh", kernel::tanh),
        ] {
            assert_eq!(odd(-x).to_bits(), (-odd(x)).to_bits(), "{name} {x:?}");
        }
    }
}

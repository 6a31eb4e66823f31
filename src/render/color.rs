//! Colours.

/// Red, green, blue, as screens take them.
pub(super) type Rgb = [u8; 3];

pub(super) const BACKGROUND: Rgb = [255, 255, 255];
pub(super) const INK: Rgb = [40, 40, 44];
/// Where a field has no value.
pub(super) const NO_VALUE: Rgb = [150, 150, 150];
pub(super) const TRIMLINE: Rgb = [190, 40, 30];
pub(super) const GRID_LINE: Rgb = [60, 62, 70];

/// Outside, inside of a patch, and of a primary surface.
pub(super) const PATCH: [[f64; 3]; 2] = [[0.42, 0.62, 0.86], [0.90, 0.72, 0.45]];
pub(super) const PRIMARY: [[f64; 3]; 2] = [[0.80, 0.79, 0.75], [0.70, 0.69, 0.66]];

/// From dark to light, equally far apart for the eye; ten values of the map `viridis` (in the public domain).
const SEQUENTIAL: [Rgb; 10] = [
    [68, 1, 84],
    [72, 40, 120],
    [62, 74, 137],
    [49, 104, 142],
    [38, 130, 142],
    [31, 158, 137],
    [53, 183, 121],
    [110, 206, 88],
    [181, 222, 43],
    [253, 231, 37],
];

/// From blue over white, which is zero, to red.
const DIVERGING: [Rgb; 9] = [
    [33, 72, 152],
    [67, 117, 180],
    [116, 163, 205],
    [184, 211, 231],
    [244, 244, 244],
    [246, 203, 180],
    [229, 145, 115],
    [199, 82, 70],
    [152, 20, 42],
];

/// The colour at `share` of the way from the first to the last, 0 to 1.
pub(super) fn sequential(share: f64) -> [f64; 3] {
    between(&SEQUENTIAL, share)
}

/// As [`sequential`]; 1/2 is zero.
pub(super) fn diverging(share: f64) -> [f64; 3] {
    between(&DIVERGING, share)
}

fn between(colors: &[Rgb], share: f64) -> [f64; 3] {
    let place = share.clamp(0.0, 1.0) * (colors.len() - 1) as f64;
    let index = (place as usize).min(colors.len().saturating_sub(2));
    let part = place - index as f64;
    match (colors.get(index), colors.get(index + 1)) {
        (Some([r, g, b]), Some([next_r, next_g, next_b])) => {
            let mix = |a: &u8, b: &u8| ((1.0 - part) * f64::from(*a) + part * f64::from(*b)) / 255.0;
            [mix(r, next_r), mix(g, next_g), mix(b, next_b)]
        }
        _ => [0.0; 3],
    }
}

/// A colour from parts of 0 to 1; what is brighter is as bright as it gets.
pub(super) fn rgb(parts: [f64; 3]) -> Rgb {
    // The conversion saturates.
    parts.map(|part| (255.0 * part + 0.5) as u8)
}

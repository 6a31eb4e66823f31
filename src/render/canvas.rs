//! Triangles into samples: the nearest one is seen.

use super::color::{BACKGROUND, Rgb};
use super::picture::Picture;

/// Samples along each side of a pixel.
pub(super) const SAMPLES: usize = 3;

/// What is known at a point of a surface; everything is interpolated over triangles.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Point {
    /// Samples to the right and down, and depth towards the viewer.
    pub place: [f64; 3],
    /// In the camera's directions; about unit length.
    pub normal: [f64; 3],
    pub uv: [f64; 2],
    pub value: f64,
}

impl Point {
    pub fn mean(corners: [Point; 4]) -> Point {
        let [a, b, c, d] = corners;
        let pair = |a: Point, b: Point| Point::weighted([(0.5, a), (0.5, b), (0.0, a)]);
        // Opposite corners first: a quad seen in a mirror gives the same numbers.
        pair(pair(a, c), pair(b, d))
    }

    fn weighted([(wa, a), (wb, b), (wc, c)]: [(f64, Point); 3]) -> Point {
        let mix = |a: f64, b: f64, c: f64| wa * a + wb * b + wc * c;
        let mix3 = |[ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3], [cx, cy, cz]: [f64; 3]| {
            [mix(ax, bx, cx), mix(ay, by, cy), mix(az, bz, cz)]
        };
        let ([au, av], [bu, bv], [cu, cv]) = (a.uv, b.uv, c.uv);
        Point {
            place: mix3(a.place, b.place, c.place),
            normal: mix3(a.normal, b.normal, c.normal),
            uv: [mix(au, bu, cu), mix(av, bv, cv)],
            value: mix(a.value, b.value, c.value),
        }
    }
}

/// The samples of a band of rows.
pub(super) struct Canvas {
    columns: usize,
    /// The first row of pixels.
    top: usize,
    samples: Vec<(f64, Rgb)>,
}

impl Canvas {
    /// A band of `height` rows of `width` pixels from row `top`, without anything to be seen.
    pub fn new(width: usize, top: usize, height: usize) -> Canvas {
        let columns = width * SAMPLES;
        Canvas { columns, top, samples: vec![(f64::NEG_INFINITY, BACKGROUND); columns * height * SAMPLES] }
    }

    /// Draws a triangle where it is nearer than what is there.
    pub fn triangle(&mut self, corners: &[Point; 3], color: impl Fn(&Point) -> Rgb) {
        let [a, b, c] = *corners;
        let ([ax, ay, _], [bx, by, _], [cx, cy, _]) = (a.place, b.place, c.place);
        let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        // Seen from the side; or so far outside that numbers end.
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let top = (self.top * SAMPLES) as f64;
        let rows = self.samples.len() / self.columns.max(1);
        let (first, last) = covered([ay, by, cy], top, rows);
        let (left, right) = covered([ax, bx, cx], 0.0, self.columns);
        for (y, row) in self.samples.chunks_mut(self.columns.max(1)).enumerate().take(last).skip(first) {
            let y = top + y as f64 + 0.5;
            for (x, sample) in row.iter_mut().enumerate().take(right).skip(left) {
                let x = x as f64 + 0.5;
                let weight_a = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area;
                let weight_b = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area;
                let weight_c = ((ax - x) * (by - y) - (ay - y) * (bx - x)) / area;
                if weight_a < 0.0 || weight_b < 0.0 || weight_c < 0.0 {
                    continue;
                }
                let point = Point::weighted([(weight_a, a), (weight_b, b), (weight_c, c)]);
                let [_, _, depth] = point.place;
                if depth > sample.0 {
                    *sample = (depth, color(&point));
                }
            }
        }
    }

    /// Writes the mean of each pixel's samples.
    pub fn average_into(&self, picture: &mut Picture) {
        let mut sums = vec![[0_u32; 3]; self.columns / SAMPLES];
        for (index, rows) in self.samples.chunks(self.columns * SAMPLES).enumerate() {
            sums.fill([0; 3]);
            for row in rows.chunks(self.columns) {
                for (sum, samples) in sums.iter_mut().zip(row.chunks(SAMPLES)) {
                    for (_, color) in samples {
                        sum.iter_mut().zip(color).for_each(|(sum, part)| *sum += u32::from(*part));
                    }
                }
            }
            let count = (SAMPLES * SAMPLES) as u32;
            for (x, sum) in sums.iter().enumerate() {
                picture.set(
                    x,
                    self.top + index,
                    sum.map(|sum| u8::try_from((sum + count / 2) / count).unwrap_or(u8::MAX)),
                );
            }
        }
    }
}

/// The samples from `start` on, up to `count`, whose middles lie between the least and the largest coordinate.
fn covered(coordinates: [f64; 3], start: f64, count: usize) -> (usize, usize) {
    let [low, high] = [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| coordinates.into_iter().reduce(pick));
    // The conversion saturates: what lies before is 0.
    let first = (low.unwrap_or(0.0) - start - 0.5).ceil() as usize;
    let last = (high.unwrap_or(0.0) - start + 0.5).floor() as usize;
    (first.min(count), last.min(count))
}

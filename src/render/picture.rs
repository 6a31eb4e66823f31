//! Pixels.

use super::color::Rgb;

/// A picture: rows from the top of red, green and blue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

impl Picture {
    /// A picture of one colour.
    #[must_use]
    pub fn new(width: usize, height: usize, color: [u8; 3]) -> Picture {
        Picture { width, height, bytes: color.repeat(width * height) }
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows of pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Red, green and blue of every pixel.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The colour in column `x` of row `y`, if they are inside.
    #[must_use]
    pub fn get(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        self.start(x, y).and_then(|start| self.bytes.get(start..start + 3)).and_then(|color| color.try_into().ok())
    }

    /// Colours a pixel; one outside is left out.
    pub(super) fn set(&mut self, x: usize, y: usize, color: Rgb) {
        if let Some(pixel) = self.start(x, y).and_then(|start| self.bytes.get_mut(start..start + 3)) {
            pixel.copy_from_slice(&color);
        }
    }

    /// Copies another picture to column `left`, row `top`.
    pub(super) fn paste(&mut self, other: &Picture, left: usize, top: usize) {
        for (y, row) in other.bytes.chunks(3 * other.width.max(1)).enumerate() {
            let start = self.start(left, top + y);
            if let Some(target) = start.and_then(|start| self.bytes.get_mut(start..start + row.len())) {
                target.copy_from_slice(row);
            }
        }
    }

    fn start(&self, x: usize, y: usize) -> Option<usize> {
        (x < self.width && y < self.height).then_some(3 * (y * self.width + x))
    }
}

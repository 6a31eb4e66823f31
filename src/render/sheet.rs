//! Several pictures on one sheet.

use super::color::{BACKGROUND, GRID_LINE};
use super::picture::Picture;

/// Pictures of one size side by side and row under row, in reading order, with a line between them.
#[must_use]
pub fn contact_sheet(pictures: &[Picture]) -> Picture {
    let Some(first) = pictures.first() else { return Picture::new(0, 0, BACKGROUND) };
    let columns = columns(pictures.len());
    let rows = pictures.len().div_ceil(columns);
    let (step_x, step_y) = (first.width() + 1, first.height() + 1);
    let mut sheet = Picture::new(columns * step_x - 1, rows * step_y - 1, GRID_LINE);
    let blank = Picture::new(first.width(), first.height(), BACKGROUND);
    for place in 0..columns * rows {
        let picture = pictures.get(place).unwrap_or(&blank);
        sheet.paste(picture, place % columns * step_x, place / columns * step_y);
    }
    sheet
}

/// As many columns as rows, or one more.
fn columns(pictures: usize) -> usize {
    let side = pictures.isqrt();
    if side * side == pictures { side } else { side + 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eleven_pictures_stand_in_three_rows_of_four() {
        let pictures: Vec<Picture> = (0..11).map(|shade| Picture::new(5, 3, [shade; 3])).collect();
        let sheet = contact_sheet(&pictures);
        assert_eq!((sheet.width(), sheet.height()), (4 * 6 - 1, 3 * 4 - 1));
        assert_eq!(sheet.get(0, 0), Some([0; 3]));
        assert_eq!(sheet.get(6, 4), Some([5; 3]), "second row, second column");
        assert_eq!(sheet.get(22, 10), Some(BACKGROUND), "the place without a picture");
        assert_eq!(sheet.get(5, 0), Some(GRID_LINE));
    }

    #[test]
    fn one_picture_is_its_own_sheet() {
        let picture = Picture::new(4, 2, [1, 2, 3]);
        assert_eq!(contact_sheet(std::slice::from_ref(&picture)), picture);
    }
}

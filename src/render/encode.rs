//! Pictures as PNG, animated PNG and GIF.

use std::io::{self, Write};

use gif::Repeat;

use super::picture::Picture;

/// Writes a PNG file.
///
/// # Errors
/// When `out` fails.
pub fn write_png(picture: &Picture, out: &mut dyn Write) -> io::Result<()> {
    let mut writer = png_encoder(picture, out)?.write_header()?;
    writer.write_image_data(picture.bytes())?;
    writer.finish()?;
    Ok(())
}

/// Writes `count` pictures of one size as an animated PNG that begins anew when it has ended.
///
/// Each is shown for 1/`frames_per_second` seconds. The pictures are taken one at a time.
///
/// # Errors
/// When a picture is an error, or differs in size or number; when `out` fails.
pub fn write_apng<E: From<io::Error>>(
    pictures: impl Iterator<Item = Result<Picture, E>>,
    count: u32,
    frames_per_second: u16,
    out: &mut dyn Write,
) -> Result<(), E> {
    let mut pictures = pictures;
    let Some(first) = pictures.next().transpose()? else { return Ok(()) };
    let mut encoder = png_encoder(&first, out)?;
    encoder.set_animated(count, 0).map_err(io::Error::from)?;
    encoder.set_frame_delay(1, frames_per_second).map_err(io::Error::from)?;
    let mut writer = encoder.write_header().map_err(io::Error::from)?;
    writer.write_image_data(first.bytes()).map_err(io::Error::from)?;
    for picture in pictures {
        writer.write_image_data(picture?.bytes()).map_err(io::Error::from)?;
    }
    writer.finish().map_err(io::Error::from)?;
    Ok(())
}

fn png_encoder<'a>(picture: &Picture, out: &'a mut dyn Write) -> io::Result<png::Encoder<'a, &'a mut dyn Write>> {
    let [width, height] = [picture.width(), picture.height()].map(|side| u32::try_from(side).map_err(io::Error::other));
    let mut encoder = png::Encoder::new(out, width?, height?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    Ok(encoder)
}

/// Writes a GIF file of one picture, as [`write_gif`] does.
///
/// # Errors
/// As [`write_gif`].
pub fn write_gif_still(picture: Picture, out: &mut dyn Write) -> io::Result<()> {
    write_gif(std::iter::once(io::Result::Ok(picture)), 1, out)
}

/// Writes pictures of one size as a GIF animation that begins anew when it has ended.
///
/// Each is shown for the nearest hundredths of a second to 1/`frames_per_second`, at least two, which is the least
/// that viewers obey. Each has 256 colours of its own; sides are up to 65535 pixels. The pictures are taken one at a
/// time.
///
/// # Errors
/// When a picture is an error or too large; when `out` fails.
pub fn write_gif<E: From<io::Error>>(
    pictures: impl Iterator<Item = Result<Picture, E>>,
    frames_per_second: u16,
    out: &mut dyn Write,
) -> Result<(), E> {
    let mut pictures = pictures;
    let Some(first) = pictures.next().transpose()? else { return Ok(()) };
    let (width, height) = sides(&first)?;
    let mut encoder = gif::Encoder::new(out, width, height, &[]).map_err(io::Error::other)?;
    encoder.set_repeat(Repeat::Infinite).map_err(io::Error::other)?;
    let delay = (100 + frames_per_second / 2).checked_div(frames_per_second).unwrap_or(100).max(2);
    for picture in std::iter::once(Ok(first)).chain(pictures) {
        let picture: Picture = picture?;
        let (width, height) = sides(&picture)?;
        let mut frame = gif::Frame::from_rgb_speed(width, height, picture.bytes(), QUANTISER_SPEED);
        frame.delay = delay;
        encoder.write_frame(&frame).map_err(io::Error::other)?;
    }
    encoder.into_inner().map_err(io::Error::other)?;
    Ok(())
}

/// Of 1 (best) to 30 (fastest); 10 looks at every tenth pixel.
const QUANTISER_SPEED: i32 = 10;

fn sides(picture: &Picture) -> io::Result<(u16, u16)> {
    match (u16::try_from(picture.width()), u16::try_from(picture.height())) {
        (Ok(width), Ok(height)) => Ok((width, height)),
        _ => Err(io::Error::other("a GIF file has up to 65535 pixels along a side")),
    }
}

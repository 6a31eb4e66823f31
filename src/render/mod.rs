//! Draws scenes: shaded pictures of meshes, without a graphics card and without chance.
//!
//! Input: the scenes of one or more instants and a [`Style`]; output: a [`Picture`] for each, and the bytes of PNG,
//! animated PNG and GIF files. A [`Renderer`] fits the view and the range of colours to all instants at once, so that
//! nothing but the surface moves.
//!
//! Steps: vertices are turned into the camera's coordinates ([`Camera`], parallel projection), triangles and lines are
//! drawn into a buffer of depths with 3 x 3 samples a pixel, samples are averaged, then legend and label are written.
//!
//! Invariant: equal scenes and styles give equal bytes. All arithmetic is in doubles, functions come from the crate
//! `libm`. Absent on purpose: shadows, transparency, perspective, textures.

mod camera;
mod canvas;
mod color;
mod encode;
mod lettering;
mod lines;
mod picture;
mod shade;
mod sheet;

pub use camera::Camera;
pub use encode::{write_apng, write_gif, write_gif_still, write_png};
pub use picture::Picture;
pub use shade::Shade;
pub use sheet::contact_sheet;

use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;
use crate::tessellate::Scene;

use camera::View;
use canvas::{Canvas, SAMPLES};
use shade::Painter;

/// How scenes are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Style {
    /// What colours mean.
    pub shade: Shade,
    /// From where.
    pub camera: Camera,
    /// Width and height of a picture in pixels.
    pub size: (usize, usize),
    /// Into how many parts lines of constant u and of constant v divide each patch; they are the nearest lines of the
    /// mesh.
    pub lines: Option<(usize, usize)>,
    /// Whether each picture says its instant.
    pub is_labelled: bool,
}

impl Style {
    /// Whether `pictures` pictures can be drawn in this style.
    ///
    /// # Errors
    /// [`Code::SettingOutOfRange`] for a size, lines or a camera out of range; [`Code::LimitReached`] when the
    /// pictures have more pixels than `limits.pixels`.
    pub fn check(&self, pictures: usize, limits: &Limits) -> Result<(), Diagnostic> {
        check_size(self.size, pictures, limits)?;
        if self.lines.is_some_and(|(across, along)| across == 0 || along == 0) {
            let message = "lines divide a patch into at least 1x1 parts";
            return Err(Diagnostic::new(Code::SettingOutOfRange, message).hint("write NxM, for example 8x16"));
        }
        self.camera.check()
    }
}

/// Draws scenes of one animation alike.
pub struct Renderer {
    style: Style,
    view: View,
    painter: Painter,
}

/// Rows of pixels that are drawn at a time; bounds the memory for samples.
const BAND: usize = 64;

impl Renderer {
    /// A renderer for pictures of `frames`, all with the same view and colours.
    ///
    /// # Errors
    /// As [`Style::check`].
    pub fn new(frames: &[Scene], style: &Style, limits: &Limits) -> Result<Renderer, Diagnostic> {
        style.check(frames.len(), limits)?;
        let view = View::fit(frames, style.camera, style.size);
        let painter = Painter::new(style.shade, frames);
        Ok(Renderer { style: style.clone(), view, painter })
    }

    /// A picture of one scene.
    #[must_use]
    pub fn draw(&self, scene: &Scene) -> Picture {
        let (width, height) = self.style.size;
        let mut picture = Picture::new(width, height, color::BACKGROUND);
        let surfaces: Vec<_> = scene.meshes.iter().map(|mesh| (mesh, self.view.triangles(mesh))).collect();
        let strokes = lines::strokes(scene, &self.view, self.style.lines);
        for top in (0..height).step_by(BAND) {
            let mut canvas = Canvas::new(width, top, BAND.min(height - top));
            for (mesh, triangles) in &surfaces {
                for triangle in triangles {
                    canvas.triangle(triangle, |point| self.painter.color(mesh.role, point));
                }
            }
            for (stroke, color) in &strokes {
                stroke.iter().for_each(|triangle| canvas.triangle(triangle, |_| *color));
            }
            canvas.average_into(&mut picture);
        }
        if let Some((ends, is_exceeded)) = self.painter.scale() {
            lettering::legend(&mut picture, ends, is_exceeded, |share| self.painter.map(share));
        }
        if self.style.is_labelled {
            lettering::label(&mut picture, scene.time);
        }
        picture
    }
}

fn check_size((width, height): (usize, usize), pictures: usize, limits: &Limits) -> Result<(), Diagnostic> {
    if width < SMALLEST || height < SMALLEST {
        let message = format!("a picture of {width}x{height} pixels is too small");
        return Err(
            Diagnostic::new(Code::SettingOutOfRange, message).hint(format!("take at least {SMALLEST}x{SMALLEST}"))
        );
    }
    // The samples along one side are numbered exactly by doubles, and bytes by usize.
    let pixels = width.checked_mul(height).and_then(|pixels| pixels.checked_mul(pictures));
    if pixels.is_some_and(|pixels| pixels <= limits.pixels) && width.max(height) < (1 << 31) / SAMPLES {
        return Ok(());
    }
    let message = format!("{pictures} x {width}x{height} pixels are over the limit `pixels` of {}", limits.pixels);
    Err(Diagnostic::new(Code::LimitReached, message).hint("choose smaller or fewer pictures, or raise the limit"))
}

/// Pixels along a side, below which a legend has no place.
const SMALLEST: usize = 16;

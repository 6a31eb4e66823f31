//! How scenes are drawn and written: what `render` and `morph` share.

use std::io::{BufWriter, Write};
use std::path::Path;

use clap::{Args, ValueEnum};

use trimline::diagnostic::Diagnostic;
use trimline::limits::Limits;
use trimline::render::{
    Camera, Picture, Renderer, Shade, Style, contact_sheet, write_apng, write_gif, write_gif_still, write_png,
};
use trimline::tessellate::Scene;

use crate::Outcome;
use crate::failure::Failure;
use crate::options::{Terminal, option_finding, read_grid};
use crate::output::{Files, by_extension};
use crate::scenes::{Progress, Quantity};

/// What a picture shows, and of what size.
#[derive(Args)]
pub struct Drawing {
    /// What the colours mean.
    #[arg(long, value_enum, default_value_t = Coloring::Plain)]
    shade: Coloring,

    /// Lines of constant u and v that divide each patch into N x M parts.
    #[arg(long, value_name = "NxM", allow_hyphen_values = true)]
    lines: Option<String>,

    /// The viewer: degrees around z and above the plane of x and y, and how much larger than life.
    #[arg(long, value_name = "AZIMUTH,ELEVATION[,ZOOM]", default_value = "-60,25,1", allow_hyphen_values = true)]
    camera: String,

    /// Width and height of a picture in pixels [default: 800x600, on a sheet 320x240].
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<String>,

    /// One picture after the other instead of a sheet.
    #[arg(long)]
    pub animate: bool,

    /// Pictures in a second of an animation.
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = clap::value_parser!(u16).range(1..=100))]
    fps: u16,
}

/// What the colours mean.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Coloring {
    /// Nothing but light; the inside has another colour.
    Plain,
    /// Reflected stripes, which show creases and jumps of curvature.
    Zebra,
    /// Mean curvature.
    Curvature,
    /// Gaussian curvature.
    Gaussian,
    /// Residual of the equation over its largest term.
    Residual,
    /// The parameter u.
    U,
    /// The parameter v.
    V,
}

impl Coloring {
    /// How the renderer shades, and the field it shades by.
    fn meaning(self) -> (Shade, Option<(Quantity, &'static str)>) {
        match self {
            Coloring::Plain => (Shade::Plain, None),
            Coloring::Zebra => (Shade::Zebra, None),
            Coloring::Curvature => (Shade::SignedField, Some((Quantity::Curvature, "mean_curvature"))),
            Coloring::Gaussian => (Shade::SignedField, Some((Quantity::Curvature, "gaussian_curvature"))),
            Coloring::Residual => (Shade::Field, Some((Quantity::Residual, "residual"))),
            Coloring::U => (Shade::U, None),
            Coloring::V => (Shade::V, None),
        }
    }
}

/// The kind of file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Png,
    Gif,
}

impl Drawing {
    /// The style of as many pictures as `frames`, if that is stated.
    pub fn style(&self, frames: Option<usize>) -> Result<Style, Failure> {
        let is_sheet = frames.is_some_and(|frames| frames > 1) && !self.animate;
        let size = match &self.size {
            Some(size) => {
                let wrong = |_| Failure::Usage(format!("`{size}` is not a size: write WxH, for example 800x600"));
                read_grid(size).map_err(wrong)?
            }
            None if is_sheet => (320, 240),
            None => (800, 600),
        };
        let lines = match &self.lines {
            None => None,
            Some(lines) => {
                let wrong = |_| Failure::Usage(format!("`{lines}` are no lines: write NxM, for example 8x16"));
                Some(read_grid(lines).map_err(wrong)?)
            }
        };
        let (shade, _) = self.shade.meaning();
        Ok(Style { shade, camera: camera(&self.camera)?, size, lines, is_labelled: frames.is_some() })
    }

    /// The numbers at the vertices that the colours show.
    pub fn quantity(&self) -> Option<Quantity> {
        self.shade.meaning().1.map(|(quantity, _)| quantity)
    }

    /// Refuses more pixels than allowed, before anything is solved.
    pub fn check(&self, style: &Style, pictures: usize, limits: &Limits) -> Outcome {
        style.check(pictures, limits).map_err(|finding| self.about(style.size, finding))
    }

    /// Draws `scenes` and writes them to `path`, as one picture, a sheet or an animation.
    pub fn write(
        &self,
        path: &Path,
        mut scenes: Vec<Scene>,
        (style, limits): (&Style, &Limits),
        fault: impl Fn(Diagnostic) -> Failure,
        terminal: &Terminal,
    ) -> Outcome {
        let kind = kind_of(path)?;
        if let (_, Some((_, name))) = self.shade.meaning() {
            let meshes = scenes.iter_mut().flat_map(|scene| &mut scene.meshes);
            meshes.for_each(|mesh| mesh.fields.retain(|field| field.name == name));
        }
        let renderer = Renderer::new(&scenes, style, limits).map_err(fault)?;
        let mut files = Files::default();
        let mut out = BufWriter::new(files.create(path)?);
        self.draw(kind, &renderer, &scenes, (&mut out, terminal))
            .and_then(|()| out.flush())
            .map_err(|error| Failure::Machine(format!("cannot write `{}`: {error}", path.display())))?;
        drop(out);
        files.keep()
    }

    fn draw(
        &self,
        kind: Kind,
        renderer: &Renderer,
        instants: &[Scene],
        (out, terminal): (&mut dyn Write, &Terminal),
    ) -> std::io::Result<()> {
        let progress = Progress::new(instants.len(), terminal);
        let pictures = instants.iter().map(|scene| {
            let picture = renderer.draw(scene);
            progress.advance();
            picture
        });
        if self.animate {
            let pictures = pictures.map(std::io::Result::Ok);
            let count = u32::try_from(instants.len()).map_err(std::io::Error::other)?;
            match kind {
                Kind::Png => write_apng(pictures, count, self.fps, out)?,
                Kind::Gif => write_gif(pictures, self.fps, out)?,
            }
        } else {
            let sheet = contact_sheet(&pictures.collect::<Vec<Picture>>());
            match kind {
                Kind::Png => write_png(&sheet, out)?,
                Kind::Gif => write_gif_still(sheet, out)?,
            }
        }
        progress.finish();
        Ok(())
    }

    /// A finding about the style, shown in the option that it is about.
    fn about(&self, (width, height): (usize, usize), finding: Diagnostic) -> Failure {
        let size = format!("{width}x{height}");
        let (option, value) = match &self.lines {
            _ if finding.message.contains("camera") => ("camera", self.camera.as_str()),
            Some(lines) if finding.message.contains("lines") => ("lines", lines.as_str()),
            _ => ("size", size.as_str()),
        };
        option_finding(option, value, finding)
    }
}

fn camera(text: &str) -> Result<Camera, Failure> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    match numbers.as_deref() {
        Ok([azimuth, elevation]) => Ok(Camera { azimuth: *azimuth, elevation: *elevation, zoom: 1.0 }),
        Ok([azimuth, elevation, zoom]) => Ok(Camera { azimuth: *azimuth, elevation: *elevation, zoom: *zoom }),
        _ => {
            let message = format!("`{text}` is no camera: write AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,ZOOM");
            Err(Failure::Usage(format!("{message}, for example -60,25,1.5")))
        }
    }
}

/// Whether an extension names a picture.
pub fn is_picture(path: &Path) -> bool {
    kind_of(path).is_ok()
}

/// The kind of picture that a file's extension names.
pub fn kind_of(path: &Path) -> Result<Kind, Failure> {
    by_extension(path, &["png", "gif"], |extension| match extension {
        "png" => Some(Kind::Png),
        "gif" => Some(Kind::Gif),
        _ => None,
    })
}

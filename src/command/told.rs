//! What `render` says of a picture that it has made.

use super::methods::{self, Shown, Solved};
use super::render::{Render, What};
use super::report::{self, percent};
use radiosity::film::{FalseColour, luminance};
use radiosity::geometry::Rgb;
use radiosity::scene::Scene;
use radiosity::trace::{Rendered, Table};
use serde_json::{Value, json};
use std::fmt::Write;

/// A picture, how it came about, and what is known of it.
pub struct Told {
    pub shown: Shown,
    /// Pass 1, where there was one.
    pub solved: Option<Solved>,
    pub made: Rendered,
    /// The factor on radiance.
    pub exposure: f64,
    pub seconds: f64,
    /// Whose light it shows, where that was asked for.
    pub classes: Option<Table>,
}

impl Told {
    /// For people.
    pub fn text(&self, render: &Render, scene: &Scene) -> String {
        let Told { shown, exposure, seconds, .. } = self;
        let mut text = match &self.solved {
            Some((solution, _)) => {
                report::text(scene, solution, render.tolerance, *seconds)
            }
            None => format!("{}: {seconds:.1} s\n", scene.name),
        };
        // A String takes all.
        let _ = writeln!(
            text,
            "picture: {}, {}x{}, {}, exposure {exposure:.4}, {} of the pixels are clamped",
            render.output.display(),
            shown.shot.width,
            shown.shot.height,
            shown.method.name(),
            percent(self.made.picture.clamped_share(*exposure))
        );
        if let Some(noise) = self.noise() {
            let _ = writeln!(
                text,
                "noise: pixels are off by about {} of the picture's mean (one standard \
                 error)",
                percent(noise)
            );
        }
        if render.view == What::Error {
            let FalseColour { low, high } = FalseColour::ERRORS;
            let (low, high) = (percent(low), percent(high));
            let _ = writeln!(
                text,
                "colours: elements off by {low} (dark) to {high} (bright) of the \
                 reflected light"
            );
        }
        text + &self.classes.as_ref().map_or(String::new(), methods::classes_text)
    }

    /// For other programs.
    pub fn json(&self, render: &Render) -> Value {
        let Told { shown, made, exposure, seconds, .. } = self;
        let mut object = match &self.solved {
            Some((solution, plan)) => {
                report::json_timed(solution, plan, render.tolerance, *seconds)
            }
            None => json!({ "seconds": seconds }),
        };
        object["file"] = json!(render.output);
        object["method"] = json!(shown.method.name());
        object["size"] = json!([shown.shot.width, shown.shot.height]);
        object["samples"] = json!(shown.samples);
        object["exposure"] = json!(exposure);
        object["clamped"] = json!(made.picture.clamped_share(*exposure));
        object["rays"] = json!(made.rays);
        object["noise"] = json!(self.noise());
        if let Some(classes) = &self.classes {
            object["paths"] = methods::classes_json(classes);
        }
        object
    }

    /// The standard error of a pixel, root mean square, relative to the mean luminance,
    /// where chance decided.
    fn noise(&self) -> Option<f64> {
        let squares = |error: &Vec<Rgb>| {
            let squares = error.iter().map(|e| luminance(*e).powi(2)).sum::<f64>();
            squares / error.len() as f64
        };
        let squares = self.made.error.as_ref().map(squares)?;
        let pixels = &self.made.picture.pixels;
        let sum = pixels.iter().map(|l| luminance(*l)).sum::<f64>();
        Some(squares.sqrt() / (sum / pixels.len() as f64).max(f64::MIN_POSITIVE))
    }
}

//! Pictures as snapshots. Any test of the workspace may include this file by `#[path]`.
//!
//! A picture that differs is refused; old, new and difference are written side by side
//! under `target/tmp/`, and the message names that file. To accept a change, run the
//! test with `INSTA_UPDATE=always` and look at the new picture.

use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot};
use radiosity::film::{RgbImage, compare, png, side_by_side};
use std::path::{Path, PathBuf};

/// What may differ: rounding in the last digits moves few pixels, and by little.
#[derive(Clone)]
struct Pictures {
    /// A channel may differ by this much anywhere, in 1/255.
    step: u8,
    /// This share of the pixels may differ by more.
    share: f64,
    /// Where to write what differs.
    difference: PathBuf,
}

impl Comparator for Pictures {
    fn matches(&self, old: &Snapshot, new: &Snapshot) -> bool {
        let (Some(old), Some(new)) = (decode(old), decode(new)) else { return false };
        let found = compare(&old, &new, self.step);
        if found.is_some_and(|found| found.share() <= self.share) {
            return true;
        }
        let says = found.map_or("their sizes differ".into(), |found| found.to_string());
        let panels = png(&side_by_side(&old, &new)).expect("two pictures make a third");
        std::fs::write(&self.difference, panels).expect("target/tmp can be written");
        println!("{says}\nold | new | difference: {}", self.difference.display());
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

fn decode(snapshot: &Snapshot) -> Option<RgbImage> {
    let SnapshotContents::Binary(Some(bytes)) = snapshot.contents() else {
        return None;
    };
    Some(image::load_from_memory(bytes).ok()?.to_rgb8())
}

/// Asserts that `picture` is the snapshot `name` in `folder` (of this package), but for
/// a two-hundredth of its pixels.
#[allow(dead_code)] // not every test that includes this file has pictures
pub fn assert_picture(folder: &str, name: &str, picture: &RgbImage) {
    let difference =
        Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.difference.png"));
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(Pictures { step: 2, share: 0.005, difference }));
    settings.bind(|| {
        let bytes = png(picture).expect("a picture of some pixels can be encoded");
        insta::assert_binary_snapshot!(format!("{name}.png").as_str(), bytes);
    });
}

//! Task 5: what stands in the way, on either leg.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::{crossing, plane};
use super::{Suspects, above, outline};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::uniform;
use crate::shapes::{Place, convex};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// A path by a mirror, and where it hits the mirror's plane.
struct Path {
    x: DVec3,
    p: DVec3,
    hit: DVec3,
    /// The image of `x`.
    image: DVec3,
    mirror: Vec<DVec3>,
    cards: Vec<Vec<DVec3>>,
    what: &'static str,
}

impl Path {
    /// A path that hits the mirror so far on the way from its middle to a corner.
    fn draw(stream: &mut Stream, reach: f64, side: f64) -> Path {
        let place = Place::draw(stream);
        let mirror = convex(stream);
        let middle = mirror.iter().sum::<DVec3>() / mirror.len() as f64;
        let hit = middle.lerp(mirror[0], reach);
        let p = above(stream, 0.8, 2.0) * dvec3(1.0, 1.0, side);
        let on = uniform(stream, 0.7, 1.5);
        let image = hit + (hit - p) * on;
        let x = dvec3(image.x, image.y, -image.z);
        let [x, p, hit, image] = [x, p, hit, image].map(|v| place.of(v));
        let mirror = place.all(&mirror);
        Path { x, p, hit, image, mirror, cards: Vec::new(), what: "no card" }
    }

    /// Does a card stand on the line between these?
    fn stands(&self, a: DVec3, b: DVec3) -> bool {
        self.cards.iter().any(|card| crossing(a, b, card).is_some())
    }

    /// The lines on which cards stand: at `p`, at `x`, straight, beyond the mirror.
    fn lines(&self) -> [bool; 4] {
        let [x, p, hit, image] = [self.x, self.p, self.hit, self.image];
        [(p, hit), (hit, x), (p, x), (hit, image)].map(|(a, b)| self.stands(a, b))
    }

    /// A card on this of the four lines, and on no other.
    fn with_card(mut self, stream: &mut Stream, line: usize) -> Option<Path> {
        let [x, p, hit, image] = [self.x, self.p, self.hit, self.image];
        let (a, b) = [(p, hit), (hit, x), (p, x), (hit, image)][line];
        let at = a.lerp(b, uniform(stream, 0.4, 0.6));
        self.cards = vec![outline(stream, at, 0.1)];
        self.what = [
            "a card between p and the mirror",
            "a card between the mirror and x",
            "a card between p and x, beside the path",
            "a card behind the mirror",
        ][line];
        let alone = self.lines().iter().enumerate().all(|(k, &on)| on == (k == line));
        alone.then_some(self)
    }

    fn on_mirror(&self) -> bool {
        crossing(self.p, self.image, &self.mirror).is_some()
    }

    fn before(&self) -> bool {
        plane(&self.mirror).height(self.p) > 0.0
    }

    fn right(&self) -> bool {
        let [at_eye, at_lamp, ..] = self.lines();
        self.before() && self.on_mirror() && !at_eye && !at_lamp
    }
}

const WRONG: &Suspects<Path, bool> = &[
    (NO_CARDS, |c| c.before() && c.on_mirror()),
    (EYE_LEG, |c| c.before() && c.on_mirror() && !c.lines()[0]),
    (LAMP_LEG, |c| c.before() && c.on_mirror() && !c.lines()[1]),
    (TO_THE_IMAGE, |c| c.before() && c.on_mirror() && !c.lines()[0] && !c.lines()[3]),
    (STRAIGHT, |c| c.before() && c.on_mirror() && !c.lines()[2]),
    (NO_END, |c| c.before() && !c.lines()[0] && !c.lines()[1]),
    (FROM_BEHIND, |c| c.on_mirror() && !c.lines()[0] && !c.lines()[1]),
];

fn judge(work: &Work, paths: &[Path]) -> Verdict {
    let all = |f: &dyn Fn(&Path) -> bool| {
        paths.iter().map(|path| f64::from(f(path))).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> = WRONG.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let got = all(&|c| (work.reaches)(c.x, c.p, &c.mirror, &c.cards));
    let place = |k: usize| format!("{} (1 is seen, 0 not)", paths[k].what);
    compare(&got, &all(&Path::right), Within::Absolute(0.0), &suspects, place)
}

/// Free paths, and one card each on one of the four lines.
pub(super) fn cards(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| loop {
        let reach = uniform(stream, 0.0, 0.6);
        let path = Path::draw(stream, reach, 1.0);
        let path = match k % 5 {
            4 => Some(path),
            line => path.with_card(stream, line),
        };
        if let Some(path) = path {
            return path;
        }
    };
    let paths: Vec<Path> = (0..25).map(&mut draw).collect();
    judge(work, &paths)
}

/// Paths past the rim of the mirror, and such as hit its back.
pub(super) fn rim_and_back(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| {
        let (reach, side, what) = [
            (uniform(stream, 0.0, 0.8), 1.0, "onto the mirror"),
            (uniform(stream, 1.2, 2.0), 1.0, "past the rim of the mirror"),
            (uniform(stream, 0.0, 0.8), -1.0, "onto the mirror's back"),
        ][k % 3];
        Path { what, ..Path::draw(stream, reach, side) }
    };
    let paths: Vec<Path> = (0..15).map(&mut draw).collect();
    judge(work, &paths)
}

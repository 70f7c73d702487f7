//! Rooms as they come: 500 of them, drawn from seeded streams, in ten families of 50. Each
//! family stresses one thing; the last two all at once, and what is known exactly.

use super::rooms::{box_walls, coloured_scene, moved};
use glam::{DQuat, DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::random::Stream;
use radiosity::scene::Scene;
use std::f64::consts::TAU;

/// What a room is made to be hard by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Boxes in a box, standing or floating.
    Boxes,
    /// Boxes that nearly touch the floor, or each other: gaps of 1e-6 to 1e-2 of the room.
    Touching,
    /// Slabs, rods and corridors: sides of up to 1000 to 1.
    Slivers,
    /// Sheets before walls, at 1e-7 to 1e-3 of the room, some tilted by as little.
    Coplanar,
    /// Reflectances from .9 to .999.
    Bright,
    /// Up to 40 lamps, that are 1e-3 of the surface or all of it.
    Lamps,
    /// One to three walls are missing.
    Open,
    /// Boxes through each other, and through walls.
    Piercing,
    /// All of it at once.
    Anything,
    /// `E = (1 − ρ) B` everywhere, so that `B` is known; in every other room the emission
    /// is off by 1e-9, so that it has to be solved.
    Furnaces,
}

impl Family {
    pub const ALL: [Family; 10] = [
        Family::Boxes,
        Family::Touching,
        Family::Slivers,
        Family::Coplanar,
        Family::Bright,
        Family::Lamps,
        Family::Open,
        Family::Piercing,
        Family::Anything,
        Family::Furnaces,
    ];
}

/// Rooms of each family.
pub const EACH: u64 = 50;

/// A room, and what is known of it.
pub struct RandomRoom {
    pub scene: Scene,
    /// `B`, W/m², where it is the same everywhere.
    pub known: Option<Rgb>,
}

/// An outline, its emission and its reflectance.
type Face = (Polygon, Rgb, Rgb);

/// The room of this number, from 0.
pub fn random_room(family: Family, number: u64) -> RandomRoom {
    let random = Stream::named(family as u64, &[number]);
    let mut draw = Draw { family, random };
    let size = draw.size();
    let mut faces = draw.walls(size);
    draw.boxes(size, &mut faces);
    draw.sheets(size, &mut faces);
    let (known, scale) = (draw.light(&mut faces, number), draw.log(1e-3, 1e3));
    let turn = DQuat::from_axis_angle(draw.point(DVec3::ONE).normalize(), draw.to(TAU));
    let turn = if draw.chance(0.5) { turn } else { DQuat::IDENTITY };
    let place =
        |(polygon, e, rho): Face| (moved(&polygon, |v| scale * (turn * v)), e, rho);
    RandomRoom { scene: coloured_scene(faces.into_iter().map(place)), known }
}

/// Draws what a family may have.
struct Draw {
    family: Family,
    random: Stream,
}

impl Draw {
    /// From 0 to `most`.
    fn to(&mut self, most: f64) -> f64 {
        most * self.random.next()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.to(high - low)
    }

    /// Between the two, as often below their geometric mean as above.
    fn log(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    fn chance(&mut self, of: f64) -> bool {
        self.random.next() < of
    }

    /// From 0 to `below - 1`.
    fn below(&mut self, below: usize) -> usize {
        self.to(below as f64) as usize
    }

    /// Somewhere in a box.
    fn point(&mut self, size: DVec3) -> DVec3 {
        size * dvec3(self.random.next(), self.random.next(), self.random.next())
    }

    /// Has this room what the family `family` is about?
    fn has(&mut self, family: Family) -> bool {
        self.family == family || (self.family == Family::Anything && self.chance(0.4))
    }

    /// Sides of the room, near 1; of a corridor, up to 1000 to 1.
    fn size(&mut self) -> DVec3 {
        let size = dvec3(self.log(0.5, 2.0), self.log(0.5, 2.0), self.log(0.5, 2.0));
        match self.has(Family::Slivers) && self.chance(0.3) {
            true => size * dvec3(1.0, 1.0, self.log(1e-3, 1.0)),
            false => size,
        }
    }

    fn colour(&mut self) -> Rgb {
        let wide = matches!(self.family, Family::Anything | Family::Furnaces);
        let bright = self.family == Family::Bright || wide && self.chance(0.3);
        let darkest = if wide { 1.0 } else { 1e-1 };
        let mut channel = || match bright {
            true => 1.0 - self.log(1e-3, darkest),
            false => self.to(0.9),
        };
        Rgb::new(channel(), channel(), channel())
    }

    fn walls(&mut self, size: DVec3) -> Vec<Face> {
        let mut walls: Vec<Face> =
            box_walls(size.to_array()).map(|w| (w, Rgb::ZERO, self.colour())).to_vec();
        if self.has(Family::Open) {
            for _ in 0..1 + self.below(3) {
                let missing = self.below(walls.len());
                walls.remove(missing);
            }
        }
        walls
    }

    /// Up to four boxes, each in a corner of the plan of its own, unless they may pierce.
    fn boxes(&mut self, size: DVec3, faces: &mut Vec<Face>) {
        let (touching, piercing) =
            (self.has(Family::Touching), self.has(Family::Piercing));
        let slivers = self.has(Family::Slivers);
        let fewest = usize::from(touching || piercing || slivers);
        for corner in 0..fewest + self.below(4 - fewest) {
            let half = size * dvec3(0.5, 0.5, 1.0);
            let low = half * dvec3((corner % 2) as f64, (corner / 2) as f64, 0.0);
            let share = dvec3(
                self.between(0.2, 0.7),
                self.between(0.2, 0.7),
                self.between(0.1, 0.7),
            );
            let mut sides = half * share;
            if slivers {
                let thin = self.below(3);
                sides[thin] = sides.max_element() * self.log(1e-3, 1e-1);
            }
            let mut at = low + self.point(half - sides);
            let gap = match touching {
                true => size.max_element() * self.log(1e-6, 1e-2),
                false => 0.0,
            };
            let stands = self.family != Family::Furnaces && self.chance(0.5);
            if stands || touching {
                at.z = gap;
            }
            if touching && self.chance(0.5) {
                at.x = low.x + gap; // beside a wall, or the next box
            }
            if piercing {
                at = self.point(size) - 0.5 * sides;
            }
            self.add_box(at, sides, !stands || gap > 0.0, touching, faces);
        }
    }

    /// A box, turned about the vertical unless it is to stay where it is; with or without
    /// a bottom.
    fn add_box(
        &mut self,
        at: DVec3,
        sides: DVec3,
        bottom: bool,
        stays: bool,
        faces: &mut Vec<Face>,
    ) {
        let half = 0.5 * sides;
        // However turned, it keeps within the circle that it fits in.
        let fits = half.x.min(half.y) / half.truncate().length();
        let turned = !stays && self.chance(0.5);
        let (turn, shrink) = match turned {
            true => (DQuat::from_rotation_z(self.to(TAU)), dvec3(fits, fits, 1.0)),
            false => (DQuat::IDENTITY, DVec3::ONE),
        };
        let place = |v: DVec3| at + half + turn * (shrink * (v - half));
        let colour = self.colour();
        for (k, wall) in box_walls(sides.to_array()).into_iter().enumerate() {
            if bottom || k != 4 {
                faces.push((moved(&wall, place).flipped(), Rgb::ZERO, colour));
            }
        }
    }

    /// Sheets that hang before walls, as near as rounding and nearer.
    fn sheets(&mut self, size: DVec3, faces: &mut Vec<Face>) {
        if !self.has(Family::Coplanar) {
            return;
        }
        let walls: Vec<Polygon> = box_walls(size.to_array()).into_iter().collect();
        for _ in 0..1 + self.below(4) {
            let wall = &walls[self.below(6)];
            let off = size.length() * self.log(1e-7, 1e-3);
            let tilt = if self.chance(0.5) { self.to(0.5) * off } else { 0.0 };
            let sheet = self.part_of(wall, 0.2).vertices().to_vec();
            let n = wall.normal();
            let lifted = sheet.iter().zip([off, off, off + tilt, off + tilt]);
            let lifted = lifted.map(|(&v, by)| v + by * n).collect();
            faces.push((Polygon::new(lifted).unwrap(), Rgb::ZERO, self.colour()));
        }
    }

    /// A rectangle on a wall, about this share of it.
    fn part_of(&mut self, wall: &Polygon, share: f64) -> Polygon {
        let v = wall.vertices();
        let (a, b) = (v[1] - v[0], v[3] - v[0]);
        let along = self.between(share, share.sqrt().max(share)).min(1.0);
        let across = (share / along).min(1.0);
        let corner = v[0] + self.to(1.0 - along) * a + self.to(1.0 - across) * b;
        super::rooms::rectangle(corner, along * a, across * b)
    }

    /// Lamps: what is known of the light, if it is.
    fn light(&mut self, faces: &mut Vec<Face>, number: u64) -> Option<Rgb> {
        if self.family == Family::Furnaces {
            let b = self.log(1e-3, 1e3) * self.point(Rgb::ONE).max(Rgb::splat(0.1));
            for (k, (_, e, rho)) in faces.iter_mut().enumerate() {
                let off = if number % 2 == 1 && k == 0 { 1e-9 } else { 0.0 };
                *e = (1.0 + off) * (Rgb::ONE - *rho) * b;
            }
            return Some(b);
        }
        let area: f64 = faces.iter().map(|f| f.0.area()).sum();
        let share = self.log(1e-3, 1.0);
        let lamps = match self.has(Family::Lamps) {
            true => self.log(1.0, 40.0) as usize,
            false => 1 + self.below(2),
        };
        let mut left = share * area;
        let places = faces.len();
        for k in 0..lamps {
            let emission = self.log(0.1, 10.0) * self.point(Rgb::ONE);
            let face = self.below(places);
            let part = left / (lamps - k) as f64 / faces[face].0.area();
            if part > 0.5 {
                faces[face].1 = emission;
                left -= faces[face].0.area();
            } else if part > 0.0 {
                let wall = faces[face].0.clone();
                let lamp = self.part_of(&wall, part);
                left -= lamp.area();
                faces.push((lamp, emission, self.colour()));
            }
        }
        None
    }
}

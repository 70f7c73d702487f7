//! The second of two passes: diffuse light is known, what shines is followed.

use super::expose::{Along, First, Looked, Shown, expose, followed};
use super::gather::{FinalGather, GatherPoint};
use super::gloss::Glossy;
use super::look::Look;
use super::tree::{Journey, Tally, Tree};
use crate::field::Field;
use crate::film::Shot;
use crate::geometry::{Ray, Rgb};
use crate::mesh::{ElementId, Locator, Mesh};
use crate::room::{LampsSeen, Panes, Room};
use crate::ways::Meeting;
use crate::work::Progress;
use std::borrow::Cow;
use std::f64::consts::PI;

/// A scene with its diffuse light, ready to be looked at.
#[derive(Debug)]
pub struct TwoPass<'s> {
    tree: Tree<'s>,
    mesh: &'s Mesh,
    /// `B`, W/m², per vertex of the mesh.
    radiosity: Cow<'s, [Rgb]>,
    locator: Locator,
    lamps: LampsSeen<'s>,
}

impl<'s> TwoPass<'s> {
    /// Of a room whose diffuse light was found.
    pub fn of<'r: 's>(room: &Room<'r>, field: &'s Field, look: Look) -> TwoPass<'s> {
        let radiosity = Cow::Owned(field.vertex_radiosity(room.scene));
        TwoPass::with(room, &field.mesh, radiosity, look)
    }

    /// Of a room on which this light is shown: `radiosity` is `B`, W/m², of each vertex of
    /// `mesh`, with the surfaces' own emission.
    pub fn showing<'r: 's>(
        room: &Room<'r>,
        mesh: &'s Mesh,
        radiosity: &'s [Rgb],
        look: Look,
    ) -> TwoPass<'s> {
        TwoPass::with(room, mesh, Cow::Borrowed(radiosity), look)
    }

    fn with<'r: 's>(
        room: &Room<'r>,
        mesh: &'s Mesh,
        radiosity: Cow<'s, [Rgb]>,
        look: Look,
    ) -> TwoPass<'s> {
        let scene = room.scene;
        assert_eq!(radiosity.len(), mesh.vertices.len(), "one B for each vertex");
        let lamps = LampsSeen::of(room, Panes::Block);
        let pieces = mesh.elements.iter().map(|e| (mesh.surface_of(e), &e.polygon));
        let locator = Locator::of(scene, pieces);
        let lamps_are_counted = lamps.are_few();
        let tree = Tree { lamps_are_counted, ..Tree::of(room, look) };
        TwoPass { tree, mesh, radiosity, locator, lamps }
    }

    /// What a camera sees.
    ///
    /// Of what shows a diffuse surface first, the stored light is taken as
    /// [`Shot::smooth`] does; only where something shines are rays followed: none, if
    /// nothing does. Deterministic: the same at any number of threads.
    pub fn picture(&self, shot: &Shot, progress: Progress) -> Shown {
        // ANCHOR: picture
        let radiance = |first: &First, tally: &mut Tally| match first {
            First::Element(element, at) if self.is_stored(at) => {
                let element = &self.mesh.elements[*element as usize];
                self.mesh.value_at(element, at.point, &self.radiosity) / PI
            }
            other => followed(&self.tree, other, tally, &|at, journey, tally| {
                self.shade(at, journey, tally)
            }),
        };
        let (tree, mesh, seed) = (&self.tree, self.mesh, self.tree.look.seed);
        expose(shot, &Looked { tree, mesh, seed }, &radiance, progress)
        // ANCHOR_END: picture
    }

    /// What comes against a ray.
    pub fn along(&self, ray: &Ray) -> Along {
        Along::of(&self.tree, ray, self.tree.look.seed, &|at, journey, tally| {
            self.shade(at, journey, tally)
        })
    }

    /// Is all that leaves here stored?
    fn is_stored(&self, at: &Meeting) -> bool {
        at.front && self.tree.look.gather == 0 && at.material.shine().is_dull()
    }

    /// The diffuse light and the gloss of what a ray meets.
    fn shade(&self, at: &Meeting, journey: &Journey, tally: &mut Tally) -> Rgb {
        if !at.front {
            return Rgb::ZERO; // black, unless it is a surface of its own
        }
        // ANCHOR: shade
        let gathers = self.tree.look.gather > 0 && journey.depth == 0;
        let diffuse =
            if gathers { self.gather(at, journey, tally) } else { self.stored(at) };
        let counted = match journey.lamps_are_counted {
            true => at.material.emission() / PI,
            false => Rgb::ZERO,
        };
        diffuse - counted + self.gloss(at, journey, tally)
        // ANCHOR_END: shade
    }

    /// `B/π` as it was found, W/(m² sr).
    // ANCHOR: stored
    fn stored(&self, at: &Meeting) -> Rgb {
        let outline = |id: u32| &self.mesh.element(ElementId(id)).polygon;
        let element = self.locator.piece(at.surface, at.point, outline);
        element.map_or(Rgb::ZERO, |id| {
            let element = self.mesh.element(ElementId(id));
            self.mesh.value_at(element, at.point, &self.radiosity) / PI
        })
    }
    // ANCHOR_END: stored

    /// What gloss shows, W/(m² sr): the lamps exactly if they are few, all else by rays.
    // ANCHOR: gloss
    fn gloss(&self, at: &Meeting, journey: &Journey, tally: &mut Tally) -> Rgb {
        let Some(glossy) = Glossy::of(at, self.tree.look) else { return Rgb::ZERO };
        let lamps = match self.tree.lamps_are_counted {
            true => glossy.of_lamps(&self.lamps, tally.offset()),
            false => Rgb::ZERO,
        };
        let shade =
            |at: &Meeting, on: &Journey, tally: &mut Tally| self.shade(at, on, tally);
        lamps + glossy.by_rays(&self.tree, journey, tally, &shade)
    }
    // ANCHOR_END: gloss

    /// The diffuse light of a point, W/(m² sr), gathered anew from all sides: final
    /// gathering.
    ///
    /// ```text
    /// L = (E + ρ H + τ H_back)/π
    /// ```
    fn gather(&self, at: &Meeting, journey: &Journey, tally: &mut Tally) -> Rgb {
        let surface = &self.tree.scene.surfaces[at.surface as usize];
        let material = at.material;
        let mut on = |surface: u32, share: Rgb| {
            if share == Rgb::ZERO {
                return Rgb::ZERO;
            }
            let normal = self.tree.scene.surfaces[surface as usize].polygon.normal();
            let place = GatherPoint { surface, at: at.point, normal };
            let shade = |at: &Meeting, on: &Journey, tally: &mut Tally| {
                self.shade(at, on, tally)
            };
            let rays = self.tree.look.gather;
            let by = FinalGather { tree: &self.tree, lamps: &self.lamps, rays };
            share * by.irradiance(&place, journey, tally, &shade)
        };
        let front = on(at.surface, material.diffuse());
        let back = surface.back.map_or(Rgb::ZERO, |b| on(b, material.translucence()));
        (material.emission() + front + back) / PI
    }
}

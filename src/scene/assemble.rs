//! From faces to surfaces: splits what is not convex or not planar, settles overlaps.

use super::{Camera, Face, FaceId, MaterialId, Scene, Side, Surface, layers, overlap};
use crate::geometry::{PolygonError, Rgb, split};
use crate::material::Material;
use std::collections::HashMap;
use std::fmt;

/// What was repaired on the way from faces to surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Repair {
    /// A face was not convex or not planar, and is several surfaces now.
    Split {
        /// Which face.
        face: FaceId,
        /// How many surfaces it became.
        pieces: usize,
        /// What was wrong with it.
        reason: PolygonError,
    },
    /// Two coplanar faces that look the same way overlapped; the smaller one won.
    Covered {
        /// The face that lost surface.
        face: FaceId,
        /// The smaller face, or of two equal ones the earlier.
        by: FaceId,
        /// How much was taken away, in scene units squared.
        area: f64,
    },
}

impl Repair {
    /// The face that was changed.
    pub fn face(&self) -> FaceId {
        match *self {
            Repair::Split { face, .. } | Repair::Covered { face, .. } => face,
        }
    }

    /// The face that it had to give way to.
    pub fn by(&self) -> Option<FaceId> {
        match *self {
            Repair::Split { .. } => None,
            Repair::Covered { by, .. } => Some(by),
        }
    }
}

impl fmt::Display for Repair {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Repair::Split { face, pieces, reason } => {
                let what = match reason {
                    PolygonError::NotPlanar(off) => {
                        format!("not planar (off by {off:.3e})")
                    }
                    _ => "not convex".into(),
                };
                write!(
                    f,
                    "face {} is {what}; it was split into {pieces} pieces",
                    face.0
                )
            }
            Repair::Covered { face, by, area } => write!(
                f,
                "face {} overlaps the smaller face {} in one plane, both looking the same \
                 way; the part beneath (area {area:.6}) was cut out of it",
                face.0, by.0
            ),
        }
    }
}

/// Why faces make no scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// There is no face at all.
    NoFaces,
    /// A face is no surface and cannot be made one.
    Face {
        /// Which face.
        face: FaceId,
        /// What is wrong with it.
        reason: PolygonError,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            SceneError::NoFaces => {
                write!(f, "there is no face; a scene needs at least one")
            }
            SceneError::Face { face, reason } => write!(f, "face {} {reason}", face.0),
        }
    }
}

impl std::error::Error for SceneError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            SceneError::NoFaces => None,
            SceneError::Face { reason, .. } => Some(reason),
        }
    }
}

impl Scene {
    /// Makes a scene of faces.
    ///
    /// Faces that are not convex or not planar are [split](split()). Where coplanar faces
    /// that look the same way overlap by more than rounding, the smaller one wins (the
    /// earlier of two equal ones): the other loses the part beneath, so no two surfaces
    /// fight for the same points. It is then cut into convex pieces around the winner; a
    /// face with nothing left still counts as a face, of area 0. Faces back to back and
    /// faces that share an edge do not overlap. Nothing is lost where a pane, or a sheet that
    /// lets light through, lies in the plane of another face, whichever way they look: it
    /// stands a hair before that face, and before larger ones of its kind. Without a `camera`
    /// the scene gets [`Camera::showing`] its surfaces, the y-axis up.
    ///
    /// # Errors
    /// When there is no face; and for a face that [`split()`] refuses: no area, edges that
    /// cross, coordinates that are not finite.
    pub fn assemble(
        name: impl Into<String>,
        materials: Vec<Material>,
        faces: Vec<Face>,
        camera: Option<Camera>,
    ) -> Result<(Scene, Vec<Repair>), SceneError> {
        if faces.is_empty() {
            return Err(SceneError::NoFaces);
        }
        let mut warnings = Vec::new();
        let mut surfaces = Vec::with_capacity(faces.len());
        for (id, Face { outline, material }) in faces.iter().enumerate() {
            debug_assert!((material.0 as usize) < materials.len(), "no such material");
            let face = FaceId(id as u32);
            let polygons =
                split(outline).map_err(|reason| SceneError::Face { face, reason })?;
            if let (pieces @ 2.., Err(reason)) =
                (polygons.len(), crate::geometry::Polygon::new(outline.clone()))
            {
                warnings.push(Repair::Split { face, pieces, reason });
            }
            let surface = |polygon| Surface {
                polygon,
                material: *material,
                face,
                side: Side::Front,
                back: None,
            };
            surfaces.extend(polygons.into_iter().map(surface));
        }
        let passes = |s: &Surface| {
            let material = &materials[s.material.0 as usize];
            material.shine().pane().is_some() || material.translucence() != Rgb::ZERO
        };
        layers::lift(&mut surfaces, faces.len(), &passes);
        let surfaces = overlap::settled(surfaces, faces.len(), &passes, &mut warnings);
        let camera =
            camera.unwrap_or_else(|| Camera::showing(&surfaces, glam::DVec3::Y));
        let mut scene =
            Scene { name: name.into(), faces, surfaces, materials, camera, sky: None };
        scene.add_backs(|material| material.translucence() != Rgb::ZERO, false);
        Ok((scene, warnings))
    }

    /// The same scene with all opaque faces reflecting on both sides.
    #[must_use]
    pub fn two_sided(mut self) -> Scene {
        self.add_backs(|material| !material.shine().passes(), true);
        self
    }

    /// Gives all surfaces of front sides that are `wanted` and have none a back: a second
    /// surface in the same place that looks the other way. Those that have one already get
    /// its material anew.
    pub(super) fn add_backs(
        &mut self,
        wanted: impl Fn(&Material) -> bool,
        two_sided: bool,
    ) {
        let mut material_of_back: HashMap<u32, MaterialId> = HashMap::new();
        for k in 0..self.surfaces.len() {
            let front = self.surfaces[k].clone();
            let material = self.material(&front);
            if front.side == Side::Back || !wanted(material) {
                continue;
            }
            let next = MaterialId(self.materials.len() as u32);
            let id = *material_of_back.entry(front.material.0).or_insert(next);
            if id == next {
                self.materials.push(material.back(two_sided));
            }
            match front.back {
                Some(back) => self.surfaces[back as usize].material = id,
                None => {
                    self.surfaces[k].back = Some(self.surfaces.len() as u32);
                    self.surfaces.push(Surface {
                        polygon: front.polygon.flipped(),
                        material: id,
                        side: Side::Back,
                        back: Some(k as u32),
                        ..front
                    });
                }
            }
        }
    }
}

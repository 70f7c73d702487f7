//! The account of smooth light: what the patches sent, and where it went.

use super::system::{CornerRow, System};
use crate::field::Field;
use crate::geometry::Rgb;
use crate::mesh::PatchId;
use crate::scene::Scene;
use crate::solve::{Enclosure, Ledger, LostPower};

impl System<'_> {
    /// Where the light of the `field` went; `patch_of` tells the patch of each element.
    /// Unshot is by how much the field differs from what the patches sent.
    ///
    /// What mirrors and panes send on is counted by who sent it.
    pub fn ledger(
        &self,
        scene: &Scene,
        field: &Field,
        reflected: &[Rgb],
        patch_of: &[PatchId],
    ) -> Ledger {
        let sent = self.mean_radiosity(reflected);
        let mesh = &field.mesh;
        let fine = Enclosure::of(scene, mesh);
        let (irradiance, radiosity) = (field.irradiance(), field.radiosity(scene));
        let unshot = |k: usize| radiosity[k] - sent[patch_of[k]];
        let unshot: Vec<Rgb> = (0..radiosity.len()).map(unshot).collect();
        let mut power = LostPower::default();
        let mut sky = Rgb::ZERO;
        for (k, element) in self.mesh().elements.iter().enumerate() {
            let rows = element.corners.iter().map(|&c| &self.rows[c]);
            let rows: Vec<&CornerRow> = rows.filter(|row| row.looked()).collect();
            for row in &rows {
                let share = self.patches.enclosure.area[k] / rows.len() as f64;
                power.escaped += share * sent[k] * row.lost.escaped;
                power.absorbed += share * sent[k] * row.lost.absorbed;
                sky += share * row.sky;
            }
        }
        for (k, element) in mesh.elements.iter().enumerate() {
            sky += fine.area[k] * self.direct.of_sky(&element.polygon);
        }
        let mut ledger = Ledger::draw_up(&fine, &irradiance, &unshot, power);
        ledger.emitted += sky;
        ledger.imbalance += sky;
        ledger
    }
}

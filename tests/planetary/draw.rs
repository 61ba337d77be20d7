//! Drawings of planetary sets.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::{GearSpec, LinkageSpec};

/// The shafts of a planetary set, the points at which they end, and their drawn angles.
pub(crate) const SHAFTS: [&str; 3] = ["sun", "carrier", "ring"];
const ENDS: [&str; 3] = ["S", "P0", "R"];
pub(crate) const DRAWN: [f64; 3] = [0.4, 1.3, -0.8];

pub(crate) fn gear(links: [&str; 2], carrier: &str, teeth: [u32; 2], mesh: Mesh) -> GearSpec {
    GearSpec {
        links: links.map(str::to_owned),
        carrier: carrier.to_owned(),
        teeth: teeth.map(f64::from),
        mesh,
    }
}

/// A satellite: its teeth in mesh with the sun, and with the ring.
pub(crate) type Stepped = [u32; 2];

/// Sun, ring and carrier on one axis, with satellites at equal distances; nothing is driven yet.
pub(crate) fn set([sun, ring]: [u32; 2], satellites: &[Stepped]) -> LinkageSpec {
    let mut draft = LinkageSpec::default().point("A", 0.0, 0.0).fixed(&["A"]);
    let arm = 0.5 * f64::from(sun + satellites[0][0]);
    for ((shaft, end), angle) in SHAFTS.into_iter().zip(ENDS).zip(DRAWN) {
        draft = draft.point(end, arm * angle.cos(), arm * angle.sin());
        draft = draft.bar(shaft, &["A", end]);
    }
    for (k, teeth) in satellites.iter().enumerate() {
        let [name, hinge, tip] = ["satellite", "P", "Q"].map(|name| format!("{name}{k}"));
        let at = DRAWN[1] + TAU * k as f64 / satellites.len() as f64;
        let [x, y] = [arm * at.cos(), arm * at.sin()];
        if k > 0 {
            draft = draft.point(&hinge, x, y);
            draft.links[1].points.push(hinge.clone());
        }
        draft = draft
            .point(&tip, x + 2.0, y - 3.0)
            .bar(&name, &[&hinge, &tip]);
        draft.gears.extend([
            gear(["sun", &name], "carrier", [sun, teeth[0]], Mesh::External),
            gear([&name, "ring"], "carrier", [teeth[1], ring], Mesh::Internal),
        ]);
    }
    draft
}

/// A dice: the same numbers for the same seed.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    /// From 0 to 1.
    pub(crate) fn part(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, [from, to]: [f64; 2]) -> f64 {
        from + (to - from) * self.part()
    }

    /// Of these, ends included.
    pub(crate) fn whole(&mut self, [from, to]: [u32; 2]) -> u32 {
        (from + (f64::from(to - from + 1) * self.part()) as u32).min(to)
    }
}

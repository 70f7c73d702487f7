//! Links: from where a node gathers, and how far that may be wrong.

use super::tree::{Forest, Node, NodeId};
use crate::form_factor::{FactorEstimate, Obstruction, estimate};
use crate::geometry::Rgb;
use crate::occlusion::Blockers;
use glam::{DMat3, DVec3, Vec3};

/// A node's view of another, near or far, small or large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Whose light arrives.
    pub source: NodeId,
    /// The form factor from the receiver to the source.
    pub factor: f64,
    /// May something stand between?
    pub sight: Obstruction,
    /// How fast the factor grows along the receiver, in 1/scene units.
    slope: Vec3,
    /// How far it is from growing so evenly.
    bend: f32,
    /// How far the factor varies over the source, in units of the factor from the
    /// receiver; negative until it is asked for.
    source_spread: f32,
}

impl Link {
    /// The link over which `receiver` gathers from `source`; `None` when they do not see
    /// each other.
    pub(super) fn between(
        receiver: &Node,
        (source, at): (NodeId, &Node),
        scene: &Blockers,
        sight: Obstruction,
    ) -> Option<Link> {
        let FactorEstimate { mean, slope, bend, sight, .. } =
            estimate(&receiver.polygon, &at.polygon, scene, sight);
        (sight != Obstruction::Hidden).then_some(Link {
            source,
            factor: mean,
            sight,
            slope: slope.as_vec3(),
            bend: bend as f32,
            source_spread: -1.0,
        })
    }

    /// What arrives from a source of this radiosity: its mean over the receiver, W/m², and
    /// by how much it grows along each axis, W/m² per scene unit.
    pub(super) fn arriving(&self, radiosity: Rgb) -> (Rgb, DMat3) {
        let DVec3 { x, y, z } = self.slope.as_dvec3();
        let slope = DMat3::from_cols(x * radiosity, y * radiosity, z * radiosity);
        (self.factor * radiosity, slope)
    }

    /// How far the factor varies over the source, in units of the factor from the
    /// receiver; or an upper bound, if even that is no more than `matters`.
    fn source_spread(
        &mut self,
        receiver: &Node,
        source: &Node,
        scene: &Blockers,
        matters: f64,
    ) -> f64 {
        if self.source_spread < 0.0 {
            let ratio = source.polygon.area() / receiver.polygon.area();
            // The spread of a number between 0 and 1 with this mean is no larger.
            let most = (self.factor * ratio).sqrt();
            if most <= matters {
                return most;
            }
            let back = estimate(&source.polygon, &receiver.polygon, scene, self.sight);
            let missed = (back.mean * ratio - self.factor).abs();
            self.source_spread = (ratio * back.spread).max(missed) as f32;
        }
        f64::from(self.source_spread)
    }
}

/// What is to become of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LinkVerdict {
    Keep,
    /// From each piece of the source.
    DivideSource,
    /// To each piece of the receiver; the error is so many times what is allowed.
    DivideReceiver(f64),
}

/// How far light may be wrong.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    /// 1 over the root mean square of the reflected light `ρ H`, per channel.
    pub scale: Rgb,
    /// `Σ A`.
    pub area: f64,
    /// The relative error asked for.
    pub error: f64,
    /// No node is divided into pieces that are smaller.
    pub smallest: f64,
}

/// A surface that reflects less than this wants to know its irradiance all the same.
const BLACK: f64 = 0.1;

/// The share of the error asked for that one link may cause: there are some tens over an
/// element. With a tenth as much, links are twice as many for the same error.
const SHARE: f64 = 0.03;

/// The share of the error of an element that one link may cause where that is more: at
/// edges that surfaces share, where factors are bent however small the nodes are. There
/// sources err together: with all of it the error is twice as large.
const SHARE_OF_NODE: f64 = 0.2;

/// `ρ`, or what counts in its place where it is less.
pub(super) fn reflecting(node: &Node) -> Rgb {
    node.reflectance.max(Rgb::splat(BLACK))
}

impl Allowed {
    /// Judges a link: at the receiver it may be bent, at the source the light uneven.
    pub(super) fn judge(
        &self,
        forest: &Forest,
        scene: &Blockers,
        receiver: NodeId,
        link: &mut Link,
    ) -> LinkVerdict {
        let (node, source) = (forest.node(receiver), forest.node(link.source));
        let weight = reflecting(node) * self.scale;
        let light = (weight * forest.radiosity(link.source)).max_element();
        // ANCHOR: verdict
        let most = (SHARE_OF_NODE * self.element(node)).max(SHARE * self.error);
        let bent = light * f64::from(link.bend) / most;
        let uneven = (weight * forest.unevenness(link.source)).max_element();
        let matters = SHARE * self.error / uneven;
        let spread = link.source_spread(node, source, scene, matters) / matters;
        // ANCHOR_END: verdict
        let divisible = !node.is_leaf() || node.is_divisible(self.smallest);
        if bent > 1.0 && bent > spread && divisible {
            LinkVerdict::DivideReceiver(bent)
        } else if spread > 1.0 {
            LinkVerdict::DivideSource
        } else {
            LinkVerdict::Keep
        }
    }

    /// The relative error allowed to a node for itself: its share of `ε²` in the square.
    fn element(&self, node: &Node) -> f64 {
        self.error * self.error * (self.area / node.polygon.area()).sqrt()
    }

    /// By how many times too much the light varies over an element; 0 when it cannot be
    /// divided.
    pub(super) fn varies(&self, forest: &Forest, id: NodeId) -> f64 {
        let node = forest.node(id);
        if !node.is_leaf() || !node.is_divisible(self.smallest) {
            return 0.0;
        }
        let corners = node.polygon.vertices();
        let square = |&v: &DVec3| {
            let off = forest.slope(id) * (v - node.centre);
            off * off
        };
        // Over a parallelogram the mean square is a third of the corners'.
        let mean = corners.iter().map(square).sum::<Rgb>() / corners.len() as f64 / 3.0;
        let spread = Rgb::from_array(mean.to_array().map(f64::sqrt));
        (reflecting(node) * self.scale * spread).max_element() / self.element(node)
    }
}

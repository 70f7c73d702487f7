//! The trees: surfaces divided in four again and again, and light going up and down them.

use super::Link;
use crate::geometry::{Polygon, Rgb};
use crate::mesh::{Element, Mesh};
use crate::scene::Scene;
use glam::{DMat3, DVec3};
use std::ops::Range;

/// Which node of a [`Forest`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

impl NodeId {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A piece of a surface: a leaf of its tree is an element, other nodes are all of the
/// elements below.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its outline.
    pub polygon: Polygon,
    /// Its centre of mass.
    pub centre: DVec3,
    /// Which of [`Scene::surfaces`] it is a piece of.
    pub surface: u32,
    /// How often the surface's piece was divided to come to it; 0 at the root.
    pub level: u32,
    /// The pieces that it was divided into; empty for a leaf. They come after it.
    pub children: Range<u32>,
    /// From where it gathers.
    pub links: Vec<Link>,
    emission: Rgb,
    pub(super) reflectance: Rgb,
}

/// NodeLight at the nodes, all in W/m².
#[derive(Clone, Debug, Default)]
pub(super) struct NodeLight {
    /// `B`, the mean over the elements below.
    pub radiosity: Vec<Rgb>,
    /// The mean of `B²` over the elements below.
    pub square: Vec<Rgb>,
    /// What arrives over the node's own links; after a push, over those above as well.
    pub irradiance: Vec<Rgb>,
    /// How fast that grows along each axis, W/m² per scene unit.
    pub slope: Vec<DMat3>,
}

/// All trees of a scene; parents come before their children.
#[derive(Clone, Debug)]
pub struct Forest {
    /// The nodes; the first [`Forest::roots`] of them are the roots.
    pub nodes: Vec<Node>,
    /// How many trees.
    pub roots: usize,
    pub(super) leaves: usize,
    pub(super) light: NodeLight,
}

impl Forest {
    /// A root for each piece of a surface between its contact lines; `B = E`.
    pub(super) fn of(scene: &Scene) -> Forest {
        let whole = Mesh::patched(scene, f64::INFINITY);
        let root = |element: &Element| {
            let patch = whole.patch_of(element);
            let material = &scene.materials[patch.material];
            Node {
                centre: element.polygon.centroid(),
                polygon: element.polygon.clone(),
                surface: patch.surface,
                level: 0,
                children: 0..0,
                links: Vec::new(),
                emission: material.emission(),
                reflectance: material.diffuse(),
            }
        };
        let nodes: Vec<Node> = whole.elements.iter().map(root).collect();
        let emission = || nodes.iter().map(|n| n.emission);
        let light = NodeLight {
            radiosity: emission().collect(),
            square: emission().map(|e| e * e).collect(),
            irradiance: vec![Rgb::ZERO; nodes.len()],
            slope: vec![DMat3::ZERO; nodes.len()],
        };
        let n = nodes.len();
        Forest { nodes, roots: n, leaves: n, light }
    }

    /// The node `id`.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// The leaves, which are the elements, tree by tree.
    pub fn leaves(&self) -> impl Iterator<Item = NodeId> + '_ {
        (0..self.roots as u32).flat_map(|root| self.leaves_of(NodeId(root)))
    }

    /// The leaves of one tree.
    pub(super) fn leaves_of(&self, root: NodeId) -> Vec<NodeId> {
        let (mut found, mut stack) = (Vec::new(), vec![root]);
        while let Some(id) = stack.pop() {
            let children = &self.node(id).children;
            if children.is_empty() {
                found.push(id);
            }
            stack.extend(children.clone().rev().map(NodeId));
        }
        found
    }

    /// Divides a leaf; its children start with its light. Does nothing when the pieces
    /// would be smaller than `smallest`, or the node has been divided before.
    pub(super) fn divide(&mut self, id: NodeId, smallest: f64) {
        let k = id.index();
        let parent = &self.nodes[k];
        if !parent.children.is_empty() || !parent.is_divisible(smallest) {
            return;
        }
        let pieces = pieces(&parent.polygon);
        let first = self.nodes.len() as u32;
        let child = |polygon: Polygon| Node {
            centre: polygon.centroid(),
            polygon,
            level: parent.level + 1,
            children: 0..0,
            links: Vec::new(),
            ..*parent
        };
        let children: Vec<Node> = pieces.into_iter().map(child).collect();
        self.leaves += children.len() - 1;
        let light = &mut self.light;
        for child in &children {
            let step = child.centre - parent.centre;
            light.radiosity.push(light.radiosity[k]);
            light.square.push(light.square[k]);
            light.irradiance.push(light.irradiance[k] + light.slope[k] * step);
            light.slope.push(light.slope[k]);
        }
        self.nodes.extend(children);
        self.nodes[k].children = first..self.nodes.len() as u32;
    }

    // ANCHOR: push
    /// Down: what arrives at a node arrives at all its elements, here less, there more.
    pub(super) fn push(&mut self) {
        let NodeLight { irradiance, slope, .. } = &mut self.light;
        for (k, node) in self.nodes.iter().enumerate() {
            let (mean, grows) = (irradiance[k], slope[k]);
            for c in node.children.clone().map(|c| c as usize) {
                irradiance[c] += mean + grows * (self.nodes[c].centre - node.centre);
                slope[c] += grows;
            }
        }
    }
    // ANCHOR_END: push

    // ANCHOR: pull
    /// Elements reflect; and up: the radiosity of a node is the mean of its children's,
    /// by area.
    pub(super) fn pull(&mut self) {
        let NodeLight { radiosity, square, irradiance, .. } = &mut self.light;
        for (k, node) in self.nodes.iter().enumerate().rev() {
            if node.is_leaf() {
                radiosity[k] = node.reflected(irradiance[k]);
                square[k] = radiosity[k] * radiosity[k];
            } else {
                let children = || node.children.clone().map(|c| c as usize);
                let area = |c: usize| self.nodes[c].polygon.area();
                let all: f64 = children().map(area).sum();
                let mean = |of: &[Rgb]| -> Rgb {
                    children().map(|c| area(c) / all * of[c]).sum()
                };
                (radiosity[k], square[k]) = (mean(radiosity), mean(square));
            }
        }
    }
    // ANCHOR_END: pull

    /// `B` of a node, W/m²: the mean over its elements.
    pub fn radiosity(&self, id: NodeId) -> Rgb {
        self.light.radiosity[id.index()]
    }

    /// `H` of a leaf, W/m²; of other nodes what has arrived over their links and those
    /// above.
    pub fn irradiance(&self, id: NodeId) -> Rgb {
        self.light.irradiance[id.index()]
    }

    /// How fast the irradiance of a leaf grows along each axis, W/m² per scene unit.
    pub fn slope(&self, id: NodeId) -> DMat3 {
        self.light.slope[id.index()]
    }

    /// The standard deviation of `B` over the elements of a node.
    pub(super) fn unevenness(&self, id: NodeId) -> Rgb {
        let (mean, square) = (self.radiosity(id), self.light.square[id.index()]);
        let variance = (square - mean * mean).max(Rgb::ZERO);
        // What cancels to rounding is even.
        let real = variance.cmpgt(1e-13 * square);
        let root = variance.to_array().map(f64::sqrt);
        Rgb::select(real, Rgb::from_array(root), Rgb::ZERO)
    }
}

impl Node {
    /// `B = E + ρ H`.
    pub(super) fn reflected(&self, irradiance: Rgb) -> Rgb {
        self.emission + self.reflectance * irradiance
    }

    /// `E`, W/m².
    pub(super) fn emission(&self) -> Rgb {
        self.emission
    }

    /// Is it a leaf?
    pub fn is_leaf(&self) -> bool {
        self.children.is_empty()
    }

    /// Would its pieces be no smaller than `smallest`?
    pub(super) fn is_divisible(&self, smallest: f64) -> bool {
        let parts = if long(&self.polygon).is_some() { 2.0 } else { 4.0 };
        self.polygon.area() >= parts * smallest
    }
}

/// A quadrilateral whose edges differ by more than this is cut across, not in four.
const LONG: f64 = 1.6;

/// The corner with which the longer pair of edges of a long quadrilateral begins.
fn long(polygon: &Polygon) -> Option<usize> {
    let &[a, b, c, d] = polygon.vertices() else { return None };
    let along = a.distance(b) + c.distance(d);
    let across = b.distance(c) + d.distance(a);
    match along / across {
        ratio if ratio > LONG => Some(0),
        ratio if ratio < 1.0 / LONG => Some(1),
        _ => None,
    }
}

/// The pieces of a node: two of a long quadrilateral, else [`Polygon::quarters`].
fn pieces(polygon: &Polygon) -> Vec<Polygon> {
    let Some(first) = long(polygon) else { return polygon.quarters() };
    let v = |k: usize| polygon.vertices()[(first + k) % 4];
    let (low, high) = (v(0).midpoint(v(1)), v(2).midpoint(v(3)));
    let halves = [vec![v(0), low, high, v(3)], vec![low, v(1), v(2), high]];
    let normal = polygon.normal();
    halves.into_iter().filter_map(|half| Polygon::piece(half, normal)).collect()
}

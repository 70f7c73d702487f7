//! Hierarchical radiosity: links between nodes of any size, as coarse as will do.
//!
//! ```text
//! H_p = Σ F_pq B_q          over the links of p: what arrives at the node, W/m²
//! H_i = Σ H_p               over the nodes p above the element i, itself included: push
//! B_p = Σ A_c B_c / Σ A_c   over the children c of p: pull
//! ```
//! As bodies far away act as one in the problem of n bodies, elements far away shine as
//! one. A factor is kept as its mean over the receiver and its slope along it; the slope is
//! pushed down with the mean. A link that may be wrong by too much gives way to links to
//! the parts of its receiver, or from the parts of its source:
//!
//! ```text
//! ρ_p B_q bend ≤ 0.03 ε ‖B − E‖                bend: how far F is from mean and slope
//! ρ_p ΔB_q (A_q/A_p) ΔF ≤ 0.03 ε ‖B − E‖       ΔB, ΔF over the source q
//! √(A_i/A) ρ_i ΔH_i ≤ ε² ‖B − E‖               ΔH over the element i, or it is divided
//! ```
//! with `‖·‖` the root mean square over all area `A`, and `Δ` standard deviations. The
//! second bounds what an uneven source does (Cauchy & Schwarz). The third is an element's
//! part in the squared error: `1/ε²` elements together err by `ε`. By the same weight a
//! bent link is let pass on small receivers: at 0.2 of an element's part. Else links would
//! be divided for ever where surfaces touch.
//!
//! | method              | use it when                           | it fails when            |
//! |---------------------|---------------------------------------|--------------------------|
//! | [`solve_hierarchy`] | elements are many, surfaces few       | surfaces are many: k² links first |
//! | [`Hierarchy`]       | it is to be watched at work           | as above                 |
//!
//! **Not here:** clusters of surfaces, importance. Chapter *Links* (beyond L12).
//! Sources: Hanrahan, Salzman & Aupperle 1991; Lischinski, Smits & Greenberg 1994 (bounds).

mod link;
mod lost;
mod options;
mod tree;

pub use link::Link;
pub use options::HierarchyOptions;
pub use tree::{Forest, Node, NodeId};

use super::{Enclosure, Ledger, error_bound};
use crate::form_factor::Obstruction;
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::occlusion::Blockers;
use crate::scene::Scene;
use crate::work::Progress;
use glam::DMat3;
use link::{Allowed, LinkVerdict, reflecting};
use rayon::prelude::*;

/// The light of a scene, found over links.
#[derive(Clone, Debug)]
pub struct Hierarchical {
    /// The elements: the leaves.
    pub mesh: Mesh,
    /// `B`, W/m², per element.
    pub radiosity: Vec<Rgb>,
    /// `H`, W/m², per element, on the front.
    pub irradiance: Vec<Rgb>,
    /// `H`, W/m², per vertex of the mesh: the mean of what the elements there come to.
    pub vertex_irradiance: Vec<Rgb>,
    /// `B`, W/m², there.
    pub vertex_radiosity: Vec<Rgb>,
    /// Where the light went.
    pub ledger: Ledger,
    /// `‖r‖/‖B − E‖` of the discrete system.
    pub solver_residual: f64,
    /// How many sweeps.
    pub steps: usize,
    /// How many links.
    pub links: usize,
    /// How many nodes.
    pub nodes: usize,
}

/// Solves a scene by links: refines and solves in turn, each time for a smaller error.
///
/// Deterministic: the same at any number of threads.
pub fn solve_hierarchy(
    scene: &Scene,
    options: &HierarchyOptions,
    progress: Progress,
) -> Hierarchical {
    let mut hierarchy = Hierarchy::new(scene, *options);
    hierarchy.solve(SOLVER_SHARE);
    let mut error: f64 = COARSEST;
    let mut at_last = 0;
    while at_last < ROUNDS {
        error = (0.5 * error).max(options.error);
        let divided = hierarchy.refine(error);
        progress("links", hierarchy.links(), hierarchy.links());
        hierarchy.solve(SOLVER_SHARE * error);
        if error == options.error {
            at_last = if divided == 0 { ROUNDS } else { at_last + 1 };
        }
    }
    hierarchy.finish(scene)
}

/// The solver's own error may be this share of what is asked for.
const SOLVER_SHARE: f64 = 0.1;

/// The first links are refined for half of this error, and so on.
const COARSEST: f64 = 0.4;

/// Links are refined at most this often for the error asked for.
const ROUNDS: usize = 3;

/// Sweeps at the most.
const MOST_SWEEPS: usize = 20_000;

/// Trees, links, and the light on them.
#[derive(Debug)]
pub struct Hierarchy {
    forest: Forest,
    blockers: Blockers,
    options: HierarchyOptions,
    steps: usize,
    residual: f64,
}

impl Hierarchy {
    /// Links every surface with every other that it sees: a number of links that grows
    /// with the square of the surfaces.
    pub fn new(scene: &Scene, options: HierarchyOptions) -> Hierarchy {
        let forest = Forest::of(scene);
        let blockers = Blockers::of(scene);
        let roots = forest.roots as u32;
        let mut hierarchy =
            Hierarchy { forest, blockers, options, steps: 0, residual: 0.0 };
        let pairs = |p: u32| {
            (0..roots).map(move |q| (NodeId(p), NodeId(q), Obstruction::Partial))
        };
        for p in 0..roots {
            let links = hierarchy.linked(pairs(p).collect());
            hierarchy.forest.nodes[p as usize].links =
                links.into_iter().map(|(_, link)| link).collect();
        }
        hierarchy
    }

    /// The trees.
    pub fn forest(&self) -> &Forest {
        &self.forest
    }

    /// How many links there are.
    pub fn links(&self) -> usize {
        self.forest.nodes.iter().map(|node| node.links.len()).sum()
    }

    /// How many elements there are.
    pub fn elements(&self) -> usize {
        self.forest.leaves
    }

    /// Links for these receivers and sources, where they see each other, in order.
    fn linked(&self, pairs: Vec<(NodeId, NodeId, Obstruction)>) -> Vec<(NodeId, Link)> {
        let link = |(p, q, sight): (NodeId, NodeId, Obstruction)| {
            let (receiver, source) = (self.forest.node(p), self.forest.node(q));
            let link = Link::between(receiver, (q, source), &self.blockers, sight)?;
            Some((p, link))
        };
        pairs.into_par_iter().filter_map(link).collect()
    }

    /// Divides until no link may be wrong by more than the relative `error` allows, and
    /// then elements over which light varies too much; says how many links were replaced.
    pub fn refine(&mut self, error: f64) -> usize {
        let allowed = self.allowed(error);
        let mut work = self.take_links();
        let mut replaced = 0;
        while !work.is_empty() {
            let judge = |(p, link): &mut (NodeId, Link)| {
                allowed.judge(&self.forest, &self.blockers, *p, link)
            };
            let verdicts: Vec<LinkVerdict> = work.par_iter_mut().map(judge).collect();
            let ask = |((p, _), verdict): (&(NodeId, Link), &LinkVerdict)| match verdict
            {
                LinkVerdict::DivideReceiver(error) => Some((*error, *p)),
                _ => None,
            };
            let asks = work.iter().zip(&verdicts).filter_map(ask).collect();
            self.divide(asks, allowed.smallest);
            let mut pairs = Vec::new();
            for ((p, link), verdict) in work.into_iter().zip(verdicts) {
                let before = pairs.len();
                self.replace(p, &link, verdict, &mut pairs);
                if pairs.len() == before {
                    self.forest.nodes[p.index()].links.push(link);
                } else {
                    replaced += 1;
                }
            }
            work = self.linked(pairs);
        }
        replaced + self.refine_elements(&allowed)
    }

    /// Divides elements over which light varies too much; says how many.
    fn refine_elements(&mut self, allowed: &Allowed) -> usize {
        self.gather();
        let before = self.forest.nodes.len();
        let mut new = 0..before as u32;
        while !new.is_empty() {
            let varies = |id: NodeId| (allowed.varies(&self.forest, id), id);
            let asks = new.clone().into_par_iter().map(NodeId).map(varies);
            let asks = asks.filter(|(error, _)| *error > 1.0).collect();
            new.start = self.forest.nodes.len() as u32;
            self.divide(asks, allowed.smallest);
            new.end = self.forest.nodes.len() as u32;
        }
        self.forest.nodes.len() - before
    }

    /// The pairs that stand in for a link; none when it stays.
    fn replace(
        &self,
        p: NodeId,
        link: &Link,
        verdict: LinkVerdict,
        pairs: &mut Vec<(NodeId, NodeId, Obstruction)>,
    ) {
        let (q, sight) = (link.source, link.sight);
        let children = |id: NodeId| self.forest.node(id).children.clone().map(NodeId);
        match verdict {
            LinkVerdict::Keep => {}
            LinkVerdict::DivideSource => {
                pairs.extend(children(q).map(|c| (p, c, sight)))
            }
            LinkVerdict::DivideReceiver(_) => {
                pairs.extend(children(p).map(|c| (c, q, sight)))
            }
        }
    }

    fn take_links(&mut self) -> Vec<(NodeId, Link)> {
        let nodes = (0u32..).zip(&mut self.forest.nodes);
        let links = nodes.flat_map(|(k, node)| {
            let links = std::mem::take(&mut node.links);
            links.into_iter().map(move |link| (NodeId(k), link))
        });
        links.collect()
    }

    /// Divides leaves, those with the largest error first while there may be more.
    fn divide(&mut self, mut asks: Vec<(f64, NodeId)>, smallest: f64) {
        asks.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        for (_, p) in asks {
            if self.forest.leaves < self.options.most_elements {
                self.forest.divide(p, smallest);
            }
        }
    }

    fn allowed(&self, error: f64) -> Allowed {
        let (mut squares, mut area) = (Rgb::ZERO, 0.0);
        for node in self.leaves() {
            let light = reflecting(node.1) * self.forest.irradiance(node.0);
            squares += node.1.polygon.area() * light * light;
            area += node.1.polygon.area();
        }
        let inverse = |s: f64| if s > 0.0 { (area / s).sqrt() } else { 0.0 };
        let scale = Rgb::from_array(squares.to_array().map(inverse));
        Allowed { scale, area, error, smallest: self.options.smallest }
    }

    fn leaves(&self) -> impl Iterator<Item = (NodeId, &Node)> {
        let nodes = (0u32..).map(NodeId).zip(&self.forest.nodes);
        nodes.filter(|(_, node)| node.is_leaf())
    }

    /// What arrives over all links, from the radiosities as they are.
    fn gather(&mut self) {
        let Forest { nodes, light, .. } = &mut self.forest;
        // ANCHOR: gather_link
        let arrives = |node: &Node| {
            let mut sum = (Rgb::ZERO, DMat3::ZERO);
            for link in &node.links {
                let (mean, slope) = link.arriving(light.radiosity[link.source.index()]);
                sum = (sum.0 + mean, sum.1 + slope);
            }
            sum
        };
        // ANCHOR_END: gather_link
        (light.irradiance, light.slope) = nodes.par_iter().map(arrives).unzip();
        self.forest.push();
    }

    /// Sweeps until the solver's own relative error is below `accuracy`, as far as rows
    /// sum to one: what they do not is an error of links, not of the solver.
    pub fn solve(&mut self, accuracy: f64) {
        let brightest = |m: f64, n: &Node| m.max(n.reflectance.max_element());
        let contraction = self.forest.nodes.iter().fold(0.0, brightest);
        for _ in 0..MOST_SWEEPS {
            self.gather();
            self.residual = self.relative_residual();
            if error_bound(self.residual, contraction) <= accuracy {
                return;
            }
            self.steps += 1;
            self.forest.pull();
        }
    }

    /// `‖E + ρ H − B‖ / ‖B − E‖`, worst channel.
    fn relative_residual(&self) -> f64 {
        let (mut residual, mut reflected) = (Rgb::ZERO, Rgb::ZERO);
        for (id, node) in self.leaves() {
            let b = self.forest.radiosity(id);
            let r = node.reflected(self.forest.irradiance(id)) - b;
            residual += node.polygon.area() * r * r;
            reflected += node.polygon.area() * (b - node.emission()).powf(2.0);
        }
        let ratio = |k: usize| match residual[k] {
            0.0 => 0.0,
            r => (r / reflected[k]).sqrt(),
        };
        (0..3).map(ratio).fold(0.0, f64::max)
    }

    /// The mesh of the leaves, and the light on it.
    pub fn finish(&self, scene: &Scene) -> Hierarchical {
        let forest = &self.forest;
        let trees: Vec<Vec<NodeId>> =
            (0..forest.roots as u32).map(|r| forest.leaves_of(NodeId(r))).collect();
        let patch = |(root, leaves): (&Node, &Vec<NodeId>)| {
            let outline = |&id: &NodeId| forest.node(id).polygon.clone();
            (root.surface, leaves.iter().map(outline).collect())
        };
        let mesh = Mesh::of_pieces(scene, forest.nodes.iter().zip(&trees).map(patch));
        let leaves = || trees.iter().flatten();
        let radiosity: Vec<Rgb> = leaves().map(|&id| forest.radiosity(id)).collect();
        let irradiance: Vec<Rgb> = leaves().map(|&id| forest.irradiance(id)).collect();
        let enclosure = Enclosure::of(scene, &mesh);
        let left = |(&id, &b): (&NodeId, &Rgb)| {
            forest.node(id).reflected(forest.irradiance(id)) - b
        };
        let residual: Vec<Rgb> = leaves().zip(&radiosity).map(left).collect();
        let lost = lost::by_rays(scene, &mesh, &radiosity, self.options.seed);
        let ids: Vec<NodeId> = leaves().copied().collect();
        let of_node = |node: &Node, h: Rgb| node.reflected(h);
        let vertex_radiosity = self.at_vertices(&mesh, &ids, of_node);
        let vertex_irradiance = self.at_vertices(&mesh, &ids, |_, h| h);
        Hierarchical {
            ledger: Ledger::draw_up(&enclosure, &irradiance, &residual, lost),
            mesh,
            radiosity,
            irradiance,
            vertex_irradiance,
            vertex_radiosity,
            solver_residual: self.residual,
            steps: self.steps,
            links: self.links(),
            nodes: forest.nodes.len(),
        }
    }

    /// At the corners of elements light is what their slopes make of it, and never less
    /// than nothing is reflected.
    fn at_vertices(
        &self,
        mesh: &Mesh,
        leaves: &[NodeId],
        value: impl Fn(&Node, Rgb) -> Rgb,
    ) -> Vec<Rgb> {
        let mut sums = vec![(Rgb::ZERO, 0.0); mesh.vertices.len()];
        for (element, &id) in mesh.elements.iter().zip(leaves) {
            let (node, area) = (self.forest.node(id), element.polygon.area());
            for &corner in &element.corners {
                let step = mesh.vertices[corner] - node.centre;
                let arrives = self.forest.irradiance(id) + self.forest.slope(id) * step;
                let (sum, weight) = &mut sums[corner];
                *sum += area * value(node, arrives.max(Rgb::ZERO));
                *weight += area;
            }
        }
        let mut values: Vec<Rgb> = sums.into_iter().map(|(s, w)| s / w).collect();
        mesh.anchor(&mut values);
        values
    }
}

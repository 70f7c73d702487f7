//! Two walls that share an edge, and every link between them.

use radiosity::geometry::{Polygon, Rgb};
use radiosity::glam::{DVec3, dvec3};
use radiosity::material::{Coefficients, Material};
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solve::hierarchy::{Hierarchy, HierarchyOptions, Node};
use std::fmt::Write;

/// The error asked for.
const ERROR: f64 = 0.3;

/// Mid-tones, one for each level of the receiver.
const COLOURS: [&str; 6] =
    ["#d55e00", "#3b8fd0", "#00a078", "#b765a0", "#a08a00", "#808080"];

/// The wall emits 1 W/m², the floor is grey.
fn scene() -> Option<Scene> {
    let material = |name: &str, emission: f64| {
        let (emission, diffuse) = (Rgb::splat(emission), Rgb::splat(0.5));
        let all = Coefficients { emission, diffuse, ..Default::default() };
        Material::new(name, all).ok()
    };
    let square = |a: DVec3, b: DVec3| vec![DVec3::ZERO, a, a + b, b];
    let face = |outline, k| Face { outline, material: MaterialId(k) };
    let faces =
        vec![face(square(DVec3::X, DVec3::Y), 0), face(square(DVec3::Y, DVec3::Z), 1)];
    let materials = vec![material("floor", 0.0)?, material("wall", 1.0)?];
    Scene::assemble("walls", materials, faces, None).ok().map(|(scene, _)| scene)
}

fn refined() -> Hierarchy {
    let scene = scene().expect("two squares make a scene");
    let options = HierarchyOptions::aiming_at(ERROR, &scene);
    let mut hierarchy = Hierarchy::new(&scene, options);
    for error in [4.0 * ERROR, 2.0 * ERROR, ERROR] {
        hierarchy.solve(0.01);
        hierarchy.refine(error);
    }
    hierarchy
}

/// Where a point is drawn, in pixels: the floor to the right, the wall upward.
fn place(p: DVec3) -> (f64, f64) {
    let p = p - dvec3(0.0, 0.5, 0.0);
    (150.0 + 250.0 * p.x + 110.0 * p.y, 300.0 - 230.0 * p.z + 90.0 * p.x - 110.0 * p.y)
}

fn outline(text: &mut String, polygon: &Polygon) {
    let points: Vec<String> = polygon
        .vertices()
        .iter()
        .map(|&v| format!("{:.1},{:.1}", place(v).0, place(v).1))
        .collect();
    let _ = writeln!(
        text,
        "<polygon points=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.7\" \
         opacity=\"0.6\"/>",
        points.join(" ")
    );
}

/// The drawing.
pub fn svg() -> String {
    let hierarchy = refined();
    let forest = hierarchy.forest();
    let mut text = String::from(
        "<svg viewBox=\"0 0 480 480\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <title>A wall over a floor, both cut into squares that are smaller near the edge \
         they share; lines join the centres of linked squares</title>\n",
    );
    for id in forest.leaves() {
        outline(&mut text, &forest.node(id).polygon);
    }
    let mut links: Vec<(&Node, &Node)> = Vec::new();
    for node in &forest.nodes {
        links.extend(node.links.iter().map(|link| (node, forest.node(link.source))));
    }
    for (to, from) in links {
        let ((x, y), (u, v)) = (place(to.centre), place(from.centre));
        let colour = COLOURS[to.level as usize % COLOURS.len()];
        let _ = writeln!(
            text,
            "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{u:.1}\" y2=\"{v:.1}\" \
             stroke=\"{colour}\" stroke-width=\"0.9\"/><circle cx=\"{x:.1}\" cy=\"{y:.1}\" \
             r=\"2.2\" fill=\"{colour}\"/>"
        );
    }
    for (k, colour) in COLOURS.iter().enumerate().take(deepest() + 1) {
        let y = 40 + 20 * k;
        let _ = writeln!(
            text,
            "<text x=\"340\" y=\"{y}\" font-size=\"13\" fill=\"{colour}\">receiver at level \
             {k}</text>"
        );
    }
    text += "</svg>\n";
    text
}

/// The deepest level that is linked.
fn deepest() -> usize {
    let hierarchy = refined();
    let linked = hierarchy.forest().nodes.iter().filter(|node| !node.links.is_empty());
    linked.map(|node| node.level as usize).max().unwrap_or(0)
}

/// What is counted.
pub fn caption() -> String {
    let hierarchy = refined();
    let n = hierarchy.elements();
    format!(
        "{n} elements, {} links; each dot is a receiver. A matrix would have up to {} \
         factors.",
        hierarchy.links(),
        n * n / 2
    )
}

//! Where the light goes: of a painted surface, by direction; of a furnace, solved.

use super::ball;
use crate::ledger;
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::material::Lobe;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::Goal;
use radiosity::solution::{Solution, solve_on};
use radiosity::work::Work;
use std::fmt::Write;

/// Of 1 W of red light that falls on the paint at an angle.
pub fn of_the_ball() -> String {
    let mut text = String::from(
        "| of 1 W of red light, at | 0° | 45° | 80° |\n|---|---|---|---|\n",
    );
    let cosines = [0.0_f64, 45.0, 80.0].map(|degrees| degrees.to_radians().cos());
    let paint = ball::brdf(ball::EXPONENTS[1]);
    // What is left when there is no gloss is the diffuse part: its albedo is constant.
    let gloss = Lobe::Phong { exponent: ball::EXPONENTS[1] };
    let share = (paint.albedo(1.0).x - paint.albedo(cosines[2]).x)
        / (gloss.albedo(1.0) - gloss.albedo(cosines[2]));
    let mut line = |name: &str, of: &dyn Fn(f64) -> f64| {
        let [a, b, c] = cosines.map(of);
        let _ = writeln!(text, "| {name} | {a:.4} | {b:.4} | {c:.4} |");
    };
    line("arrives", &|_| 1.0);
    line("leaves diffusely", &|c| paint.albedo(c).x - share * gloss.albedo(c));
    line("leaves in the gloss", &|c| share * gloss.albedo(c));
    line("absorbed", &|c| 1.0 - paint.albedo(c).x);
    text
}

fn solved(scene: &Scene) -> Solution {
    let method = Classical::by(Factors::Analytic);
    solve_on(
        &Room::of(scene),
        &method,
        Mesh::uniform(scene, 0.5),
        &Goal::default(),
        &Work::quiet(),
    )
    .unwrap()
}

fn furnace(reflectance: f64) -> Scene {
    built_in(&format!("furnace:{reflectance}")).expect("`furnace` is built in")
}

/// How much light there is in a closed room, and how often it is reflected.
pub fn bounces() -> String {
    let mut text = String::from(
        "| reflectance | 1/(1 − ρ) | radiosity for E = 1, solved | left after 10 reflections |\n\
         |---|---|---|---|\n",
    );
    for reflectance in [0.5, 0.8, 0.9, 0.99] {
        let radiosity = solved(&furnace(reflectance)).radiosity[0].x;
        let (exact, left) =
            (1.0 / (1.0 - reflectance), 100.0 * f64::powi(reflectance, 10));
        let _ = writeln!(
            text,
            "| {reflectance} | {exact:.0} | {radiosity:.2} | {left:.1} % |"
        );
    }
    text
}

/// The ledger of the furnace with reflectance ½.
pub fn of_the_furnace() -> String {
    ledger::table(&solved(&furnace(0.5)))
}

//! Form factors: one pair by every method - far, near, touching, half hidden - and rows of
//! a room.

use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::form_factor::analytic::{Analytic, exchange, lambert_polygon};
use crate::form_factor::cast::Cast;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::named::{parallel_rectangles, perpendicular_rectangles};
use crate::form_factor::shortcuts::{point_to_disc, point_to_point};
use crate::form_factor::{FormFactors, area};
use crate::geometry::Polygon;
use crate::material::{Coefficients, Material};
use crate::mesh::{ElementId, Mesh};
use crate::scene::{Face, MaterialId, Scene, built_in};
use crate::visibility::Visibility;
use glam::{DVec3, dvec3};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "form-factors",
    about: "one factor, and rows of a room, by all methods",
    measure,
    views: &[
        view("form-factors-far", |t| t.scene == FAR),
        view("form-factors-near", |t| t.scene == NEAR),
        view("form-factors-touching", |t| t.scene == TOUCHING && t.method != DISC),
        view("form-factors-hidden", |t| t.scene == HIDDEN && t.method != DISC),
        ChartView {
            title: "Largest error of a factor against the time for sixteen rows of them",
            across: (Column::Seconds, "CPU seconds for sixteen rows"),
            upward: (Column::Error, "largest error of a factor"),
            least: 1e-7,
            ..view("form-factors-rows", |t| t.scene == ROWS)
        },
    ],
};

const fn view(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "Relative error of a form factor against the time to find it",
        across: (Column::Seconds, "CPU seconds for a factor"),
        upward: (Column::Error, "relative error"),
        least: 1e-10,
        shows,
    }
}

/// Scenes of the suite.
pub const FAR: &str = "squares 5 sides apart";
/// See [`FAR`].
pub const NEAR: &str = "squares a quarter of a side apart";
/// See [`FAR`].
pub const TOUCHING: &str = "squares that share an edge";
/// See [`FAR`].
pub const HIDDEN: &str = "squares behind a screen";
/// See [`FAR`].
pub const ROWS: &str = "rows of the Cornell box";

const DISC: &str = "point to disc";

/// A rectangle from a corner and two edges; its front is where `a × b` points.
#[derive(Clone, Copy, Debug)]
struct Rectangle(DVec3, DVec3, DVec3);

impl Rectangle {
    fn polygon(self) -> Polygon {
        let Rectangle(o, a, b) = self;
        Polygon::new(vec![o, o + a, o + a + b, o + b]).expect("rectangles are polygons")
    }

    /// Cut into `k × k` pieces.
    fn pieces(self, k: u64) -> Vec<Polygon> {
        let Rectangle(o, a, b) = self;
        let [a, b] = [a, b].map(|edge| edge / k as f64);
        let piece = |n| Rectangle(o + (n % k) as f64 * a + (n / k) as f64 * b, a, b);
        (0..k * k).map(|n| piece(n).polygon()).collect()
    }
}

/// Two squares, what stands between them, and the factor from the first to the second.
#[derive(Debug)]
pub struct Pair {
    from: Rectangle,
    to: Rectangle,
    scene: Scene,
    mesh: Mesh,
    exact: f64,
}

impl Pair {
    /// One of [`FAR`], [`NEAR`], [`TOUCHING`], [`HIDDEN`].
    pub fn named(name: &str) -> Option<Pair> {
        let facing = |d| Rectangle(dvec3(0.0, 0.0, d), DVec3::Y, DVec3::X);
        let (to, screen, exact) = match name {
            FAR => (facing(5.0), None, parallel_rectangles(1.0, 1.0, 5.0)),
            NEAR => (facing(0.25), None, parallel_rectangles(1.0, 1.0, 0.25)),
            TOUCHING => (
                Rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z),
                None,
                perpendicular_rectangles(1.0, 1.0, 1.0),
            ),
            // Halfway between them, over three quarters: an eighth of the pairs of points
            // see each other, and their factor is known to 15 digits.
            HIDDEN => (
                facing(1.0),
                Some(Rectangle(dvec3(0.0, 0.0, 0.5), 0.75 * DVec3::X, DVec3::Y)),
                0.029_163_422_950_906,
            ),
            _ => return None,
        };
        let from = Rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
        let all = [Some(from), Some(to), screen];
        let polygons: Vec<Polygon> =
            all.iter().flatten().map(|r| r.polygon()).collect();
        let scene = black(&polygons);
        let mesh = Mesh::whole(&scene);
        Some(Pair { from, to, scene, mesh, exact })
    }

    /// The first square.
    pub fn from(&self) -> Polygon {
        self.from.polygon()
    }

    /// The second.
    pub fn to(&self) -> Polygon {
        self.to.polygon()
    }

    /// Both and the screen, black.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The factor.
    pub fn exact(&self) -> f64 {
        self.exact
    }

    /// The sum over all pairs of `k × k` pieces of each.
    fn pieces(&self, k: u64, rule: impl Fn(&Polygon, &Polygon) -> f64) -> f64 {
        let to = self.to.pieces(k);
        let of = |i: &Polygon| i.area() * to.iter().map(|j| rule(i, j)).sum::<f64>();
        self.from.pieces(k).iter().map(of).sum()
    }

    /// The second entry of the first row.
    fn by(&self, factors: &dyn FormFactors) -> f64 {
        let mut row = vec![0.0; factors.len()];
        factors.row(ElementId(0), &mut row);
        row[1]
    }

    // ANCHOR: contest
    /// All methods on this pair, ready to run. `name` is that of the pair.
    pub fn contest(&self, name: &str) -> Contest<'_, f64> {
        let off = |f: &f64| Verdict::of((f / self.exact - 1.0).abs());
        Contest::new(name, 0.0, off)
            .with(self.analytic(name == HIDDEN))
            .with(self.middles())
            .with(self.shortcut("point to point", point_to_point))
            .with(self.shortcut(DISC, point_to_disc))
            .with(self.random_pairs())
            .with(self.rays())
            .with(self.hemicube())
            .with(self.hemicubes())
    }
    // ANCHOR_END: contest

    fn analytic(&self, hidden: bool) -> Method<'_, f64> {
        let tolerances = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
        let ready = tolerances.map(|t| {
            (t, Analytic::new(&self.scene, &self.mesh, t, 0).without_losses())
        });
        let (i, j) = (self.from(), self.to());
        Method::new("Lambert's formula", &tolerances, move |tolerance, _| {
            let past = || ready.iter().find(|(t, _)| *t == tolerance);
            let f = match past().filter(|_| hidden) {
                Some((_, scene)) => scene.exchange(ElementId(0), ElementId(1)),
                None => exchange(&i, &j, tolerance),
            };
            (f, WorkDone { factors: 1, ..WorkDone::default() })
        })
    }

    fn middles(&self) -> Method<'_, f64> {
        Method::new("Lambert at the middles", &[1.0, 2.0, 4.0, 8.0, 16.0], |k, _| {
            let (to, pieces) = (self.to(), self.from.pieces(k as u64));
            let of =
                |i: &Polygon| i.area() * lambert_polygon(i.centroid(), i.normal(), &to);
            let work = WorkDone { factors: pieces.len() as u64, ..WorkDone::default() };
            (pieces.iter().map(of).sum(), work)
        })
    }

    fn shortcut(
        &self,
        name: &str,
        rule: fn(&Polygon, &Polygon) -> f64,
    ) -> Method<'_, f64> {
        Method::new(name, &[1.0, 2.0, 4.0, 8.0, 16.0, 32.0], move |k, _| {
            let work = WorkDone { factors: (k as u64).pow(4), ..WorkDone::default() };
            (self.pieces(k as u64, rule), work)
        })
    }

    fn random_pairs(&self) -> Method<'_, f64> {
        let visibility = Visibility::new(self.mesh.polygons());
        let (i, j) = (self.from(), self.to());
        Method::random("random pairs", &RAYS, move |n, seed| {
            let found = area::sampled(&i, &j, &visibility, n as usize, seed);
            (found.exchange, WorkDone { rays: n as u64, ..WorkDone::default() })
        })
    }

    fn rays(&self) -> Method<'_, f64> {
        Method::random("rays", &RAYS, |n, seed| {
            let f = self.by(&Cast::new(&self.mesh, n as usize, seed));
            (f, WorkDone { rays: n as u64, ..WorkDone::default() })
        })
    }

    fn hemicube(&self) -> Method<'_, f64> {
        Method::new("one hemicube", &[16.0, 64.0, 256.0, 1024.0], |n, _| {
            (self.by(&Hemicube::new(&self.mesh, n as u32)), cells(n, 1))
        })
    }

    /// Of 256² cells, from the middles of `k × k` pieces.
    fn hemicubes(&self) -> Method<'_, f64> {
        Method::new("k × k hemicubes", &[1.0, 2.0, 4.0, 8.0], |k, _| {
            let cube = Hemicube::new(&self.mesh, 256);
            let pieces = self.from.pieces(k as u64);
            let from = |i: &Polygon| {
                let mut row = vec![0.0; self.mesh.elements.len()];
                cube.at(i.centroid(), i.normal(), &mut row);
                i.area() * row[1]
            };
            (pieces.iter().map(from).sum(), cells(256.0, pieces.len() as u64))
        })
    }
}

const RAYS: [f64; 4] = [100.0, 1_000.0, 10_000.0, 100_000.0];

/// A hemicube of `n × n` cells on top has as many again on two pairs of half sides.
fn cells(n: f64, cubes: u64) -> WorkDone {
    let pixels = 3 * (n as u64).pow(2) * cubes;
    WorkDone { pixels, factors: cubes, ..WorkDone::default() }
}

/// A scene of black faces.
fn black(polygons: &[Polygon]) -> Scene {
    let material = Material::new("black", Coefficients::default());
    let face =
        |p: &Polygon| Face { outline: p.vertices().to_vec(), material: MaterialId(0) };
    let faces = polygons.iter().map(face).collect();
    let materials = vec![material.expect("black is passive")];
    Scene::assemble("pair", materials, faces, None).expect("the pair is fit").0
}

fn measure(bench: &Bench) -> Vec<Trial> {
    let mut trials = vec![];
    for name in [FAR, NEAR, TOUCHING, HIDDEN] {
        let pair = Pair::named(name).expect("it has a name");
        trials.extend(pair.contest(name).run(SUITE.name, bench));
    }
    trials.extend(rows(bench));
    trials
}

/// Accuracy of the rows that all others are held against.
const REFERENCE: f64 = 1e-8;

/// Rows that are measured, spread evenly over the elements.
pub const MEASURED: usize = 16;

fn rows(bench: &Bench) -> Vec<Trial> {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, 0.1);
    let n = mesh.elements.len();
    let element = |k: usize| k * n / MEASURED;
    let rows = |factors: &dyn FormFactors| -> Vec<Vec<f64>> {
        let row = |k| {
            let mut row = vec![0.0; n];
            factors.row(ElementId(element(k) as u32), &mut row);
            row
        };
        (0..MEASURED).map(row).collect()
    };
    let exact = rows(&Analytic::new(&scene, &mesh, REFERENCE, 0));
    let worst = |got: &Vec<Vec<f64>>, counts: fn(&Polygon, &Polygon) -> bool| {
        let mut worst = 0.0_f64;
        for (k, (got, exact)) in got.iter().zip(&exact).enumerate() {
            let from = &mesh.elements[element(k)].polygon;
            for (to, (f, e)) in mesh.polygons().zip(got.iter().zip(exact)) {
                if counts(from, to) {
                    worst = worst.max((f - e).abs());
                }
            }
        }
        Verdict::of(worst)
    };
    let work = |rays: u64, pixels: u64| {
        let [factors, rays, pixels] =
            [n as u64, rays, pixels].map(|w| w * MEASURED as u64);
        WorkDone { factors, rays, pixels, ..WorkDone::default() }
    };
    let cube = |name: &str| {
        let settings = [16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0];
        Method::new(name, &settings, |r, _| {
            let pixels = cells(r, 1).pixels;
            (rows(&Hemicube::new(&mesh, r as u32)), work(0, pixels))
        })
    };
    let contest = |judge| {
        Contest::new(ROWS, REFERENCE, move |got: &Vec<Vec<f64>>| worst(got, judge))
    };
    let all = contest(|_, _| true)
        .with(cube("hemicube"))
        .with(Method::random("rays", &RAYS, |r, seed| {
            (rows(&Cast::new(&mesh, r as usize, seed)), work(r as u64, 0))
        }))
        .with(Method::new("Lambert's formula", &[1e-2, 1e-3, 1e-4, 1e-5], |t, _| {
            (rows(&Analytic::new(&scene, &mesh, t, 1)), work(0, 0))
        }));
    let far_only = contest(far).with(cube("hemicube: far pairs"));
    [all.run(SUITE.name, bench), far_only.run(SUITE.name, bench)].concat()
}

/// The five-times rule: farther apart than five times the larger one's diameter.
fn far(a: &Polygon, b: &Polygon) -> bool {
    let size = a.diameter().max(b.diameter());
    a.centroid().distance(b.centroid()) > 5.0 * size
}

//! `radiosity explain`: what will be done to a scene, and why.

use super::output::{Refusal, Terminal};
use super::report::percent;
use super::sky::Lit;
use super::solve::{checked, sized};
use super::values;
use clap::Args;
use radiosity::plan::{Plan, Predicted};
use radiosity::room::Room;
use radiosity::solution::Goal;
use radiosity::work::Work;
use serde_json::{Value, json};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Tells what a scene needs to be right to a tolerance, and why
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity explain cornell
  radiosity explain room.obj --tolerance 5%
  radiosity explain cornell --run --json

Work is predicted from the scene and decides nothing; --run does it, and tells what was
spent. Seconds predicted are those of one processor.")]
pub struct Explain {
    #[command(flatten)]
    source: Lit,
    /// The largest relative error of the field asked for, as 0.01 or 1%
    #[arg(long, default_value = "1%", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    tolerance: f64,
    /// Do it, and tell what was spent
    #[arg(long)]
    run: bool,
}

/// Seconds by what was done, in order.
struct Watch {
    start: Instant,
    stages: Vec<(&'static str, f64)>,
    last: Option<(&'static str, Instant)>,
}

impl Watch {
    fn start() -> Watch {
        Watch { start: Instant::now(), stages: Vec::new(), last: None }
    }

    /// `stage` goes on, or begins and ends the one before.
    fn during(&mut self, stage: &'static str) {
        if self.last.is_some_and(|(last, _)| last == stage) {
            return;
        }
        self.stop();
        self.last = Some((stage, Instant::now()));
    }

    fn stop(&mut self) {
        let Some((stage, since)) = self.last.take() else { return };
        let spent = since.elapsed().as_secs_f64();
        match self.stages.iter_mut().find(|(known, _)| *known == stage) {
            Some((_, sum)) => *sum += spent,
            None => self.stages.push((stage, spent)),
        }
    }
}

impl Explain {
    /// Explains, and runs if asked to.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let tolerance = values::positive("--tolerance", self.tolerance)?;
        let scene = self.source.load(terminal)?;
        if self.run { checked(&scene) } else { sized(&scene) }?;
        let room = Room::of(&scene);
        let plan = Plan::of(&room, tolerance);
        let mut text = format!(
            "What {} needs to be right to {}:\n\n",
            scene.name,
            percent(tolerance).replace(".0 ", " ")
        );
        for decision in &plan.decisions {
            text += &decision.to_string();
        }
        let mut object = json!({
            "scene": scene.name,
            "tolerance": tolerance,
            "decisions": plan.decisions.iter().map(|d| json!({
                "what": d.what, "why": d.why, "value": d.value,
            })).collect::<Vec<Value>>(),
            "predicted": predicted(&plan.predicted),
        });
        if self.run {
            let (told, spent) = self.spent(&room, &plan, seed, terminal)?;
            text += &told;
            object["spent"] = spent;
        }
        terminal.report(&text, || object)
    }

    /// Runs the plan: what it cost, in words and as JSON.
    fn spent(
        &self,
        room: &Room,
        plan: &Plan,
        seed: u64,
        terminal: &Terminal,
    ) -> Result<(String, Value), Refusal> {
        let watch = Mutex::new(Watch::start());
        let goal = Goal { seed, ..Goal::within(plan.tolerance) };
        let progress = |what: &'static str, done, all| {
            watch.lock().unwrap_or_else(PoisonError::into_inner).during(what);
            terminal.progress(what, done, all);
        };
        let done = plan.run(room, &goal, &Work::told(&progress))?;
        let mut watch = watch.into_inner().unwrap_or_else(PoisonError::into_inner);
        watch.stop();
        let seconds = watch.start.elapsed().as_secs_f64();
        let hemicubes: usize = done.solution.attempts.iter().map(|p| p.rows).sum();
        let solution = &done.solution;
        let mut text = "\nDone:\n\n".to_string();
        for line in &done.decisions[plan.decisions.len()..] {
            let line = line.strip_prefix("run: ").unwrap_or(line);
            text += &format!("run       {line}\n");
        }
        for (stage, seconds) in &watch.stages {
            text += &format!("time      {stage}: {seconds:.2} s\n");
        }
        text += &format!("time      in all: {seconds:.2} s\n");
        let stages: serde_json::Map<String, Value> =
            watch.stages.iter().map(|&(s, t)| (s.into(), json!(t))).collect();
        let spent = json!({
            "patches": solution.field.patches,
            "hemicubes": hemicubes,
            "elements": solution.field.mesh.elements.len(),
            "passes": solution.attempts.len(),
            "seconds": seconds,
            "stages": stages,
            "converged": solution.converged,
            "error": solution.certificate.error,
            "high": solution.certificate.worst(),
        });
        Ok((text, spent))
    }
}

fn predicted(p: &Predicted) -> Value {
    json!({
        "patches": p.patches,
        "hemicubes": p.hemicubes,
        "elements": p.elements,
        "seconds": p.seconds,
    })
}

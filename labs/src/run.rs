//! Running checks so that nothing a student writes can stop the grader.
//!
//! The tasks of a lab run one after another, each in a process of its own: this
//! program, started again. A panic fails one check. A crash, or a loop without end,
//! fails the checks of its task that had not finished. What the student prints is passed on.

use crate::check::{Bug, Verdict};
use crate::lab::{About, Lab, Who};
use radiosity::random::Stream;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A function that is still `todo!`.
pub const NOT_WRITTEN: Bug =
    Bug { name: "not-written", says: "This function is not written yet." };
/// A function that panics.
pub const PANIC: Bug = Bug {
    name: "panic",
    says: "The program stops itself: is an index out of range, or a list empty?",
};
/// A function that takes too long.
pub const ENDLESS: Bug = Bug {
    name: "endless",
    says: "Does a loop never end? Does its condition change inside it?",
};
/// A process that died.
pub const CRASH: Bug = Bug {
    name: "crash",
    says: "The process died: does a function call itself without end?",
};

/// A loop that prints without end.
pub const FLOOD: Bug = Bug { name: "flood", says: "Does a loop print without end?" };

/// Marks the lines on standard output that are the grader's, not the student's.
const MARK: char = '\u{1}';

/// What is passed on of a student's printing; the rest is dropped.
const PRINTED_LINES: usize = 200;
/// What a task may print before its pipe is closed: a loop that prints fills no memory.
const PRINTED_BYTES: u64 = 1 << 24;

/// What the child tells of one check: its name, the verdict, the seconds.
type Found = (String, Verdict, f64);

/// One check, run.
#[derive(Clone, Debug)]
pub struct Test {
    /// Which check.
    pub about: About,
    /// What it found.
    pub verdict: Verdict,
    /// Wall time of the check, in seconds; building the program is not in it.
    pub seconds: f64,
}

impl Test {
    /// The points earned: all or none.
    pub fn points(&self) -> u32 {
        if self.verdict.passed() { self.about.points } else { 0 }
    }
}

/// The number that a cohort's name stands for: FNV-1a of its bytes.
pub fn seed(cohort: &str) -> u64 {
    cohort.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// How tasks are run.
#[derive(Clone, Debug)]
pub struct Runner {
    /// The grader: this program.
    pub program: PathBuf,
    /// The cohort's name.
    pub cohort: String,
    /// What a task may take.
    pub limit: Duration,
    /// Passes on what the student prints.
    pub echo: bool,
}

impl Runner {
    /// Runs the checks of `task` (from 1) in a process of its own.
    ///
    /// # Errors
    /// When the process cannot be started.
    pub fn task(
        &self,
        lab: &Lab,
        task: usize,
        who: &Who,
    ) -> std::io::Result<Vec<Test>> {
        let start = Instant::now();
        let mut child = Command::new(&self.program)
            .args(["one-task", lab.name, &task.to_string()])
            .args([format!("--who={who}"), format!("--cohort={}", self.cohort)])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(if self.echo { Stdio::inherit() } else { Stdio::null() })
            .spawn()?;
        let mut found = Vec::new();
        let cause = self.listen(start, &mut child, &mut found);
        // Either may fail when the child has ended by itself, which is as good.
        let _ = child.kill();
        let _ = child.wait();
        let why = match cause {
            ENDLESS => format!("did not finish in {} s", self.limit.as_secs_f64()),
            FLOOD => "printed more than 16 MB".to_string(),
            _ => "did not finish: its process died".to_string(),
        };
        let lost = start.elapsed().as_secs_f64();
        let test = |about: About| {
            let found = found.iter().find(|(name, ..)| name == about.name).cloned();
            let (_, verdict, seconds) = found.unwrap_or_else(|| {
                (String::new(), Verdict::fail(why.clone(), Some(cause)), lost)
            });
            Test { about, verdict, seconds }
        };
        let checks = lab.kit.checks().into_iter().filter(|about| about.task == task);
        Ok(checks.map(test).collect())
    }

    /// Collects what the child finds until it ends or its time is up; says which, as
    /// the mistake that explains the checks it did not come to.
    fn listen(&self, start: Instant, child: &mut Child, found: &mut Vec<Found>) -> Bug {
        let (send, lines) = channel();
        if let Some(out) = child.stdout.take() {
            // The thread ends with the pipe: at the latest when the child is killed.
            std::thread::spawn(move || {
                let out = BufReader::new(out.take(PRINTED_BYTES)).split(b'\n');
                for line in out.map_while(Result::ok) {
                    if send.send(String::from_utf8_lossy(&line).into_owned()).is_err() {
                        break;
                    }
                }
            });
        }
        let (mut printed, mut bytes) = (0, 0);
        loop {
            match lines.recv_timeout(self.limit.saturating_sub(start.elapsed())) {
                Ok(line) if line.starts_with(MARK) => found.extend(read(&line[1..])),
                Ok(line) => {
                    bytes += line.len() as u64 + 1;
                    printed += usize::from(!line.is_empty());
                    if self.echo && !line.is_empty() && printed <= PRINTED_LINES {
                        eprintln!("{line}");
                    }
                }
                Err(RecvTimeoutError::Timeout) => return ENDLESS,
                Err(RecvTimeoutError::Disconnected) if bytes >= PRINTED_BYTES / 2 => {
                    return FLOOD; // what is not UTF-8 changes its length a little
                }
                Err(RecvTimeoutError::Disconnected) => return CRASH,
            }
        }
    }
}

/// The other end of [`Runner::task`]: runs the checks and prints what they found.
pub fn one_task(lab: &Lab, task: usize, who: &Who, cohort: &str) {
    let place = Arc::new(Mutex::new(String::new()));
    let seen = Arc::clone(&place);
    panic::set_hook(Box::new(move |info| {
        if let (Ok(mut seen), Some(at)) = (seen.lock(), info.location()) {
            *seen = format!("{}:{}", at.file(), at.line());
        }
    }));
    for (index, about) in lab.kit.checks().into_iter().enumerate() {
        if about.task != task {
            continue;
        }
        let mut stream = Stream::named(seed(cohort), &[seed(lab.name), index as u64]);
        let start = Instant::now();
        let run = AssertUnwindSafe(|| lab.kit.run(who, index, &mut stream));
        let verdict = match panic::catch_unwind(run) {
            Ok(Some(verdict)) => verdict,
            Ok(None) => Verdict::fail(format!("there is no work `{who}`"), None),
            Err(payload) => {
                let place = place.lock().map(|p| p.clone()).unwrap_or_default();
                panicked(&said(payload.as_ref()), &place)
            }
        };
        let line = write(about.name, &verdict, start.elapsed().as_secs_f64());
        let mut out = std::io::stdout().lock();
        // When the parent has gone there is nobody to tell.
        let _ = write!(out, "\n{MARK}{line}\n").and_then(|()| out.flush());
    }
}

fn panicked(said: &str, place: &str) -> Verdict {
    match said.strip_prefix("not yet implemented: ") {
        Some(what) => Verdict::fail(format!("{what} ({place})"), Some(NOT_WRITTEN)),
        None => Verdict::fail(format!("panicked at {place}: {said}"), Some(PANIC)),
    }
}

fn said(payload: &(dyn std::any::Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(|s| s.to_string());
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "(no message)".into())
}

fn write(name: &str, verdict: &Verdict, seconds: f64) -> Value {
    let bug = verdict.bug.map(|bug| json!({ "name": bug.name, "says": bug.says }));
    json!({
        "name": name,
        "metric": number(verdict.metric),
        "tolerance": number(verdict.tolerance),
        "message": verdict.message,
        "bug": bug,
        "seconds": seconds,
    })
}

fn read(line: &str) -> Option<Found> {
    let value: Value = serde_json::from_str(line).ok()?;
    let text = |key: &str| value[key].as_str().map(str::to_string);
    let metric = value["metric"].as_f64().unwrap_or(f64::INFINITY);
    let tolerance = value["tolerance"].as_f64().unwrap_or(0.0);
    // A handful of short texts a run: leaking them keeps `Bug` a plain constant.
    let leak = |text: &Value| text.as_str().map(|t| &*t.to_string().leak());
    let bug = &value["bug"];
    let bug = leak(&bug["name"])
        .zip(leak(&bug["says"]))
        .map(|(name, says)| Bug { name, says });
    let verdict = Verdict { metric, tolerance, message: text("message"), bug };
    Some((text("name")?, verdict, value["seconds"].as_f64()?))
}

/// A number as JSON has it; what is not finite becomes `null`.
pub fn number(x: f64) -> Value {
    serde_json::Number::from_f64(x).map_or(Value::Null, Value::Number)
}

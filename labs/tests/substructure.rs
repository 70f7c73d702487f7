//! The lab `substructure`: right answers that are not the answer, and the experiment that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::substructure::report::rounds;
use labs::substructure::{Work, answer, checks};

#[test]
fn other_right_answers_pass() {
    // Loops over patches, and over sorted values.
    let loops = Work {
        rows: |patch_of, patches, factor| {
            let mut all = vec![vec![0.0; patches]; patch_of.len()];
            for q in 0..patches {
                for (e, row) in all.iter_mut().enumerate() {
                    if patch_of[e] != q {
                        row[q] = factor(e, q);
                    }
                }
            }
            all
        },
        marks: |elements, share, smallest| {
            let mark = |e: &labs::substructure::given::Sample| {
                let mut sorted = e.radiosity.clone();
                sorted.sort_by(f64::total_cmp);
                let rms = (sorted[sorted.len() - 1] - sorted[0]) / 12_f64.sqrt();
                e.area >= smallest * (1.0 + 1e-12) && rms > (share / e.area).sqrt()
            };
            elements.iter().map(mark).collect()
        },
        ..answer::WORK
    };
    all_pass(checks::ALL, &[("answer", &answer::WORK), ("loops", &loops)]);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work =
        Work { gather: |room, _| vec![f64::NAN; room.area.len()], ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    assert_eq!(failing.map(|(name, _)| name).collect::<Vec<_>>(), ["gather", "agree"]);
}

/// The slopes that the report asks for: along a line the error is √h, so that half the error
/// takes two more rounds and four times the elements; all split, sixteen times.
#[test]
fn a_shadows_edge_costs_as_the_report_says() {
    let last = |tolerance: f64| {
        let done = rounds(&answer::WORK, tolerance, 1e-7, 14);
        (done.len(), *done.last().unwrap())
    };
    for tolerance in [0.05, 0.025] {
        let ((few, rough), (more, fine)) = (last(tolerance), last(tolerance / 2.0));
        assert_eq!(more - few, 2, "{tolerance}");
        let ratio = fine.elements as f64 / rough.elements as f64;
        assert!((3.9..4.1).contains(&ratio), "{tolerance}: {ratio}");
        assert!(fine.error <= tolerance / 2.0 && fine.error > tolerance / 5.0);
    }
    // Without a smallest area an error of nothing never ends; with one it does.
    assert_eq!(rounds(&answer::WORK, 0.0, 0.0, 8).len(), 8);
    assert_eq!(rounds(&answer::WORK, 0.0, 1e-3, 8).len(), 6);
}

//! Every gate is shown a small bad sample, and must catch it by name.

use book::chart;
use book::html;
use book::lecture_map::{Row, State, Written};
use book::source::{SECTIONS, chapter_faults, faults, fences, summary};
use std::fs;
use std::path::Path;
use std::sync::OnceLock;

/// A folder with a source file to include, under the build's own temporary folder.
fn folder() -> &'static Path {
    static WRITTEN: OnceLock<&Path> = OnceLock::new();
    WRITTEN.get_or_init(write_folder)
}

fn write_folder() -> &'static Path {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let long = "    step();\n".repeat(13);
    let code = format!(
        "// ANCHOR: good\nlet x = 1;\n// ANCHOR_END: good\n\
         // ANCHOR: blank\n\n// ANCHOR_END: blank\n\
         // ANCHOR: long\n{long}// ANCHOR_END: long\n"
    );
    fs::write(folder.join("code.rs"), code).unwrap();
    fs::write(folder.join("empty.md"), "\n").unwrap();
    fs::write(folder.join("mute.svg"), "<svg></svg>").unwrap();
    folder
}

const LONG: &str = "```rust,ignore\n{{#include code.rs:long}}\n```\n";
const RUN: &str = "```rust\n# extern crate radiosity;\nassert!(true);\n```\n";

#[test]
fn good_samples_pass() {
    let listing = "```rust,ignore\n{{#include code.rs:good}}\n```\n";
    let good = format!("# Title\n\n{RUN}\n{listing}\n![a box](x.png) $`x`$\n");
    assert_eq!(faults(folder(), &good), [""; 0]);
    let html = "<p>$<code>x</code>$ <a href=\"#here\" id=\"here\">see</a> \
                <img src='a.png' alt='a > b'></p>";
    assert_eq!(html::page_faults(html), [""; 0]);
}

#[test]
fn seeded_faults_of_a_page_are_caught() {
    let wide = format!("```text\n{}\n```", "x".repeat(89));
    let samples = [
        ("{{#include none.rs}}", "include none.rs"),
        ("{{#include code.rs:none}}", "no such anchor"),
        ("{{#include code.rs:blank}}", "selects nothing"),
        ("{{#include empty.md}}", "selects nothing"),
        ("{{#include code.rs:2:3}}", "not by line number"),
        ("{{#include mute.svg}}", "without <title>"),
        ("{{#playground code.rs}}", "no complete {{#include}}"),
        ("```\nlet x = 1;\n```", "no tag"),
        ("```rust,ignore\nlet x = 1;\n```", "listings by include alone"),
        ("```rust,ignore\n{{#include code.rs}}\n```", "names its anchor"),
        ("```rust\nuse radiosity::film;\n```", "extern crate radiosity"),
        (wide.as_str(), "89 columns"),
        ("![](x.png)", "without alt text"),
        ("## The size of $`x`$", "math in a heading"),
    ];
    for (sample, expected) in samples {
        let found = faults(folder(), sample);
        let caught = found.iter().any(|fault| fault.contains(expected));
        assert!(caught, "{sample:?} should say {expected:?}, said {found:?}");
    }
}

#[test]
fn seeded_faults_of_a_chapter_are_caught() {
    let heading = |title: &str| match title {
        "Lecturer's notes" => {
            format!("## {title}\n<div class=\"lecturer\">5 min</div>\n")
        }
        title => format!("## {title}\n"),
    };
    let sections: String = SECTIONS.into_iter().map(heading).collect();
    let good = format!("{sections}\n![a](a.snap.png)\n{RUN}");
    assert_eq!(chapter_faults(folder(), &good), [""; 0]);
    let samples = [
        (good.replace("## The idea\n", ""), "sections are"),
        (good.replace(".snap.png", ".png"), "no snapshot picture"),
        (good.replace("```rust", "```text"), "no tested example"),
        (good.replace("5 min", ""), "no lecturer's notes"),
        (format!("{good}{LONG}"), "13 lines"),
    ];
    for (sample, expected) in samples {
        let found = chapter_faults(folder(), &sample);
        assert!(found.iter().any(|f| f.contains(expected)), "{expected}: {found:?}");
    }
}

#[test]
fn seeded_faults_of_built_pages_are_caught() {
    let samples = [
        ("<p>{{#include x}}</p>", "{{# is left"),
        ("<p>it costs $5</p>", "stray $"),
        ("<script src=\"https://cdn.example/x.js\"></script>", "loads from outside"),
        ("<link href='//fonts.example/x.css'>", "loads from outside"),
        ("<img src=\"x.png\">", "without alt text"),
        ("<pre><code class=\"language-rust\"></code></pre>", "empty code block"),
        ("<p id=\"a\"></p><p id=\"a\"></p>", "two things have the id"),
    ];
    for (sample, expected) in samples {
        let found = html::page_faults(sample);
        assert!(found.iter().any(|f| f.contains(expected)), "{sample}: {found:?}");
    }
}

#[test]
fn links_that_lead_nowhere_are_caught() {
    let site = Path::new(env!("CARGO_TARGET_TMPDIR")).join("site");
    fs::create_dir_all(site.join("sub")).unwrap();
    let index = "<a href=\"sub/b.html#there\">good</a><a href=\"sub/b.html#gone\">bad</a>\
                 <a href=\"c.html\">bad</a><a href=\"https://example.org\">outside</a>";
    fs::write(site.join("index.html"), index).unwrap();
    fs::write(site.join("sub/b.html"), "<h2 id=\"there\"><a href=\"../\">up</a></h2>")
        .unwrap();
    fs::write(site.join("a.css"), "a { src: url(\"gone.woff2\") }").unwrap();
    let found = html::faults(&site).unwrap();
    for gone in ["sub/b.html#gone", "c.html", "gone.woff2", "../"] {
        assert!(found.iter().any(|f| f.ends_with(&format!(": {gone}"))), "{found:?}");
    }
    assert_eq!(found.len(), 4, "{found:?}");
    assert!(html::faults(&site.join("nothing")).is_err());
}

#[test]
fn rows_that_claim_too_much_are_caught() {
    let written = Written {
        page: "hemicube.md",
        module: "src/none.rs",
        figure: "pictures/none.snap.png",
        test: ("tests/factors/hemicube.rs", "no_such_test"),
        lab: Some("labs/none.md"),
    };
    let state = State::Done(written);
    let row = Row { topic: "", title: "A claim", lab: true, state };
    let found = row.faults(book::generated::root().parent().unwrap());
    for expected in ["does not show", "no module", "no test", "no lab"] {
        assert!(found.iter().any(|f| f.contains(expected)), "{expected}: {found:?}");
    }
    assert_eq!(found.len(), 4, "{found:?}");
}

/// The chart in the book is generated from the CSV, so a number that changes shows.
#[test]
fn a_changed_measurement_changes_the_chart() {
    let csv = "method,setting,milliseconds,max_error,reference\na,1,0.5,1e-2,exact\n";
    let draw = |csv: &str| chart::points(csv).map(|p| chart::svg("t", &p, "x", "y"));
    assert!(draw(csv).is_some_and(|svg| svg.contains("<title>t</title>")));
    assert_ne!(draw(csv), draw(&csv.replace("1e-2", "1.1e-2")));
    assert_eq!(draw(&csv.replace("1e-2", "small")), None);
}

#[test]
fn the_summary_is_read_with_its_drafts() {
    let entries = summary("# Part\n\n[Start](index.md)\n- [A](a.md)\n  - [B]()\n");
    let pages: Vec<_> =
        entries.iter().map(|e| (e.title.as_str(), e.page.as_deref())).collect();
    assert_eq!(pages, [("Start", Some("index.md")), ("A", Some("a.md")), ("B", None)]);
    assert_eq!(fences("```text\nx\n```\n")[0].body, ["x"]);
}

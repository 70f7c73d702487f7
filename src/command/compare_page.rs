//! The page that `radiosity compare` writes.

use super::compare::{DIFFERENCES, error_of, paths_of};
use super::report::percent;
use radiosity::chart::{Comparison, Panel};
use std::fmt::Write;

/// The page; its pictures lie beside it.
pub fn page(found: &Comparison, scene: &str, origin: &str) -> String {
    let scene = escaped(scene);
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{scene}: side by side</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>{scene}: side by side</h1>\n<p>{}</p>\n",
        escaped(origin)
    );
    text += "<h2>Classical radiosity | two-pass</h2>\n";
    text += &row(found, &["classical-radiosity", "two-pass"], "");
    text += "<h2>Ray tracing | radiosity | two-pass | reference</h2>\n";
    let methods = ["ray-tracing", "radiosity", "two-pass", "reference"];
    text += &row(found, &methods, "");
    text += "<h2>How far off</h2>\n<p>The difference from the reference, relative to its \
             mean. The reference's own noise is in it.</p>\n";
    let methods = ["classical-radiosity", "ray-tracing", "radiosity", "two-pass"];
    text += &row(found, &methods, "-difference");
    text += &legend();
    text += &table(found);
    text += &classes(found);
    text + "</body>\n</html>\n"
}

const STYLE: &str = "\
body{font:16px/1.5 sans-serif;max-width:90rem;margin:2rem auto;padding:0 1rem;\
color:#222;background:#fff}\
.row{display:flex;gap:1rem;flex-wrap:wrap}\
figure{flex:1 1 16rem;margin:0;max-width:36rem}\
img{width:100%;display:block}\
figcaption b{display:block}\
table{border-collapse:collapse;margin:1.5rem 0}\
td,th{padding:.2rem .8rem;border-bottom:1px solid #ccc;text-align:right}\
td:first-child,th:first-child{text-align:left}\
.scale{display:flex;max-width:36rem}.scale span{flex:1;text-align:center;padding:.2rem 0}";

fn row(found: &Comparison, names: &[&str], kind: &str) -> String {
    let mut text = String::from("<div class=\"row\">\n");
    for panel in names.iter().filter_map(|name| found.panel(name)) {
        let Panel { name, about, seconds, .. } = panel;
        let error = error_of(found, panel).replace('<', "&lt;");
        let title = name.replace('-', " ");
        let error = match panel.name == found.reference().name {
            true => format!("noise {error}"),
            false => format!("error {error}"),
        };
        let _ = writeln!(
            text,
            "<figure><img src=\"{name}{kind}.png\" alt=\"{title}: {about}\">\
             <figcaption><b>{title}</b> {about}; {error}, {seconds:.1} CPU s\
             </figcaption></figure>"
        );
    }
    text + "</div>\n"
}

/// The colours of differences with their numbers.
fn legend() -> String {
    let mut text = String::from("<div class=\"scale\">");
    for (value, [r, g, b]) in DIFFERENCES.legend(5) {
        let ink = if u32::from(g) > 120 { "#000" } else { "#fff" };
        let _ = write!(
            text,
            "<span style=\"background:rgb({r},{g},{b});color:{ink}\">{}</span>",
            percent(value)
        );
    }
    text + "</div>\n"
}

fn table(found: &Comparison) -> String {
    let mut text = String::from(
        "<table><tr><th>method</th><th>CPU s</th><th>error</th><th>brightness</th>\
         <th>random paths need for that error, CPU s</th></tr>\n",
    );
    for panel in &found.panels {
        let Panel { name, seconds, brightness, .. } = panel;
        let (title, error) = (name.replace('-', " "), error_of(found, panel));
        let error = error.replace('<', "&lt;");
        let paths = paths_of(found, panel);
        let _ = writeln!(
            text,
            "<tr><td>{title}</td><td>{seconds:.2}</td><td>{error}</td>\
             <td>{brightness:.3}</td><td>{paths}</td></tr>"
        );
    }
    let counted = found.counts.iter().filter(|counts| **counts).count();
    let left_out = percent(1.0 - counted as f64 / found.counts.len().max(1) as f64);
    let _ = writeln!(
        text,
        "</table>\n<p>Pixels twice as bright as white and their neighbours, {left_out} of all, do \
         not count. \
         Brightness is that of the picture, relative to the reference.</p>"
    );
    text
}

/// Whose light it is.
fn classes(found: &Comparison) -> String {
    let mut text = String::from(
        "<h2>Who carries which light</h2>\n<table><tr><th>light</th><th>paths</th>\
         <th>carried by</th><th>share</th></tr>\n",
    );
    let sum = found.classes.total().element_sum().max(f64::MIN_POSITIVE);
    for row in found.classes.rows().filter(|row| row.mean.element_sum() > 0.0) {
        let share = percent(row.mean.element_sum() / sum);
        let (name, word) = (row.class.name(), row.class.word());
        let owner = row.class.owner().name();
        let _ = writeln!(
            text,
            "<tr><td>{name}</td><td>{word}</td><td>{owner}</td><td>{share}</td></tr>"
        );
    }
    text + "</table>\n"
}

/// Text that may stand in HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

//! The pipeline as a drawing: what each stage makes, and where a change comes in.

use std::fmt::Write;

/// A box: what is done, what comes out of it, how much of it, what changes come in
/// here.
struct Stage {
    does: &'static str,
    makes: &'static str,
    much: &'static str,
    anew: &'static str,
}

const STAGES: [Stage; 4] = [
    Stage {
        does: "1 split",
        makes: "elements",
        much: "n polygons",
        anew: "a chair is moved",
    },
    Stage { does: "2 form factors", makes: "matrix F", much: "n² numbers", anew: "" },
    Stage {
        does: "3 solve",
        makes: "radiosities B",
        much: "n numbers a colour",
        anew: "paint, lamps",
    },
    Stage {
        does: "4 render",
        makes: "picture",
        much: "one for each eye",
        anew: "the eye moves",
    },
];

/// Width of a box, and from one to the next, in pixels.
const BOX: [i32; 2] = [132, 172];

/// The drawing, as SVG in the colour of the text around it.
pub fn svg() -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 190\" \
         width=\"700\" height=\"190\" role=\"img\" fill=\"none\" \
         stroke=\"currentColor\" font-size=\"14\">\n\
         <title>Four stages in a row: split, form factors, solve, render. A change of \
         the geometry enters at the first, of paint or lamps at the third, of the eye \
         at the last</title>\n",
    );
    let [width, step] = BOX;
    for (k, stage) in STAGES.iter().enumerate() {
        let left = 20 + step * k as i32;
        let (middle, right) = (left + width / 2, left + width);
        let last = k + 1 == STAGES.len();
        let opacity = if last { "0.25" } else { "0.1" };
        let _ = writeln!(
            svg,
            "<rect x=\"{left}\" y=\"40\" width=\"{width}\" height=\"74\" rx=\"8\" \
             fill=\"#d55e00\" fill-opacity=\"{opacity}\"/>"
        );
        let mut text = |y: i32, style: &str, text: &str| {
            let _ = writeln!(
                svg,
                "<text x=\"{middle}\" y=\"{y}\" text-anchor=\"middle\" \
                 fill=\"currentColor\" stroke=\"none\"{style}>{text}</text>"
            );
        };
        text(64, " font-weight=\"bold\"", stage.does);
        text(84, "", stage.makes);
        text(103, " font-size=\"12\"", stage.much);
        text(176, " font-size=\"13\"", stage.anew);
        if !last {
            arrow(&mut svg, [right, 77], [right + step - width, 77]);
        }
        if !stage.anew.is_empty() {
            arrow(&mut svg, [middle, 160], [middle, 116]);
        }
    }
    let last = 20 + 3 * step;
    let _ = writeln!(
        svg,
        "<path d=\"M20 26V18H{}V26M{last} 26V18H{}V26\" stroke-opacity=\"0.6\"/>",
        20 + 2 * step + width,
        last + width,
    );
    let mut over = |x: i32, text: &str| {
        let _ = writeln!(
            svg,
            "<text x=\"{x}\" y=\"12\" text-anchor=\"middle\" font-size=\"13\" \
             fill=\"currentColor\" stroke=\"none\">{text}</text>"
        );
    };
    over(20 + step + width / 2, "once for the room: no eye in it");
    over(20 + 3 * step + width / 2, "once for each eye");
    svg.push_str("</svg>\n");
    svg
}

/// An arrow along an axis, its head at `to`.
fn arrow(svg: &mut String, [x, y]: [i32; 2], to: [i32; 2]) {
    let [u, v] = to;
    let (dx, dy) = ((u - x).signum() * 6, (v - y).signum() * 6);
    let _ = writeln!(
        svg,
        "<path d=\"M{x} {y}L{u} {v}M{} {}L{u} {v}L{} {}\"/>",
        u - dx - dy,
        v - dy - dx,
        u - dx + dy,
        v - dy + dx,
    );
}

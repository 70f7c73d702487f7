//! Played students of task 3.

use crate::hemicube::Work;
use crate::hemicube::answer::WORK;
use crate::hemicube::bugs::*;
use crate::hemicube::given::{Fragment, Item};
use crate::lab::{Wrong, plays};
use crate::run::PANIC;

/// They see the wrong things.
pub const ALL: &[Wrong<Work>] = &[
    plays(
        "farthest",
        "depth is compared the wrong way round",
        &[FARTHEST],
        Work {
            item_buffer: |cells, own, fragments| {
                painted(cells, own, fragments, |f| -f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "last-wins",
        "a later fragment covers an earlier one",
        &[LAST_WINS],
        Work {
            item_buffer: |cells, own, fragments| {
                let mut items = vec![Item::Nothing; cells];
                for f in fragments.iter().filter(|f| f.element != own) {
                    items[f.cell] = item(f);
                }
                items
            },
            ..WORK
        },
    ),
    plays(
        "first-wins",
        "a full cell is full",
        &[FIRST_WINS],
        Work {
            item_buffer: |cells, own, fragments| {
                let mut items = vec![Item::Nothing; cells];
                for f in fragments.iter().filter(|f| f.element != own).rev() {
                    items[f.cell] = item(f);
                }
                items
            },
            ..WORK
        },
    ),
    plays(
        "far-plane",
        "the depth buffer is cleared to 1, as in OpenGL",
        &[FAR_PLANE],
        Work {
            item_buffer: |cells, own, fragments| {
                let near: Vec<Fragment> =
                    fragments.iter().copied().filter(|f| f.depth < 1.0).collect();
                painted(cells, own, &near, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "backs-culled",
        "backs are culled, as in OpenGL",
        &[BACKS_IGNORED],
        Work {
            item_buffer: |cells, own, fragments| {
                let fronts: Vec<Fragment> =
                    fragments.iter().copied().filter(|f| f.front).collect();
                painted(cells, own, &fronts, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "backs-as-fronts",
        "a surface is a surface",
        &[BACKS_AS_FRONTS],
        Work {
            item_buffer: |cells, own, fragments| {
                painted(cells, own, fragments, |f| f.depth, |f| Item::Front(f.element))
            },
            ..WORK
        },
    ),
    plays(
        "backs-as-nothing",
        "a black back is as good as nothing",
        &[BACKS_AS_NOTHING],
        {
            Work {
                item_buffer: |cells, own, fragments| {
                    painted(
                        cells,
                        own,
                        fragments,
                        |f| f.depth,
                        |f| match f.front {
                            true => Item::Front(f.element),
                            false => Item::Nothing,
                        },
                    )
                },
                ..WORK
            }
        },
    ),
    plays(
        "self-seen",
        "`own` is not needed",
        &[SELF_SEEN],
        Work {
            item_buffer: |cells, _, fragments| {
                painted(cells, usize::MAX, fragments, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "panics",
        "a buffer too short",
        &[PANIC],
        Work {
            item_buffer: |cells, own, fragments| {
                print!("{cells} cells; "); // students do; it must not disturb
                (WORK.item_buffer)(cells / 2, own, fragments)
            },
            ..WORK
        },
    ),
];

fn item(fragment: &Fragment) -> Item {
    if fragment.front { Item::Front(fragment.element) } else { Item::Back }
}

/// Sorts by `key`, and paints from the largest to the smallest.
fn painted(
    cells: usize,
    own: usize,
    fragments: &[Fragment],
    key: fn(&Fragment) -> f64,
    store: fn(&Fragment) -> Item,
) -> Vec<Item> {
    let mut sorted: Vec<&Fragment> =
        fragments.iter().filter(|f| f.element != own).collect();
    sorted.sort_by(|a, b| key(b).total_cmp(&key(a)));
    let mut items = vec![Item::Nothing; cells];
    sorted.into_iter().for_each(|f| items[f.cell] = store(f));
    items
}

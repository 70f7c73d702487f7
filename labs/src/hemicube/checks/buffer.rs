//! Task 3: the item buffer, against a slow one of our own on random fragments.

use crate::check::{Bug, Verdict};
use crate::draw::{uniform, whole_number};
use crate::hemicube::Work;
use crate::hemicube::bugs::*;
use crate::hemicube::given::{Fragment, Item};
use radiosity::random::Stream;

/// What a draw of fragments holds beside fronts at depths below 1.
#[derive(Clone, Copy)]
pub struct Draw {
    far: bool,
    backs: bool,
    own: bool,
}

/// Nothing else.
pub const NEAR: Draw = Draw { far: false, backs: false, own: false };
/// Depths up to 1000.
pub const FAR: Draw = Draw { far: true, ..NEAR };
/// Backs.
pub const BACKS: Draw = Draw { backs: true, ..NEAR };
/// The element itself, at a depth of about 0.
pub const OWN: Draw = Draw { own: true, ..NEAR };

/// Does the second fragment replace the first?
type Replace = fn(&Fragment, &Fragment) -> bool;
/// What a cell stores, if the fragment is let in at all.
type Store = fn(&Fragment, own: usize) -> Option<Item>;

fn stored(fragment: &Fragment, own: usize) -> Option<Item> {
    let item = if fragment.front { Item::Front(fragment.element) } else { Item::Back };
    (fragment.element != own).then_some(item)
}

const NEARER: Replace = |old, new| new.depth < old.depth;

/// Wrong item buffers: how a fragment replaces another, and what is stored.
const WRONG_BUFFERS: &[(Bug, Replace, Store)] = &[
    (FARTHEST, |old, new| new.depth > old.depth, stored),
    (LAST_WINS, |_, _| true, stored),
    (FIRST_WINS, |_, _| false, stored),
    (FAR_PLANE, NEARER, |f, own| stored(f, own).filter(|_| f.depth < 1.0)),
    (BACKS_IGNORED, NEARER, |f, own| stored(f, own).filter(|_| f.front)),
    (BACKS_AS_FRONTS, NEARER, |f, own| stored(&Fragment { front: true, ..*f }, own)),
    (BACKS_AS_NOTHING, NEARER, |f, own| {
        stored(f, own).map(|item| if item == Item::Back { Item::Nothing } else { item })
    }),
    (SELF_SEEN, NEARER, |f, _| stored(f, usize::MAX)),
];

fn resolve(
    cells: usize,
    own: usize,
    fragments: &[Fragment],
    replace: Replace,
    store: Store,
) -> Vec<Item> {
    let mut held: Vec<Option<(Fragment, Item)>> = vec![None; cells];
    for fragment in fragments {
        let slot = &mut held[fragment.cell];
        if let Some(item) = store(fragment, own)
            && slot.as_ref().is_none_or(|(old, _)| replace(old, fragment))
        {
            *slot = Some((*fragment, item));
        }
    }
    held.into_iter().map(|slot| slot.map_or(Item::Nothing, |(_, item)| item)).collect()
}

/// The items of one face.
pub fn buffer(work: &Work, stream: &mut Stream, draw: Draw) -> Verdict {
    const CELLS: usize = 40;
    let own = whole_number(stream, 0, 12);
    let mut fragments = Vec::new();
    for _ in 0..3 * CELLS {
        let other = (own + whole_number(stream, 1, 12)) % 12;
        let far = if draw.far { uniform(stream, 1.0, 1000.0) } else { 1.0 };
        let itself = draw.own && stream.next() < 0.2;
        fragments.push(Fragment {
            cell: whole_number(stream, 0, CELLS - 4), // the last ones stay empty
            depth: if itself { 1e-12 } else { far * uniform(stream, 0.05, 1.0) },
            element: if itself { own } else { other },
            front: itself || !draw.backs || stream.next() < 0.5,
        });
    }
    let expected = resolve(CELLS, own, &fragments, NEARER, stored);
    let got = (work.item_buffer)(CELLS, own, &fragments);
    if got.len() != CELLS {
        let n = got.len();
        return Verdict::fail(format!("got {n} items for {CELLS} cells"), None);
    }
    let off = |k: &usize| got[*k] != expected[*k];
    let Some(cell) = (0..CELLS).find(off) else { return Verdict::pass(0.0, 0.0) };
    let suspect = |&&(_, replace, store): &&(Bug, Replace, Store)| {
        resolve(CELLS, own, &fragments, replace, store) == got
    };
    let here = fragments.iter().filter(|f| f.cell == cell);
    let told: Vec<String> = here
        .map(|f| {
            let side = if f.front { "front" } else { "back" };
            format!("{side} of {} at {:.3}", f.element, f.depth)
        })
        .collect();
    let message = format!(
        "element {own}, cell {cell} sees {:?}, expected {:?}; it was offered, in this \
         order: {}",
        got[cell],
        expected[cell],
        if told.is_empty() { "nothing".into() } else { told.join(", ") }
    );
    let share = (0..CELLS).filter(off).count() as f64 / CELLS as f64;
    let bug = WRONG_BUFFERS.iter().find(suspect).map(|entry| entry.0);
    Verdict { metric: share, tolerance: 0.0, message: Some(message), bug }
}

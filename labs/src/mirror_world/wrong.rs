//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, by_mirror, corridor, image, image_of, reaches, through};
use super::bugs::*;
use super::given::{clip, crossing, lambert, plane};
use crate::lab::{Wrong, plays};
use radiosity::prelude::{DVec3, Plane};

/// The answer, but with other images of points, and all that comes of them.
macro_rules! shows {
    ($image:expr) => {
        Work {
            image: $image,
            image_of: |mirror, corners| reflected(mirror, corners, $image),
            by_mirror: |p, n, mirror, lamp| {
                let seen = reflected(plane(mirror), lamp, $image);
                lambert(p, n, &through(p, mirror, &seen))
            },
            ..WORK
        }
    };
}

/// The answer, but with other images of outlines.
macro_rules! mirrors {
    ($image_of:expr) => {
        Work {
            image_of: $image_of,
            by_mirror: |p, n, mirror, lamp| {
                let image_of: fn(Plane, &[DVec3]) -> Vec<DVec3> = $image_of;
                lambert(p, n, &through(p, mirror, &image_of(plane(mirror), lamp)))
            },
            ..WORK
        }
    };
}

/// The answer, but seen through other windows.
macro_rules! looks {
    ($through:expr) => {
        Work {
            through: $through,
            by_mirror: |p, n, mirror, lamp| {
                let through: fn(DVec3, &[DVec3], &[DVec3]) -> Vec<DVec3> = $through;
                lambert(p, n, &through(p, mirror, &image_of(plane(mirror), lamp)))
            },
            ..WORK
        }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("once-the-height", "down to the mirror", &[ON_THE_MIRROR, DARK], {
        shows!(|mirror, x| x.midpoint(image(mirror, x)))
    }),
    plays("plus", "along the normal, twice the height", &[AWAY, DARK], {
        shows!(|mirror, x| x + (x - image(mirror, x)))
    }),
    plays("like-a-direction", "r = d − 2 (d·n) n", &[THROUGH_ORIGIN], {
        shows!(|mirror, x| x.reflect(mirror.normal))
    }),
    plays("all-axes", "left is right, and up is down", &[IN_A_POINT, DARK], {
        shows!(|mirror, x| 2.0 * mirror.offset * mirror.normal - x)
    }),
    plays("same-order", "the image of corner k is corner k", &[TURNED, DARK], {
        mirrors!(|mirror, corners| {
            clip(mirror, corners).into_iter().map(|c| image(mirror, c)).collect()
        })
    }),
    plays("all-of-it", "a mirror mirrors", &[BEHIND], {
        mirrors!(|mirror, corners| {
            corners.iter().rev().map(|&c| image(mirror, c)).collect()
        })
    }),
    plays(
        "wrong-half",
        "behind the mirror is the virtual world",
        &[WRONG_HALF, DARK],
        mirrors!(|mirror, corners| image_of(mirror.flipped(), corners)),
    ),
    plays("front-of-the-image", "first mirrored, then clipped", &[WRONG_HALF, DARK], {
        mirrors!(|mirror, corners| {
            let image = corners.iter().rev().map(|&c| image(mirror, c));
            clip(mirror, &image.collect::<Vec<_>>())
        })
    }),
    plays("no-frame", "the virtual world is there", &[NOT_CLIPPED], {
        looks!(|eye, window, corners| match plane(window).height(eye) > 0.0 {
            true => clip(plane(window).flipped(), corners),
            false => Vec::new(),
        })
    }),
    plays("inside-out", "(a − eye) × (b − eye)", &[OUTSIDE, DARK], {
        looks!(|eye, window, corners| {
            if plane(window).height(eye) <= 0.0 {
                return Vec::new();
            }
            let mut seen = clip(plane(window).flipped(), corners);
            for k in 0..window.len() {
                let next = window[(k + 1) % window.len()];
                seen = clip(plane(&[eye, window[k], next]), &seen);
            }
            seen
        })
    }),
    plays("open-frame", "n corners, n − 1 edges", &[GAP], {
        looks!(|eye, window, corners| {
            if plane(window).height(eye) <= 0.0 {
                return Vec::new();
            }
            let mut seen = clip(plane(window).flipped(), corners);
            for pair in window.windows(2) {
                seen = clip(plane(&[eye, pair[1], pair[0]]), &seen);
            }
            seen
        })
    }),
    plays("pyramid-alone", "what is in the pyramid is seen", &[BEFORE], {
        looks!(|eye, window, corners| {
            let mut seen = corners.to_vec();
            if plane(window).height(eye) <= 0.0 {
                seen.clear();
            }
            for (k, &a) in window.iter().enumerate() {
                let b = window[(k + 1) % window.len()];
                seen = clip(plane(&[eye, b, a]), &seen);
            }
            seen
        })
    }),
    plays("two-sided-window", "a window has two sides", &[FROM_BEHIND], {
        looks!(|eye, window, corners| {
            let back: Vec<DVec3> = window.iter().rev().copied().collect();
            let mut seen = through(eye, window, corners);
            seen.extend(through(eye, &back, corners));
            seen
        })
    }),
    plays("whole-lamp", "there is an image, or there is none", &[NOT_CLIPPED], {
        Work {
            by_mirror: |p, n, mirror, lamp| match by_mirror(p, n, mirror, lamp) > 0.0 {
                true => lambert(p, n, &image_of(plane(mirror), lamp)),
                false => 0.0,
            },
            ..WORK
        }
    }),
    plays("lamp-and-image", "all that arrives", &[BOTH_WAYS], {
        Work {
            by_mirror: |p, n, mirror, lamp| {
                let straight = plane(mirror).height(p) > 0.0;
                let straight = if straight { lambert(p, n, lamp) } else { 0.0 };
                straight + by_mirror(p, n, mirror, lamp)
            },
            ..WORK
        }
    }),
    plays("lamp-itself", "the window shows the lamp", &[DIRECT], {
        Work { by_mirror: |p, n, _, lamp| lambert(p, n, lamp), ..WORK }
    }),
    plays("dark-mirror", "clockwise, counter-clockwise", &[DARK], {
        Work {
            by_mirror: |p, n, mirror, lamp| {
                let mut image = image_of(plane(mirror), lamp);
                image.reverse();
                lambert(p, n, &through(p, mirror, &image))
            },
            ..WORK
        }
    }),
    plays("two-sided-mirror", "glass with silver on it", &[FROM_BEHIND], {
        Work {
            by_mirror: |p, n, mirror, lamp| {
                let back: Vec<DVec3> = mirror.iter().rev().copied().collect();
                by_mirror(p, n, mirror, lamp).max(by_mirror(p, n, &back, lamp))
            },
            ..WORK
        }
    }),
    plays("no-cards", "light is fast", &[NO_CARDS], {
        Work { reaches: |x, p, mirror, _| reaches(x, p, mirror, &[]), ..WORK }
    }),
    plays("card-at-the-eye", "what stands before the mirror", &[EYE_LEG], {
        Work {
            reaches: |x, p, mirror, cards| {
                let hit = on(p, x, plane(mirror));
                let free = cards.iter().all(|card| crossing(hit, p, card).is_none());
                free && reaches(x, p, mirror, &[])
            },
            ..WORK
        }
    }),
    plays("card-at-the-lamp", "the lamp casts shadows", &[LAMP_LEG], {
        Work {
            reaches: |x, p, mirror, cards| {
                let hit = on(p, x, plane(mirror));
                let free = cards.iter().all(|card| crossing(x, hit, card).is_none());
                free && reaches(x, p, mirror, &[])
            },
            ..WORK
        }
    }),
    plays("card-to-the-image", "a straight line to the image", &[TO_THE_IMAGE], {
        Work {
            reaches: |x, p, mirror, cards| {
                let there = image(plane(mirror), x);
                let free = cards.iter().all(|card| crossing(p, there, card).is_none());
                free && reaches(x, p, mirror, &[])
            },
            ..WORK
        }
    }),
    plays("card-between", "is x seen from p?", &[STRAIGHT], {
        Work {
            reaches: |x, p, mirror, cards| {
                let free = cards.iter().all(|card| crossing(p, x, card).is_none());
                free && reaches(x, p, mirror, &[])
            },
            ..WORK
        }
    }),
    plays("no-rim", "a plane is a plane", &[NO_END], {
        Work {
            reaches: |x, p, mirror, cards| {
                let middle = mirror.iter().sum::<DVec3>() / mirror.len() as f64;
                let far = |c: &DVec3| middle + (c - middle) * 1e3;
                reaches(x, p, &mirror.iter().map(far).collect::<Vec<_>>(), cards)
            },
            ..WORK
        }
    }),
    plays("any-side", "light comes from anywhere", &[FROM_BEHIND], {
        Work {
            reaches: |x, p, mirror, cards| {
                let back: Vec<DVec3> = mirror.iter().rev().copied().collect();
                reaches(x, p, mirror, cards) || reaches(x, p, &back, cards)
            },
            ..WORK
        }
    }),
    plays("one-side", "to the right, and on to the right", &[ONE_SIDE], {
        Work { corridor: |rho, n| 0.5 * (corridor(rho, n) + corridor(rho, 0)), ..WORK }
    }),
    plays("dimmed-once", "all that comes by mirrors keeps ρ", &[ONCE_DIMMED], {
        Work {
            corridor: |rho, n| {
                let lamp = corridor(1.0, 0);
                lamp + rho * (corridor(1.0, n) - lamp)
            },
            ..WORK
        }
    }),
    plays("perfect", "a mirror is a mirror", &[NOT_DIMMED], {
        Work { corridor: |_, n| corridor(1.0, n), ..WORK }
    }),
    plays("one-more", "from 0 to L, and one", &[OFF_BY_ONE], {
        Work { corridor: |rho, n| corridor(rho, n + 1), ..WORK }
    }),
    plays("one-less", "0 .. L", &[OFF_BY_ONE], {
        Work { corridor: |rho, n| corridor(rho, n.max(1) - 1), ..WORK }
    }),
    plays("both-lamps", "each mirror has its lamp and its images", &[LAMP_TWICE], {
        Work { corridor: |rho, n| corridor(rho, n) + corridor(rho, 0), ..WORK }
    }),
    plays("every-order", "two mirrors, L reflections: 2ᴸ images", &[DOUBLED], {
        Work {
            corridor: |rho, n| {
                let mut sum = corridor(rho, 0);
                for k in 1..=n {
                    let level = corridor(1.0, k) - corridor(1.0, k - 1);
                    sum += (2.0 * rho).powf(k as f64) * level / 2.0;
                }
                sum
            },
            ..WORK
        }
    }),
];

/// The image of the front part, by other images of points.
fn reflected(
    mirror: Plane,
    v: &[DVec3],
    image: fn(Plane, DVec3) -> DVec3,
) -> Vec<DVec3> {
    let mut seen = clip(mirror, v);
    seen.reverse();
    seen.iter().map(|&corner| image(mirror, corner)).collect()
}

/// Where the path from `p` to `x` by the plane of a mirror hits it.
fn on(p: DVec3, x: DVec3, mirror: Plane) -> DVec3 {
    let (hp, hx) = (mirror.height(p), mirror.height(x));
    p.lerp(image(mirror, x), hp / (hp + hx))
}

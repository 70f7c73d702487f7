//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, brightest, refine, shoot, shown};
use super::bugs::*;
use super::given::{By, Light, Progress};
use crate::gather::given::{Balance, Room};
use crate::lab::{Wrong, plays};
use crate::run::PANIC;

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("watts-per-square-metre", "bright is bright", &[BY_RADIOSITY], {
        Work {
            brightest: |room, unshot, _| brightest(room, unshot, By::Radiosity),
            ..WORK
        }
    }),
    plays("always-power", "power is what counts", &[BY_POWER], {
        Work { brightest: |room, unshot, _| brightest(room, unshot, By::Power), ..WORK }
    }),
    plays("largest-first", "large ones matter", &[LARGEST], {
        Work {
            brightest: |room, unshot, by| {
                let lit: Vec<f64> =
                    unshot.iter().map(|u| f64::from(u8::from(*u > 0.0))).collect();
                match by {
                    By::Power => brightest(room, &lit, by),
                    By::Radiosity => brightest(room, unshot, by),
                }
            },
            ..WORK
        }
    }),
    plays("smaller-than", "< for >", &[DIMMEST], {
        Work {
            brightest: |room, unshot, by| {
                let upside_down = |(u, a): (&f64, &f64)| match by {
                    _ if *u <= 0.0 => 0.0,
                    By::Power => 1.0 / (u * a * a),
                    By::Radiosity => 1.0 / u,
                };
                let all = unshot.iter().zip(&room.area).map(upside_down);
                brightest(room, &all.collect::<Vec<f64>>(), by)
            },
            ..WORK
        }
    }),
    plays("somebody-always", "0 is a number, too", &[NEVER_ENDS], {
        Work {
            brightest: |room, unshot, by| {
                Some(brightest(room, unshot, by).unwrap_or(0))
            },
            ..WORK
        }
    }),
    plays("small-is-nothing", "1e-6 is as good as 0", &[STOPS_EARLY], {
        Work {
            brightest: |room, unshot, by| {
                brightest(room, unshot, by).filter(|&i| unshot[i] > 1e-6)
            },
            ..WORK
        }
    }),
    plays("factor-times-radiosity", "B_j gains ρ F B", &[NO_AREAS], {
        Work { shoot: |r, l, i| by_areas(r, l, i, |_, _| 1.0), ..WORK }
    }),
    plays("areas-inverted", "A_j/A_i", &[UPSIDE_DOWN], {
        Work { shoot: |r, l, i| by_areas(r, l, i, |from, to| to / from), ..WORK }
    }),
    plays("as-on-the-slide", "F_ji A_i/A_j, as the slide says", &[SLIDE], {
        Work {
            shoot: |room, light, from| {
                let mut turned = room.clone();
                for (to, row) in room.factors.iter().enumerate() {
                    turned.factors[from][to] = row[from];
                }
                shoot(&turned, light, from);
            },
            ..WORK
        }
    }),
    plays("own-paint", "ρ_i, as in B_i", &[SENDERS_PAINT], {
        Work {
            shoot: |room, light, from| {
                let mut painted = room.clone();
                painted.reflectance.fill(room.reflectance[from]);
                shoot(&painted, light, from);
            },
            ..WORK
        }
    }),
    plays("white-walls", "light is light", &[NO_PAINT], {
        Work {
            shoot: |room, light, from| {
                let mut painted = room.clone();
                painted.reflectance.fill(1.0);
                shoot(&painted, light, from);
            },
            ..WORK
        }
    }),
    plays("all-radiosity", "it shoots what it has: B", &[SENDS_ALL], {
        Work {
            shoot: |room, light, from| {
                light.unshot[from] = light.radiosity[from];
                shoot(room, light, from);
            },
            ..WORK
        }
    }),
    plays("keeps-its-light", "it still shines", &[NOT_CLEARED], {
        Work {
            shoot: |room, light, from| {
                let had = light.unshot[from];
                shoot(room, light, from);
                light.unshot[from] += had;
            },
            ..WORK
        }
    }),
    plays("clears-at-the-end", "first send, then tidy up", &[CLEARED_LAST], {
        Work {
            shoot: |room, light, from| {
                shoot(room, light, from);
                light.unshot[from] = 0.0;
            },
            ..WORK
        }
    }),
    plays("clears-too-soon", "first tidy up, then send", &[NOTHING_SENT], {
        Work {
            shoot: |room, light, from| {
                light.unshot[from] = 0.0;
                shoot(room, light, from);
            },
            ..WORK
        }
    }),
    plays("one-bounce", "B is what counts", &[NOT_PASSED_ON], {
        Work {
            shoot: |room, light, from| {
                let mut had = light.unshot.clone();
                had[from] = 0.0;
                shoot(room, light, from);
                light.unshot = had;
            },
            ..WORK
        }
    }),
    plays("equals", "= for +=", &[OVERWRITES], {
        Work {
            shoot: |room, light, from| {
                let nothing = vec![0.0; light.unshot.len()];
                light.radiosity = nothing;
                shoot(room, light, from);
            },
            ..WORK
        }
    }),
    plays("dark-when-sent", "who gives it away has it no more", &[GOES_OUT], {
        Work {
            shoot: |room, light, from| {
                shoot(room, light, from);
                light.radiosity[from] = 0.0;
            },
            ..WORK
        }
    }),
    plays("arrives-painted", "H is what is seen", &[REFLECTED_ARRIVES], {
        Work {
            shoot: |room, light, from| {
                let before = light.irradiance.clone();
                shoot(room, light, from);
                for (i, before) in before.into_iter().enumerate() {
                    let arrived = light.irradiance[i] - before;
                    light.irradiance[i] = before + room.reflectance[i] * arrived;
                }
            },
            ..WORK
        }
    }),
    plays("index-too-far", "elements count from 1", &[PANIC], {
        Work { shoot: |room, light, _| shoot(room, light, room.area.len()), ..WORK }
    }),
    plays("spread-once", "spread the rest evenly", &[NO_BOUNCES], {
        Work {
            shown: |room, light| {
                let area: f64 = room.area.iter().sum();
                let kept: f64 = room
                    .area
                    .iter()
                    .zip(&room.reflectance)
                    .map(|(a, r)| a * (1.0 - r))
                    .sum();
                guessed(room, light, kept / area)
            },
            ..WORK
        }
    }),
    plays("mean-of-elements", "a mean is a mean", &[PLAIN_MEAN], {
        Work {
            shown: |room, light| {
                let even = Room { area: vec![1.0; room.area.len()], ..room.clone() };
                shown(&even, light)
            },
            ..WORK
        }
    }),
    plays("glow", "all is lit alike", &[NOT_PAINTED], {
        Work {
            shown: |room, light| {
                let picture = shown(room, light);
                let lit = picture.iter().zip(&light.radiosity).zip(&room.reflectance);
                lit.map(|((p, b), rho)| b + (p - b) / rho).collect()
            },
            ..WORK
        }
    }),
    plays("ambient-of-all", "all light is spread", &[OF_ALL_LIGHT], {
        Work {
            shown: |room, light| {
                let all = Light { unshot: light.radiosity.clone(), ..light.clone() };
                shown(room, &all)
            },
            ..WORK
        }
    }),
    plays("keeps-the-reflected", "ρ is what stays", &[REFLECTED], {
        Work {
            ledger: |room, light| {
                let mut turned = room.clone();
                turned.reflectance.iter_mut().for_each(|rho| *rho = 1.0 - *rho);
                (WORK.ledger)(&turned, light)
            },
            ..WORK
        }
    }),
    plays("absorbs-what-leaves", "B is the light there is", &[ABSORBS_RADIOSITY], {
        Work {
            ledger: |room, light| {
                let leaving =
                    Light { irradiance: light.radiosity.clone(), ..light.clone() };
                (WORK.ledger)(room, &leaving)
            },
            ..WORK
        }
    }),
    plays("watts-without-areas", "the sum of all", &[NO_AREA], {
        Work {
            ledger: |room, light| {
                let share = |x: &[f64]| x.iter().sum::<f64>();
                let kept = room.reflectance.iter().zip(&light.irradiance);
                Balance {
                    emitted: share(&room.emission),
                    absorbed: kept.map(|(rho, h)| (1.0 - rho) * h).sum(),
                    unshot: share(&light.unshot),
                }
            },
            ..WORK
        }
    }),
    plays("starts-dark", "nothing is lit yet", &[NO_EMISSION], {
        Work { refine: |room, shots| with_emission(room, shots, -1.0), ..WORK }
    }),
    plays("adds-emission", "and then what it emits itself", &[EMISSION_TWICE], {
        Work { refine: |room, shots| with_emission(room, shots, 1.0), ..WORK }
    }),
    plays("keeps-the-guess", "the picture is the result", &[AMBIENT_IN_RESULT], {
        Work {
            refine: |room, shots| {
                let Progress { mut light, picture } = refine(room, shots);
                light.radiosity.clone_from(&picture);
                Progress { light, picture }
            },
            ..WORK
        }
    }),
    plays("one-more", "from 0 to shots", &[OFF_BY_ONE], {
        Work { refine: |room, shots| refine(room, shots + 1), ..WORK }
    }),
    plays("specks-first", "the brightest is the brightest", &[BY_RADIOSITY], {
        Work {
            refine: |room, shots| {
                let mut light = refine(room, 0).light;
                for _ in 0..shots {
                    if let Some(i) = brightest(room, &light.unshot, By::Radiosity) {
                        shoot(room, &mut light, i);
                    }
                }
                Progress { picture: shown(room, &light), light }
            },
            ..WORK
        }
    }),
];

/// A shot with another ratio of the areas, of sender and receiver.
fn by_areas(room: &Room, light: &mut Light, i: usize, ratio: fn(f64, f64) -> f64) {
    let mut warped = room.clone();
    for (to, factor) in warped.factors[i].iter_mut().enumerate() {
        let (here, there) = (room.area[i], room.area[to]);
        *factor *= ratio(here, there) * there / here;
    }
    shoot(&warped, light, i);
}

/// The picture with so many times the guess.
fn guessed(room: &Room, light: &Light, times: f64) -> Vec<f64> {
    let picture = shown(room, light);
    picture.iter().zip(&light.radiosity).map(|(p, b)| b + times * (p - b)).collect()
}

/// So many shots, and then so many times the emission more.
fn with_emission(room: &Room, shots: usize, times: f64) -> Progress {
    let Progress { mut light, .. } = refine(room, shots);
    for (b, e) in light.radiosity.iter_mut().zip(&room.emission) {
        *b += times * e;
    }
    Progress { picture: shown(room, &light), light }
}

//! Cases of the accuracy tables, computed by other programs, with the tables' names.

/// A point, a polygon, and the form factor from one to the other.
pub struct Case {
    /// Its name in the tables.
    pub name: &'static str,
    /// The point.
    pub point: [f64; 3],
    /// Its unit normal.
    pub normal: [f64; 3],
    /// The polygon, its front towards the point.
    pub corners: &'static [[f64; 3]],
    /// The form factor.
    pub factor: f64,
}

/// Wholly above the horizon, or touching it.
pub const ABOVE: &[Case] = &[
    Case {
        name: "A4-par-corner-1x1-d1",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]],
        factor: 0.138_531_605_994_893,
    },
    Case {
        name: "A4-par-corner-1x2-d0.5",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[[0.0, 0.0, 0.5], [0.0, 2.0, 0.5], [1.0, 2.0, 0.5], [1.0, 0.0, 0.5]],
        factor: 0.220_777_622_334_761_6,
    },
    Case {
        name: "A4-par-corner-1x1-d0.001",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [0.0, 0.0, 0.001],
            [0.0, 1.0, 0.001],
            [1.0, 1.0, 0.001],
            [1.0, 0.0, 0.001],
        ],
        factor: 0.249_999_795_422_701_8,
    },
    Case {
        name: "A4-par-corner-1000x1000-d1",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [0.0, 0.0, 1.0],
            [0.0, 1000.0, 1.0],
            [1000.0, 1000.0, 1.0],
            [1000.0, 0.0, 1.0],
        ],
        factor: 0.249_999_795_422_701_8,
    },
    Case {
        name: "A4-gen-tri",
        point: [0.1, 0.2, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]],
        factor: 0.118_954_620_611_068_53,
    },
    Case {
        name: "A4-gen-surrounding",
        point: [0.5, 0.5, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [-100.0, -100.0, 0.01],
            [-100.0, 101.0, 0.01],
            [101.0, 101.0, 0.01],
            [101.0, -100.0, 0.01],
        ],
        factor: 0.999_999_991_898_122_5,
    },
    Case {
        name: "A4-perp-corner-1x1-d1",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 0.0]],
        factor: 0.055_734_197_002_553_5,
    },
];

/// Cut by the horizon, touching it, or behind.
pub const CUT: &[Case] = &[
    Case {
        name: "A4-gen-horizon-cut",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [1.0, -1.0, -1.0],
            [1.0, -1.0, 1.0],
            [1.0, 1.0, 1.0],
            [1.0, 1.0, -1.0],
        ],
        factor: 0.111_468_394_005_107,
    },
    Case {
        name: "A4-gen-tri",
        point: [0.1, 0.2, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]],
        factor: 0.118_954_620_611_068_53,
    },
    Case {
        name: "A4-perp-corner-1x1-d0.001",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [0.001, 0.0, 0.0],
            [0.001, 0.0, 1.0],
            [0.001, 1.0, 1.0],
            [0.001, 1.0, 0.0],
        ],
        factor: 0.249_715_845_212_248_38,
    },
    Case {
        name: "A4-perp-corner-1000x1-d1",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [1.0, 0.0, 0.0],
            [1.0, 0.0, 1.0],
            [1.0, 1000.0, 1.0],
            [1.0, 1000.0, 0.0],
        ],
        factor: 0.073_223_304_650_311_57,
    },
    Case {
        name: "A4-gen-grazing",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        corners: &[
            [1.0, -1.0, 0.0],
            [1.0, -1.0, 0.001],
            [1.0, 1.0, 0.001],
            [1.0, 1.0, 0.0],
        ],
        factor: 2.045_772_982_186_271_9e-7,
    },
    Case {
        name: "A4-gen-behind",
        point: [0.0, 0.0, 0.0],
        normal: [0.0, 0.0, -1.0],
        corners: &[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]],
        factor: 0.0,
    },
];

//! Random numbers that are the same on every machine.

/// A linear congruential generator of 64 bits.
#[derive(Clone, Debug)]
pub(super) struct Draw(u64);

impl Default for Draw {
    fn default() -> Self {
        Self(12345)
    }
}

impl Draw {
    /// Returns a number between two others, each as likely.
    pub(super) fn even(&mut self, least: f64, most: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // The upper bits have the longest period.
        let share = (self.0 >> 32) as f64 / f64::from(u32::MAX);
        least + (most - least) * share
    }
}

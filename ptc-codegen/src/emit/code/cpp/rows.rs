//! The loops over the powers of a series.

use super::Cpp;

impl Cpp<'_> {
    /// The function that forms so many rows.
    pub(super) fn rows_function(&mut self, weights: usize) {
        let (real, tail) = (self.real_type(), weights - 1);
        let part = tail - 1;
        self.out.line(format!(
            "
/// Loops over the powers of the Taylor series of mu, for the gains of all states at once.
static constexpr std::array<{real}, {weights}> rows(
    std::array<{real}, {weights}> row, const std::array<{real}, {tail}>& p) noexcept
{{
    std::array<{real}, {part}> q{{}}; // p^2
    for (std::size_t k = 0U; k < {part}U; k++) {{
        {real} v = p[k] + p[k];
        for (std::size_t m = 0U; m < k; m++) {{
            v += p[m] * p[k - m - 1U];
        }}
        q[k] = v;
    }}
    for (std::size_t round = 0U; round < {tail}U; round += 2U) {{
        for (std::size_t k = round; k < {tail}U; k++) {{
            {real} v = row[k];
            for (std::size_t m = k + 1U; m < {weights}U; m++) {{
                v += ((k == round) ? p[m - k - 1U] : q[m - k - 1U]) * row[m];
            }}
            row[k] = v;
        }}
    }}
    return row;
}}"
        ));
    }
}

//! The loops over the powers of a series.

use super::C;
use crate::code::Shape;

impl C<'_> {
    /// The function that forms so many rows.
    pub(super) fn rows_function(&mut self, weights: usize) {
        let (name, real, tail) = (&self.code.name, self.type_of(Shape::Real), weights - 1);
        let part = tail - 1;
        self.out.line(format!(
            "
/* Loops over the powers of the Taylor series of mu, for the gains of all states at once. */
static void {name}_rows({real} row[{weights}], const {real} p[{tail}])
{{
    {real} q[{part}]; /* p^2 */

    for (uint32_t k = 0U; k < {part}U; k++) {{
        {real} v = p[k] + p[k];
        for (uint32_t m = 0U; m < k; m++) {{
            v += p[m] * p[k - m - 1U];
        }}
        q[k] = v;
    }}
    for (uint32_t round = 0U; round < {tail}U; round += 2U) {{
        for (uint32_t k = round; k < {tail}U; k++) {{
            const {real} *const f = (k == round) ? p : q;
            {real} v = row[k];
            for (uint32_t m = k + 1U; m < {weights}U; m++) {{
                v += f[m - k - 1U] * row[m];
            }}
            row[k] = v;
        }}
    }}
}}"
        ));
    }
}

//! The functions that files end with.

use super::Matlab;

/// A function that a file ends with where it is called.
pub(super) struct Helper {
    pub(super) name: &'static str,
    pub(super) text: &'static str,
}

/// There is no conditional expression, and real functions leave the real numbers silently.
pub(super) const HELPERS: [Helper; 5] = [
    Helper {
        name: "pick",
        text: "
function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
",
    },
    Helper {
        name: "real_sqrt",
        text: "
function r = real_sqrt(a)
if a >= 0
    r = sqrt(a);
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_log",
        text: "
function r = real_log(a)
if a >= 0
    r = log(a);
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_pow",
        text: "
function r = real_pow(a, b)
if a >= 0
    r = a ^ b;
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_atanh",
        text: "
function r = real_atanh(a)
if abs(a) <= 1
    r = atanh(a);
else
    r = a * NaN;
end
end
",
    },
];

impl Matlab<'_> {
    /// The function that forms so many rows.
    pub(super) fn row_sums(&self, weights: usize) -> String {
        let (real, tail) = (self.real_type(), weights - 1);
        let part = tail - 1;
        format!(
            "
% Loops over the powers of the Taylor series of mu, for the gains of all states at once.
function row = row_sums(row, p)
q = zeros(1, {part}, '{real}'); % p^2
for k = 1:{part}
    v = p(k) + p(k);
    for m = 1:(k - 1)
        v = v + (p(m) * p(k - m));
    end
    q(k) = v;
end
for first = 1:2:{tail}
    for k = first:{tail}
        v = row(k);
        for m = (k + 1):{weights}
            if k == first
                v = v + (p(m - k) * row(m));
            else
                v = v + (q(m - k) * row(m));
            end
        end
        row(k) = v;
    end
end
end
"
        )
    }
}

/// The function that solves so many equations.
pub(super) fn elimination(m: usize) -> String {
    format!(
        "
% Solves a x = b, with a row by row, by elimination with the largest pivot of each column. No numbers
% where a is singular.
function b = eliminate(a, b)
a = reshape(a, {m}, {m})';
for k = 1:{m}
    most = k;
    for i = (k + 1):{m}
        if abs(a(most, k)) < abs(a(i, k))
            most = i;
        end
    end
    a([k, most], :) = a([most, k], :);
    b([k, most]) = b([most, k]);
    if a(k, k) == 0
        a(k, k) = NaN;
    end
    for i = (k + 1):{m}
        factor = a(i, k) / a(k, k);
        for j = (k + 1):{m}
            a(i, j) = a(i, j) - (factor * a(k, j));
        end
        b(i) = b(i) - (factor * b(k));
    end
end
for k = {m}:-1:1
    for j = (k + 1):{m}
        b(k) = b(k) - (a(k, j) * b(j));
    end
    b(k) = b(k) / a(k, k);
end
end
"
    )
}

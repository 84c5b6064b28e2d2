//! The functions that files end with.

/// A function that a file ends with where it is called.
pub(super) struct Helper {
    pub(super) name: &'static str,
    pub(super) text: &'static str,
}

/// There is no conditional expression, and real functions leave the real numbers silently.
pub(super) const HELPERS: [Helper; 7] = [
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
    Helper {
        name: "real_asin",
        text: "
function r = real_asin(a)
if abs(a) <= 1
    r = asin(a);
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_acos",
        text: "
function r = real_acos(a)
if abs(a) <= 1
    r = acos(a);
else
    r = a * NaN;
end
end
",
    },
];

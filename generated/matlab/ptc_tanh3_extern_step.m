function [u, status] = ptc_tanh3_extern_step(self, t, x, pi0, after) %#codegen
%PTC_TANH3_EXTERN_STEP  u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = ptc_tanh3_extern_step(self, t, x, pi0, after), with self from ptc_tanh3_extern_init.
%   pi0(xi, t) is the user-defined law, a function handle; t is the stretched time kappa + t0.
%   after(x, t) gives u for t >= t0 + tau, a function handle.
%
%   status (int32); u is 0 on a negative one:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to u_max; wins over 1 and 3
%      3  after: the deadline is over: u is 0 or that of the user-defined law
%     -2  x or t not finite, or t before t0
%     -3  u not finite

u = 0.0;
status = int32(-2);
t = double(t);
x = double(x);
x1 = double(x(1));
x2 = double(x(2));
x3 = double(x(3));
if ~(isfinite(t) ...
        && (t >= self.t0) ...
        && isfinite(x1) ...
        && isfinite(x2) ...
        && isfinite(x3))
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
T = -late;
v1 = T * self.a;
v2 = self.f24 + (-v1);
unit = self.f29 * v2;
v3 = v1 * (1.0 / v2);
v4 = v3 - 1.0;
v5 = v4 * 0.5;
v6 = T * unit;
inv_r1 = 1.0 / v6;
v7 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666 * (unit * unit);
xi2 = x2 * v6;
xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
t_kappa = self.t0 + ((-real_log(T / (self.f16 - T))) / self.f22);
law = double(pi0([x1; xi2; xi3], t_kappa));
v8 = (((law * inv_r1) + ((-6.0) * v7 * x2)) * inv_r1) + ((-3.0) * ((v5 + v5) * unit) * x3);
v = v8 * inv_r1;
if past >= 0.0
    v = double(after(x, t));
end
if v > self.u_max
    u = self.u_max;
    status = int32(2);
elseif v < -self.u_max
    u = -self.u_max;
    status = int32(2);
elseif ~isfinite(v)
    status = int32(-3);
elseif late < self.hold_from
    u = v;
    status = int32(0);
elseif past >= 0.0
    u = v;
    status = int32(3);
else
    u = v;
    status = int32(1);
end
end
function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end

function r = real_log(a)
if a >= 0
    r = log(a);
else
    r = a * NaN;
end
end

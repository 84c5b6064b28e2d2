function [u, status] = ptc_exp3_f32_step(self, t, x) %#codegen
%PTC_EXP3_F32_STEP  u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = ptc_exp3_f32_step(self, t, x), with self from ptc_exp3_f32_init.
%
%   status (int32); u is 0 on a negative one:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to u_max; wins over 1 and 3
%      3  after: the deadline is over: u is 0 or that of the user-defined law
%     -2  x or t not finite, or t before t0
%     -3  u not finite

u = single(0.0);
status = int32(-2);
t = single(t);
x1 = single(x(1));
x2 = single(x(2));
x3 = single(x(3));
if ~(isfinite(t) ...
        && (t >= self.t0) ...
        && isfinite(x1) ...
        && isfinite(x2) ...
        && isfinite(x3))
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
inv_T = (-single(1.0)) / late;
v1 = (((self.c1 * x1 * inv_T) + (self.c2 * x2)) * inv_T) + (self.c3 * x3);
v = v1 * inv_T;
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

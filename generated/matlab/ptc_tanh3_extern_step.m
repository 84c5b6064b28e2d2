function [u, status] = ptc_tanh3_extern_step(self, t, x, pi0, after) %#codegen
%PTC_TANH3_EXTERN_STEP u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = ptc_tanh3_extern_step(self, t, x, pi0, after), with self from
%   ptc_tanh3_extern_init.
%   pi0, a function handle: User-defined law pi0(xi, t); t is the stretched time kappa + t0.
%   after, a function handle: User-defined law for t >= t0 + tau.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = 0.0;
t = double(t);
x = double(x);
x1 = x(1);
x2 = x(2);
x3 = x(3);
if ~(isfinite(t) && (t >= self.t0) && isfinite(x1) && isfinite(x2) && isfinite(x3))
    status = int32(-2);
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
xi2 = x2 * v6;
xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
t_kappa = self.t0 + ((-real_log(T / (self.f16 - T))) / self.f22);
xi = [x1; xi2; xi3];
law = double(pi0(xi, t_kappa));
if past >= 0.0
    applied = double(after(x, t));
else
    s1 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666;
    s2 = ((law * inv_r1) + ((-6.0) * (s1 * (unit * unit)) * x2)) * inv_r1;
    applied = (s2 + ((-3.0) * ((v5 + v5) * unit) * x3)) * inv_r1;
end
v = applied;
if isfinite(v)
    if v > self.u_max
        u = self.u_max;
        status = int32(2);
    elseif v < -self.u_max
        u = -self.u_max;
        status = int32(2);
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
else
    status = int32(-3);
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

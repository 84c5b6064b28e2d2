function [u, status] = ptc_exp3_f32_axis(gains, x) %#codegen
%PTC_EXP3_F32_AXIS  u of one axis from the gains of ptc_exp3_f32_tick.
%
%   [u, status] = ptc_exp3_f32_axis(gains, x); the status of the gains where that is negative.
%
%   status (int32); u is 0 on a negative one:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to u_max; wins over 1 and 3
%      3  after: the deadline is over: u is 0 or that of the user-defined law
%     -2  x or t not finite, or t before t0
%     -3  u not finite

u = single(0.0);
status = gains.status;
if status < 0
    return;
end
x1 = single(x(1));
x2 = single(x(2));
x3 = single(x(3));
if ~(isfinite(x1) ...
        && isfinite(x2) ...
        && isfinite(x3))
    status = int32(-2);
    return;
end
v1 = (gains.gain(1) * x1) + (gains.gain(2) * x2) + (gains.gain(3) * x3);
v = v1;
if v > gains.u_max
    u = gains.u_max;
    status = int32(2);
elseif v < -gains.u_max
    u = -gains.u_max;
    status = int32(2);
elseif isfinite(v)
    u = v;
else
    status = int32(-3);
end
end

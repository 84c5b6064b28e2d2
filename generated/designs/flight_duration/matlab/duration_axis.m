function [u, status] = duration_axis(gains, x) %#codegen
%DURATION_AXIS u of one axis from its state x = (x1, x1', ...) and the gains.
%
%   [u, status] = duration_axis(gains, x), with gains from duration_tick.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = single(0.0);
status = gains.status;
if status < 0
    return;
end
x = single(x);
s1 = (gains.gain(1) * x(1)) + (gains.gain(2) * x(2));
v = s1 + (gains.gain(3) * x(3));
if isfinite(v) && (abs(v) <= single(100.0))
    u = v;
    status = gains.status;
elseif isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3))
    if isfinite(v)
        if v > single(100.0)
            u = single(100.0);
            status = int32(2);
        else
            u = -single(100.0);
            status = int32(2);
        end
    else
        status = int32(-3);
    end
else
    status = int32(-2);
end
end

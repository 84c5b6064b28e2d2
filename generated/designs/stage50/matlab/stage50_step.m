function [u, status] = stage50_step(self, k, x, r) %#codegen
%STAGE50_STEP u from tick `k`, which may wrap, and the state x, and the reference.
%
%   [u, status] = stage50_step(self, k, x, r), with self from stage50_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

samples = uint32(20); % samples from the start to rest
% Gains of least energy of each state, a row for the samples to go of a node.
gains = [
    -6519.426971737549, 3185.2084972182897;
    -3857.2972468681514, 1869.370005740587;
    -2535.8123523502322, 1218.7874484331383;
    -1786.1499004408652, 851.2162504195531;
    -1321.0288432240525, 624.1015587650261;
    -1013.2253140462395, 474.4353779733671;
    -799.355679292144, 370.8885689114117;
    -644.9715751559836, 296.46788779068544;
    -530.0507637726341, 241.31624608777554;
    -442.31657026726884, 199.40198143585195;
    -373.9055837746926, 166.86960699606502;
    -319.59468864669316, 141.16347188259604;
    -275.80616425447823, 120.53665432938753;
    -240.02385825378445, 103.76315424562416;
    -210.4372644374064, 89.96267023338274;
    -185.7172734991974, 78.4903488691879;
    -164.8707644351536, 68.86539241539502;
    -147.1439010804336, 60.72364441333584;
    -131.95635856841344, 53.785384714229195;
    -118.85567957234355, 47.83301161237331;
];
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
r = double(r);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(r(1)) && isfinite(r(2)) && isfinite(r(3)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);

% The tracking error.
s1 = (0.3333333333333333 * r(1)) - (0.9983333333333333 * r(2));
u_r = s1 - (0.3383277777777778 * r(3));
e1 = x1 - (((-1.3333333333333333) * r(1)) - (0.3333333333333333 * r(2)));
e2 = x2 - (((-1.6666666666666667) * r(1)) - (0.6666666666666666 * r(2)));
left = samples - elapsed;
if left > uint32(2)
    to_go = left;
else
    to_go = uint32(2);
end
row = uint32(mod(double(to_go) - double(uint32(2)), 4294967296));

% The law of least energy.
v = (gains(row + 1, 1) * e1) + (gains(row + 1, 2) * e2) + u_r;
if isfinite(v)
    if v > self.u_max
        u = self.u_max;
        status = int32(2);
    elseif v < -self.u_max
        u = -self.u_max;
        status = int32(2);
    elseif elapsed < samples
        u = v;
        status = int32(0);
    else
        u = v;
        status = int32(1);
    end
else
    status = int32(-3);
end
end

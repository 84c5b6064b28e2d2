function self = table_too_soon_init(params) %#codegen
%TABLE_TOO_SOON_INIT Takes the parameters and arms at tick 0.
%
%   self = table_too_soon_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error table_too_soon:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: upper limit of u [unit of u], > u_min, infinity allowed
%     u_min: lower limit of u [unit of u], < u_max, -infinity allowed

% Prescribed-time controller table_too_soon: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01
% Version 0.1.0, design ed84b87c488b.
%
% Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. From 8 samples to go on these
%       are M - 2 and the exponents 3, 4, 5, those of least energy. The gains of 3 samples to
%       go stay: they are deadbeat.
% Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
%       on time once.
%   axis 1: k = 60, 47, 12
%   axis 2: k = 120, 74, 15
%
% Parameters:
%   samples = 150 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: upper limit of u
%   u_min [unit of u]: lower limit of u
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
%       so their Bernstein coefficients, linear in z, bound them. If these are within the
%       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
%       plant and state are as they are known.
% Axes: all come to rest at the same sample, and each deadline is tested for every one of
%       them.
% late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
% u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
%       deadline where it lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
%       bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = double(params.u_max);
given.u_min = double(params.u_min);
if ~(given.u_min < given.u_max)
    error('table_too_soon:param', 'params.u_min is %g; legal: < u_max', params.u_min);
end
u_max = given.u_max;
u_min = given.u_min;
self.start = uint32(0);
self.last = uint32(150);
self.u_max = u_max;
self.u_min = u_min;
end

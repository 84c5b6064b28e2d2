function self = gantry_in_flight_arm_for(self, k, samples) %#codegen
%GANTRY_IN_FLIGHT_ARM_FOR Another deadline, at any tick before the call of `step` at it: rest at
%tick `k` + `samples`, 2 to 2147483648 samples.
%
%   self = gantry_in_flight_arm_for(self, k, samples), with self from gantry_in_flight_init. Keep
%   self: it is what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('gantry_in_flight:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
samples = double(samples);
if ~(isfinite(samples) && (samples == floor(samples)))
    error('gantry_in_flight:param', 'samples is %g; legal: whole', samples);
end
samples = uint32(mod(samples, 4294967296));
if ~((samples > uint32(1)) && (samples < uint32(2147483649)))
    error('gantry_in_flight:param', 'k and samples, and what follows, must be finite');
end
self.start = k;
self.last = samples;
end

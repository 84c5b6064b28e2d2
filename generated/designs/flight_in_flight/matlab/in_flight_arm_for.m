function self = in_flight_arm_for(self, k, samples) %#codegen
%IN_FLIGHT_ARM_FOR Another deadline, at any tick before the call of `step` at it: rest at tick `k` +
%`samples`, 3 to 300 samples. Estimates and inputs under way are kept.
%
%   self = in_flight_arm_for(self, k, samples), with self from in_flight_init. Keep self: it is what
%   the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('in_flight:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
samples = double(samples);
if ~(isfinite(samples) && (samples == floor(samples)))
    error('in_flight:param', 'samples is %g; legal: whole', samples);
end
samples = uint32(mod(samples, 4294967296));
if ~((samples > uint32(2)) && (samples < uint32(301)))
    error('in_flight:param', 'k and samples, and what follows, must be finite');
end
self.start = k;
self.last = samples;
end

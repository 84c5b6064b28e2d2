function self = late_stage_arm_for(self, k, samples) %#codegen
%LATE_STAGE_ARM_FOR Another deadline, at any tick before the call of `step` at it: rest at tick `k`
%+ `samples`, 3 to 2147483648 samples. Estimates and inputs under way are kept.
%
%   self = late_stage_arm_for(self, k, samples), with self from late_stage_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('late_stage:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
samples = double(samples);
if ~(isfinite(samples) && (samples == floor(samples)))
    error('late_stage:param', 'samples is %g; legal: whole', samples);
end
samples = uint32(mod(samples, 4294967296));
if ~((samples > uint32(2)) && (samples < uint32(2147483649)))
    error('late_stage:param', 'k and samples, and what follows, must be finite');
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
self.round = self.round - elapsed;
self.start = k;
self.last = samples;
end

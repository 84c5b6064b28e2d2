function self = motor_late_arm_for(self, k, samples) %#codegen
%MOTOR_LATE_ARM_FOR Another deadline, at any tick before the call of `step` at it: rest at tick `k`
%+ `samples`, 2 to 80 samples.
%
%   self = motor_late_arm_for(self, k, samples), with self from motor_late_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('motor_late:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
samples = double(samples);
if ~(isfinite(samples) && (samples == floor(samples)))
    error('motor_late:param', 'samples is %g; legal: whole', samples);
end
samples = uint32(mod(samples, 4294967296));
if ~((samples > uint32(1)) && (samples < uint32(81)))
    error('motor_late:param', 'k and samples, and what follows, must be finite');
end
self.start = k;
self.last = samples;
end

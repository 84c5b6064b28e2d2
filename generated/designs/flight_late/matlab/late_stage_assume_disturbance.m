function self = late_stage_assume_disturbance(self, d) %#codegen
%LATE_STAGE_ASSUME_DISTURBANCE The constant that is added to u is known.
%
%   self = late_stage_assume_disturbance(self, d), with self from late_stage_init. Keep self: it is
%   what the next call needs.

d = double(d);
if ~isfinite(d)
    error('late_stage:param', 'd, and what follows, must be finite');
end
self.d_hat = d;
end

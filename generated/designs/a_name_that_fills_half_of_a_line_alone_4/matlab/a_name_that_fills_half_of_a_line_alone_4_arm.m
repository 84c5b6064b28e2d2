function self = a_name_that_fills_half_of_a_line_alone_4_arm(self, k) %#codegen
%A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_ARM Starts again: the deadline is N samples after tick
%`k`. Estimates and inputs under way are kept. Estimates too large to compute with begin anew.
%
%   self = a_name_that_fills_half_of_a_line_alone_4_arm(self, k), with self from
%   a_name_that_fills_half_of_a_line_alone_4_init. Keep self: it is what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
size = abs(self.x1_hat) + abs(self.x2_hat) + abs(self.d_hat);
if ~(size <= single(9.999999843067494e17))
    self.seen = uint32(0);
    self.x1_hat = single(0.0);
    self.x2_hat = single(0.0);
    self.d_hat = single(0.0);
end
end

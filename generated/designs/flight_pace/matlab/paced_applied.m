function self = paced_applied(self, u) %#codegen
%PACED_APPLIED The drive applied `u` in place of the u that the last call of `step` gave.
%
%   self = paced_applied(self, u), with self from paced_init. Keep self: it is what the next call
%   needs.

u = double(u);
if ~isfinite(u)
    error('paced:param', 'u, and what follows, must be finite');
end
self.u1 = u;
end

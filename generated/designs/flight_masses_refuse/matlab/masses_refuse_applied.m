function self = masses_refuse_applied(self, u) %#codegen
%MASSES_REFUSE_APPLIED The drive applied `u` in place of the u that the last call of `step` gave.
%
%   self = masses_refuse_applied(self, u), with self from masses_refuse_init. Keep self: it is what
%   the next call needs.

u = single(u);
if ~isfinite(u)
    error('masses_refuse:param', 'u, and what follows, must be finite');
end
self.u1 = u;
end

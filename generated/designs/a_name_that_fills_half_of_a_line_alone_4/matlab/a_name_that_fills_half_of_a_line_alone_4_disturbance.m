function d = a_name_that_fills_half_of_a_line_alone_4_disturbance(self) %#codegen
%A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_DISTURBANCE The estimate of the constant that is added to
%u.
%
%   d = a_name_that_fills_half_of_a_line_alone_4_disturbance(self), with self from
%   a_name_that_fills_half_of_a_line_alone_4_init.

d = self.d_hat;
end

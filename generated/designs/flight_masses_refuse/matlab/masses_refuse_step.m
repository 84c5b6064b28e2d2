function [u, status, self] = masses_refuse_step(self, k, y) %#codegen
%MASSES_REFUSE_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for
%each tick.
%
%   [u, status, self] = masses_refuse_step(self, k, y), with self from masses_refuse_init. Keep
%   self: it is what the next call needs.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite
%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid

gamma1 = single(0.0019801282323896885); % prediction from u
gamma2 = single(0.3933916389942169); % prediction from u
phi1_1 = single(0.9801987409591675); % prediction of x1 from x1
phi1_2 = single(0.009834791533648968); % prediction of x1 from x2
phi1_3 = single(0.0019801282323896885); % prediction of x1 from d
phi2_1 = -single(3.9339165687561035); % prediction of x2 from x1
phi2_2 = single(0.9605291485786438); % prediction of x2 from x2
phi2_3 = single(0.3933916389942169); % prediction of x2 from d
u_max = single(10.0); % bound of |u|
hold = single(4.0); % samples to go at which the gains are held
% Gains of least energy of each state, a row for the samples to go of a node.
gains = [
    -single(243.35171508789063), -single(3.7084169387817383);
    -single(141.9797821044922), -single(2.9401590824127197);
    -single(91.20574188232422), -single(2.4207398891448975);
    -single(62.17210388183594), -single(2.043832540512085);
    -single(44.04502487182617), -single(1.7562148571014404);
    -single(32.004539489746094), -single(1.5283414125442505);
    -single(23.638628005981445), -single(1.3425357341766357);
    -single(17.630842208862305), -single(1.1876156330108643);
    -single(13.212915420532227), -single(1.0562031269073486);
    -single(9.911792755126953), -single(0.9432744383811951);
    -single(7.422871112823486), -single(0.8453300595283508);
    -single(5.5421552658081055), -single(0.7598929405212402);
    -single(4.127859115600586), -single(0.6851881146430969);
    -single(3.077610731124878), -single(0.6199269890785217);
    -single(2.3143727779388428), -single(0.5631508231163025);
    -single(1.7775028944015503), -single(0.5141103267669678);
    -single(1.4170575141906738), -single(0.47216737270355225);
    -single(1.1902987957000732), -single(0.43671441078186035);
    -single(1.0598119497299194), -single(0.40711265802383423);
    -single(0.9928262233734131), -single(0.38265344500541687);
    -single(0.961367666721344), -single(0.36254745721817017);
    -single(0.9428455829620361), -single(0.3459436297416687);
    -single(0.9206554889678955), -single(0.3319735825061798);
    -single(0.8844346404075623), -single(0.3198114335536957);
    -single(0.8297522068023682), -single(0.30873435735702515);
    -single(0.7572070956230164), -single(0.29817086458206177);
    -single(0.6710845828056335), -single(0.287727028131485);
    -single(0.5778211355209351), -single(0.277188241481781);
    -single(0.4845329821109772), -single(0.2664996385574341);
    -single(0.397799015045166), -single(0.255731999874115);
    -single(0.3227975368499756), -single(0.24504047632217407);
    -single(0.26281481981277466), -single(0.23462259769439697);
    -single(0.21909138560295105), -single(0.22468027472496033);
    -single(0.1909458488225937), -single(0.21538858115673065);
    -single(0.17610926926136017), -single(0.20687289535999298);
    -single(0.1712028831243515), -single(0.19919534027576447);
    -single(0.17229171097278595), -single(0.19235064089298248);
    -single(0.17544570565223694), -single(0.1862710416316986);
    -single(0.17724139988422394), -single(0.1808389574289322);
    -single(0.17514435946941376), -single(0.1759052723646164);
    -single(0.16773009300231934), -single(0.17131026089191437);
    -single(0.15472637116909027), -single(0.1669042408466339);
    -single(0.1368882656097412), -single(0.16256463527679443);
    -single(0.11574309319257736), -single(0.15820758044719696);
    -single(0.09325820952653885), -single(0.1537928432226181);
    -single(0.07149021327495575), -single(0.1493222564458847);
    -single(0.05226771533489227), -single(0.14483270049095154);
    -single(0.03694715350866318), -single(0.1403852105140686);
    -single(0.026264861226081848), -single(0.13605226576328278);
    -single(0.020292852073907852), -single(0.13190510869026184);
    -single(0.0184917151927948), -single(0.12800250947475433);
    -single(0.019843269139528275), -single(0.12438271939754486);
    -single(0.02303757332265377), -single(0.12105878442525864);
    -single(0.026684250682592392), -single(0.11801806837320328);
    -single(0.029516909271478653), -single(0.1152253970503807);
    -single(0.0305622685700655), -single(0.1126292273402214);
    -single(0.029252268373966217), -single(0.11016971617937088);
    -single(0.02546718530356884), -single(0.10778737813234329);
    -single(0.01950901560485363), -single(0.10543103516101837);
    -single(0.012015164829790592), -single(0.10306379944086075);
    -single(0.003830650122836232), -single(0.1006666049361229);
    single(0.0041383313946425915), -single(0.09823879599571228);
    single(0.011066225357353687), -single(0.09579602628946304);
    single(0.019562795758247375), -single(0.09098326414823532);
    single(0.020080504938960075), -single(0.08649327605962753);
    single(0.015360569581389427), -single(0.08251944929361343);
    single(0.010357260704040527), -single(0.07907681912183762);
    single(0.009222333319485188), -single(0.07600829005241394);
    single(0.013146717101335526), -single(0.073085255920887);
    single(0.020137876272201538), -single(0.07013504952192307);
    single(0.026595359668135643), -single(0.06712103635072708);
    single(0.029559941962361336), -single(0.06413745135068893);
];
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = single(0.0);
    d = single(0.0);
else
    x1 = self.x1_next + (gamma1 * self.u2);
    x2 = self.x2_next + (gamma2 * self.u2);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
l1 = single(3.7391629219055176);
l2 = single(356.9181213378906);
l3 = single(456.6236877441406);
s1 = (phi1_1 * x1) + (phi1_2 * x2);
x1_on = s1 + (phi1_3 * d) + (l1 * off1);
s2 = (phi2_1 * x1) + (phi2_2 * x2);
x2_on = s2 + (phi2_3 * d) + (l2 * off1);
d_on = d + (l3 * off1);
left = self.last - elapsed;
planned = left - uint32(1);
if planned > uint32(4)
    to_go = planned;
else
    to_go = uint32(4);
end

% Its place between the nodes of the table.
if to_go < uint32(64)
    row = uint32(mod(double(to_go) - double(uint32(2)), 4294967296));
    part = single(0.0);
else
    row = bitshift(to_go, -1) + uint32(30);
    part = (single(0.5) * single(to_go)) - single(bitshift(to_go, -1));
end

% The state from which this input acts.
s3 = (single(0.9801987409591675) * x1) + (single(0.009834791533648968) * x2);
p1 = s3 + (single(0.0019801282323896885) * (self.u1 + d));
s4 = ((-single(3.9339165687561035)) * x1) + (single(0.9605291485786438) * x2);
p2 = s4 + (single(0.3933916389942169) * (self.u1 + d));

% The law of least energy.
above = row + uint32(1);
s5 = part * (gains(above + 1, 1) - gains(row + 1, 1));
s6 = part * (gains(above + 1, 2) - gains(row + 1, 2));
s7 = (gains(row + 1, 1) + s5) * p1;
v = (s7 + ((gains(row + 1, 2) + s6) * p2)) - d;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(d_on))
    status = int32(-3);
    return;
end
if v > u_max
    u_now = u_max;
elseif v < -u_max
    u_now = -u_max;
else
    u_now = v;
end
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.d_hat = d;
self.d_next = d_on;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
    u = u_now;
    status = int32(2);
elseif single(left) - single(1.0) <= hold
    u = u_now;
    status = int32(1);
else
    u = u_now;
    status = int32(0);
end
end

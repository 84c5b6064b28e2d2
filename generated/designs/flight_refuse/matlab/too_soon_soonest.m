function [samples, status] = too_soon_soonest(self, x) %#codegen
%TOO_SOON_SOONEST The fewest samples found, from the next call of `step` on, with which the law
%keeps u and the states within their limits at every sample to rest, from the state x, for sure.
%Give them to `arm_for`.
%
%   [samples, status] = too_soon_soonest(self, x), with self from too_soon_init.
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
%     -4  there is none

s1_1 = single(1000000.0); % weight of x1 in the law
s1_2 = -single(10000.0); % weight of x2 in the law
s1_3 = single(33.33333206176758); % 100/3, weight of x3 in the law
s2_2 = single(10000.0); % weight of x2 in the law
s2_3 = -single(50.0); % weight of x3 in the law
s3_3 = single(100.0); % weight of x3 in the law
u_max = single(20.0); % bound of |u|
samples = uint32(0);
x = single(x);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3)))
    status = int32(-2);
    return;
end
x1 = x(1);
x2 = x(2);
x3 = x(3);
flat1 = (s1_1 * x1) + (s1_2 * x2) + (s1_3 * x3);
flat2 = (s2_2 * x2) + (s2_3 * x3);
flat3 = s3_3 * x3;
low = uint32(3);
top = uint32(100001);
kept = uint32(0);
tried = uint32(4);
for attempt = 0:63
    least = single(0.9949458837509155) * (-u_max);
    most = single(0.9949458837509155) * u_max;
    most2 = single(0.49747294187545776);
    most3 = single(3.979783535003662);
    fits = uint32(0);
    m = single(tried);
    power1 = m + single(3.0);
    power2 = power1 * (m + single(2.0));
    power3 = power2 * (m + single(1.0));
    power4 = power3 * m;
    power5 = power4 * (m - single(1.0));
    power6 = power5 * (m - single(2.0));
    scaled2 = flat2 * power1;
    scaled3 = flat3 * power2;
    w1 = ((single(15.0) * flat1) + (single(5.0) * scaled2) + (single(0.5) * scaled3)) / power4;
    w2 = ((((-single(24.0)) * flat1) - (single(9.0) * scaled2)) - scaled3) / power5;
    w3 = ((single(10.0) * flat1) + (single(4.0) * scaled2) + (single(0.5) * scaled3)) / power6;
    length = m - single(4.0);
    b0_c = (((-single(96.0)) * w1) - (single(720.0) * w2)) - (single(2880.0) * w3);
    b1_c = ((((-single(24.0)) * w1) - (single(420.0) * w2)) - (single(3120.0) * w3)) * length;
    b2_l = length * length;
    b2_c = (((-single(60.0)) * w2) - (single(1080.0) * w3)) * b2_l;
    b3_l = b2_l * length;
    b3_c = (-single(120.0)) * w3 * b3_l;
    b1 = b0_c + (single(0.1428571492433548) * b1_c);
    b2 = b0_c + (single(0.2857142984867096) * b1_c) + (single(0.0476190485060215) * b2_c);
    s10 = b0_c + (single(0.4285714328289032) * b1_c) + (single(0.1428571492433548) * b2_c);
    b3 = s10 + (single(0.02857142873108387) * b3_c);
    s11 = b0_c + (single(0.5714285969734192) * b1_c) + (single(0.2857142984867096) * b2_c);
    b4 = s11 + (single(0.11428571492433548) * b3_c);
    s12 = b0_c + (single(0.7142857313156128) * b1_c) + (single(0.4761904776096344) * b2_c);
    b5 = s12 + (single(0.2857142984867096) * b3_c);
    s13 = b0_c + (single(0.8571428656578064) * b1_c) + (single(0.7142857313156128) * b2_c);
    b6 = s13 + (single(0.5714285969734192) * b3_c);
    b7 = b0_c + b1_c + b2_c + b3_c;
    s0_c = (((-single(0.035999998450279236)) * w1) - (single(0.11999999731779099) * w2)) - (single(0.25200000405311584) * w3);
    s1_c = ((((-single(0.02419999986886978)) * w1) - (single(0.12399999797344208) * w2)) - (single(0.3953999876976013) * w3)) * length;
    s2_l = length * length;
    s2_c = ((((-single(0.005400000140070915)) * w1) - (single(0.04749999940395355) * w2)) - (single(0.24150000512599945) * w3)) * s2_l;
    s3_l = s2_l * length;
    s3_c = ((((-single(0.00039999998989515007)) * w1) - (single(0.00800000037997961) * w2)) - (single(0.07199999690055847) * w3)) * s3_l;
    s4_l = s3_l * length;
    s4_c = (((-single(0.0005000000237487257)) * w2) - (single(0.010499999858438969) * w3)) * s4_l;
    s5_l = s4_l * length;
    s5_c = (-single(0.0006000000284984708)) * w3 * s5_l;
    s1 = s0_c + (single(0.1111111119389534) * s1_c);
    s2 = s0_c + (single(0.2222222238779068) * s1_c) + (single(0.02777777798473835) * s2_c);
    s14 = s0_c + (single(0.3333333432674408) * s1_c) + (single(0.0833333358168602) * s2_c);
    s3 = s14 + (single(0.011904762126505375) * s3_c);
    s15 = s0_c + (single(0.4444444477558136) * s1_c) + (single(0.1666666716337204) * s2_c);
    s4 = s15 + (single(0.0476190485060215) * s3_c) + (single(0.007936508394777775) * s4_c);
    s16 = s0_c + (single(0.5555555820465088) * s1_c) + (single(0.2777777910232544) * s2_c);
    s17 = s16 + (single(0.1190476194024086) * s3_c) + (single(0.0396825410425663) * s4_c);
    s5 = s17 + (single(0.007936508394777775) * s5_c);
    s18 = s0_c + (single(0.6666666865348816) * s1_c) + (single(0.4166666567325592) * s2_c);
    s19 = s18 + (single(0.2380952388048172) * s3_c) + (single(0.1190476194024086) * s4_c);
    s6 = s19 + (single(0.0476190485060215) * s5_c);
    s20 = s0_c + (single(0.7777777910232544) * s1_c) + (single(0.5833333134651184) * s2_c);
    s21 = s20 + (single(0.4166666567325592) * s3_c) + (single(0.2777777910232544) * s4_c);
    s7 = s21 + (single(0.1666666716337204) * s5_c);
    s22 = s0_c + (single(0.8888888955116272) * s1_c) + (single(0.7777777910232544) * s2_c);
    s23 = s22 + (single(0.6666666865348816) * s3_c) + (single(0.5555555820465088) * s4_c);
    s8 = s23 + (single(0.4444444477558136) * s5_c);
    s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
    v0_c = (single(2.4000000953674316) * w1) + (single(12.0) * w2) + (single(36.0) * w3);
    v1_c = ((single(1.0800000429153442) * w1) + (single(9.399999618530273) * w2) + (single(46.20000076293945) * w3)) * length;
    v2_l = length * length;
    v2_c = ((single(0.11999999731779099) * w1) + (single(2.4000000953674316) * w2) + (single(21.299999237060547) * w3)) * v2_l;
    v3_l = v2_l * length;
    v3_c = ((single(0.20000000298023224) * w2) + (single(4.199999809265137) * w3)) * v3_l;
    v4_l = v3_l * length;
    v4_c = single(0.30000001192092896) * w3 * v4_l;
    v1 = v0_c + (single(0.125) * v1_c);
    v2 = v0_c + (single(0.25) * v1_c) + (single(0.0357142873108387) * v2_c);
    s24 = v0_c + (single(0.375) * v1_c) + (single(0.1071428582072258) * v2_c);
    v3 = s24 + (single(0.01785714365541935) * v3_c);
    s25 = v0_c + (single(0.5) * v1_c) + (single(0.2142857164144516) * v2_c) + (single(0.0714285746216774) * v3_c);
    v4 = s25 + (single(0.014285714365541935) * v4_c);
    s26 = v0_c + (single(0.625) * v1_c) + (single(0.3571428656578064) * v2_c) + (single(0.1785714328289032) * v3_c);
    v5 = s26 + (single(0.0714285746216774) * v4_c);
    s27 = v0_c + (single(0.75) * v1_c) + (single(0.5357142686843872) * v2_c) + (single(0.3571428656578064) * v3_c);
    v6 = s27 + (single(0.2142857164144516) * v4_c);
    s28 = v0_c + (single(0.875) * v1_c) + (single(0.75) * v2_c) + (single(0.625) * v3_c);
    v7 = s28 + (single(0.5) * v4_c);
    v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
    if (least <= b0_c) ...
        && (b0_c <= most) ...
        && (least <= b1) ...
        && (b1 <= most) ...
        && (least <= b2) ...
        && (b2 <= most) ...
        && (least <= b3) ...
        && (b3 <= most) ...
        && (least <= b4) ...
        && (b4 <= most) ...
        && (least <= b5) ...
        && (b5 <= most) ...
        && (least <= b6) ...
        && (b6 <= most) ...
        && (least <= b7) ...
        && (b7 <= most) ...
        && (-most2 <= s0_c) ...
        && (s0_c <= most2) ...
        && (-most2 <= s1) ...
        && (s1 <= most2) ...
        && (-most2 <= s2) ...
        && (s2 <= most2) ...
        && (-most2 <= s3) ...
        && (s3 <= most2) ...
        && (-most2 <= s4) ...
        && (s4 <= most2) ...
        && (-most2 <= s5) ...
        && (s5 <= most2) ...
        && (-most2 <= s6) ...
        && (s6 <= most2) ...
        && (-most2 <= s7) ...
        && (s7 <= most2) ...
        && (-most2 <= s8) ...
        && (s8 <= most2) ...
        && (-most2 <= s9) ...
        && (s9 <= most2) ...
        && (-most3 <= v0_c) ...
        && (v0_c <= most3) ...
        && (-most3 <= v1) ...
        && (v1 <= most3) ...
        && (-most3 <= v2) ...
        && (v2 <= most3) ...
        && (-most3 <= v3) ...
        && (v3 <= most3) ...
        && (-most3 <= v4) ...
        && (v4 <= most3) ...
        && (-most3 <= v5) ...
        && (v5 <= most3) ...
        && (-most3 <= v6) ...
        && (v6 <= most3) ...
        && (-most3 <= v7) ...
        && (v7 <= most3) ...
        && (-most3 <= v8) ...
        && (v8 <= most3) ...
        && (abs((((-single(72.0)) * w1) - (single(360.0) * w2)) - (single(720.0) * w3)) <= most) ...
        && (abs(((-single(48.0)) * w1) - (single(120.0) * w2)) <= most) ...
        && (abs((-single(24.0)) * w1) <= most) ...
        && (abs((((-single(0.01679999940097332)) * w1) - (single(0.035999998450279236) * w2)) - (single(0.035999998450279236) * w3)) <= most2) ...
        && (abs((((-single(0.006000000052154064)) * w1) - (single(0.006000000052154064) * w2)) + (single(4.87890977618477e-18) * w3)) <= most2) ...
        && (abs(((-single(0.0012000000569969416)) * w1) + (single(4.87890977618477e-18) * w2) + (single(4.87890977618477e-18) * w3)) <= most2) ...
        && (abs((single(1.440000057220459) * w1) + (single(4.800000190734863) * w2) + (single(7.199999809265137) * w3)) <= most3) ...
        && (abs(((single(0.7200000286102295) * w1) + (single(1.2000000476837158) * w2)) - (single(1.2490009027033011e-15) * w3)) <= most3) ...
        && (abs((single(0.23999999463558197) * w1) + (single(2.914335439641036e-15) * w2) + (single(3.747002708109903e-15) * w3)) <= most3)
        fits = uint32(1);
    end
    if fits == uint32(1)
        kept = tried;
        top = tried;
    else
        low = tried;
    end
    gap = top - low;
    if gap < uint32(2)
        break;
    end
    half = bitshift(gap, -1);
    if low < half
        tried = low + low;
    else
        tried = low + half;
    end
end
if isfinite(flat1) && isfinite(flat2) && isfinite(flat3)
    if kept > uint32(0)
        samples = kept;
        status = int32(0);
    else
        status = int32(-4);
    end
else
    status = int32(-3);
end
end

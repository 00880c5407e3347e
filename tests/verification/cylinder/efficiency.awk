# Capture efficiency of a cylinder in potential flow, linear drag, by bisection over trajectories
# (Runge-Kutta of fourth order, in the radius of the cylinder and the speed far away)
#
#   awk -v stk= [-v x0=-20] [-v R=0.05] -f efficiency.awk
#
# stk: tau U/D_c. R: diameter of particle over that of cylinder. Start: at x0 with the speed of
# the gas on the axis there.
function f(x, y, u, v, d,    r4, s)
{
    r4 = (x*x + y*y)^2; s = x*x - y*y
    d[0] = u; d[1] = v; d[2] = (1 - s/r4 - u)/tau; d[3] = (-2*x*y/r4 - v)/tau
}
function caught(y,    x, u, v, h, a, b, c, d, r)
{
    x = x0; u = 1 - 1/x0^2; v = 0
    while (x < 1.2)
    {
        r = sqrt(x*x + y*y)
        if (r < 1 + R) return 1
        h = 0.002*r; if (h > 0.2*tau) h = 0.2*tau
        f(x, y, u, v, a)
        f(x + h/2*a[0], y + h/2*a[1], u + h/2*a[2], v + h/2*a[3], b)
        f(x + h/2*b[0], y + h/2*b[1], u + h/2*b[2], v + h/2*b[3], c)
        f(x + h*c[0], y + h*c[1], u + h*c[2], v + h*c[3], d)
        x += h/6*(a[0] + 2*b[0] + 2*c[0] + d[0]); y += h/6*(a[1] + 2*b[1] + 2*c[1] + d[1])
        u += h/6*(a[2] + 2*b[2] + 2*c[2] + d[2]); v += h/6*(a[3] + 2*b[3] + 2*c[3] + d[3])
    }
    return 0
}
BEGIN {
    if (!x0) x0 = -20
    if (!R) R = 0.05
    tau = 2*stk
    low = 0; high = 1.2
    while (high - low > 1e-6) { middle = (low + high)/2; if (caught(middle)) low = middle; else high = middle }
    printf "%.5f\n", low
}

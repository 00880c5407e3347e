# 0/U from the centres of cells and faces in 0/C, by a closed form
#
#   awk -f gas.awk -v flow=stagnation|slip|channel|plug|kuwabara|potential|hollow -v unit= -v speed= [-v size=] 0/C > 0/U
#
# unit: metres of one length of the form. size: height of the channel, radius of the outer
# cylinder, of the hollow, in these lengths.
function velocity(x, y,    r, f, g, c, s)
{
    if (flow == "hollow")
    {
        f = 1 - (x*x + y*y)/size^2
        return sprintf("(%.17g %.17g 0)", -speed*f*x*(f - 4*y*y/size^2), speed*f*y*(f - 4*x*x/size^2))
    }
    if (flow == "stagnation") return sprintf("(%.17g %.17g 0)", speed*2*x*y, -speed*y*y)
    if (flow == "slip") return sprintf("(%.17g %.17g 0)", speed*x, -speed*y)
    if (flow == "plug") return sprintf("(%.17g 0 0)", speed)
    if (flow == "channel") return sprintf("(%.17g 0 0)", speed*4*y/size*(1 - y/size))

    if (flow == "potential")
    {
        r = x*x + y*y
        return sprintf("(%.17g %.17g 0)", speed*(1 - (x*x - y*y)/r^2), -speed*2*x*y/r^2)
    }

    # Kuwabara 1959: psi = speed sin(angle) r f(r)/(2 Ku)
    r = sqrt(x*x + y*y); c = x/r; s = y/r
    f = 2*log(r) - 1 + alpha + (1 - alpha/2)/r^2 - alpha/2*r^2
    g = 2 - 2*(1 - alpha/2)/r^2 - alpha*r^2
    return sprintf("(%.17g %.17g 0)", speed/(2*Ku)*(c*c*f + s*s*(f + g)), speed/(2*Ku)*c*s*(f - f - g))
}
BEGIN { slips = flow == "slip" || flow == "potential"; alpha = size ? 1/size^2 : 0; if (flow == "kuwabara") Ku = -log(alpha)/2 - 0.75 + alpha - alpha^2/4 }
/^ *(class|object) / { sub(/object +C/, "object U") }
/^dimensions/ { print "dimensions [0 1 -1 0 0 0 0];"; next }
/^ *(open|wall)$/ { patch = $1 }
/type +/ && patch == "open" { print "type fixedValue;"; next }
/type +/ && patch == "wall" { print slips ? "type fixedValue;" : "type noSlip;"; next }
/^\(-?[0-9]/ && NF == 3 {
    gsub(/[()]/, "")
    x = $1/unit; y = $2/unit
    if (patch == "wall" && flow == "potential") { r = sqrt(x*x + y*y); x /= r; y /= r }
    print patch == "wall" && !slips ? "(0 0 0)" : velocity(x, y)
    next
}
{ print }

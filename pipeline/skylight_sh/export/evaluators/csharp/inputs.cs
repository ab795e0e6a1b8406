using System;
using Real = System.Single;

public static partial class SkylightSh
{
    // The status of inputs, one an axis, and an azimuth; where it is not Invalid, `x` holds the values within their
    // ranges.
    static int ClampInputs(ReadOnlySpan<float> inputs, float azimuth, Span<Real> x)
    {
        bool strange = float.IsNaN(azimuth) || float.IsInfinity(azimuth);
        for (int axis = 0; axis < AxisCount; ++axis) strange |= float.IsNaN(inputs[axis]);
        if (strange) return Invalid;
        int status = Ok;
        for (int axis = 0; axis < AxisCount; ++axis)
        {
            float v = inputs[axis];
            if (v < Inside[2 * axis] || v > Inside[2 * axis + 1]) status = Clamped;
            x[axis] = Math.Min(Math.Max(v, Range[2 * axis]), Range[2 * axis + 1]);
        }
        return status;
    }
#if SKYLIGHT_SH_HAS_TWILIGHT

    // The share of the horizon's light that a sun below it leaves; 1 above the horizon.
    static Real FadeOf(float sun)
    {
        // The horizon in two parts, since the first may exceed it.
        Real depth = ((sun - Horizon) - HorizonRest) / Depth;
        return Fade(Math.Min(Math.Max(depth, 0), 1));
    }
#endif
}

using System;

public static partial class SkylightSh
{
    /// <summary>Multiplies weights by an exposure, in place.</summary>
    public static void Expose(float exposure, Span<float> weights)
    {
        for (int i = 0; i < weights.Length; ++i) weights[i] *= exposure;
    }
#if SKYLIGHT_SH_TAKES_GROUND

    /// <summary>
    /// Adds an even ground of this albedo, one a channel, below the horizon, in place, before any window.
    /// </summary>
    /// <remarks>
    /// Its radiance is albedo E / pi, and E, the irradiance from the sky on it, a multiple of the weight l = 1, m = 0.
    /// </remarks>
    public static void Ground(ReadOnlySpan<float> albedo, Span<float> weights)
    {
        for (int channel = 0; channel < ChannelCount; ++channel)
        {
            Span<float> own = weights.Slice(channel * WeightCount, WeightCount);
            float radiance = albedo[channel] * Reflected * own[2];
            for (int l = 0; l < Bands; ++l) own[l * (l + 1)] += radiance * LowerHalf[l];
        }
    }
#endif
#if !SKYLIGHT_SH_IS_WINDOWED

    /// <summary>
    /// Tames the ringing of the horizon in the first bands, in place, by the zonal window sinc(pi l / bands) (Habel et
    /// al. 2008, eq. 5).
    /// </summary>
    public static void Window(int bands, Span<float> weights)
    {
        for (int l = 1; l < Math.Min(bands, Bands); ++l) ScaleZonal(weights, l, Sinc((float)l / bands));
    }
#endif
}
